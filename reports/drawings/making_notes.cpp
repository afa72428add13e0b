#include "reports/drawings/making_notes.hpp"

#include <fmt/format.h>

#include "reports/drawings/joint_stack.hpp"
#include "specs/hardware.hpp"

namespace kempe {

std::vector<std::string> making_notes(const Design& design) {
  std::vector<std::string> notes;
  const bool on_pins = bored_for(design.style, design.hardware) == design.style.pin_diameter;
  if (on_pins && design.cutting.hole_fit == 0)
    notes.push_back(fmt::format(
        "holes are drawn as wide as their pins, {} mm: cutting.process or cutting.hole_fit_mm gives "
        "them the fit to turn in",
        design.style.pin_diameter));
  for (std::string& fault : hardware_faults(design)) notes.push_back(std::move(fault));
  return notes;
}

}  // namespace kempe
