#include "reports/drawings/making_notes.hpp"

#include <fmt/format.h>

#include <array>

#include "reports/drawings/hardware_faults.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/mounting_words.hpp"
#include "reports/drawings/overload_words.hpp"
#include "reports/drawings/spacers.hpp"
#include "specs/hardware.hpp"

namespace kempe {

std::vector<std::string> making_notes(const Design& design) {
  std::vector<std::string> notes = overload_words(design);
  if (auto words = large_bending_words(design)) notes.push_back(*std::move(words));
  for (std::string& note : part_notes(design)) notes.push_back(std::move(note));
  return notes;
}

std::vector<std::string> part_notes(const Design& design) {
  std::vector<std::string> notes;
  for (std::string& fault : hardware_faults(design)) notes.push_back(std::move(fault));
  for (std::string& words : mounting_words(design)) notes.push_back(std::move(words));
  const LinkStyle& style = design.style;
  std::array<double, 6> pins{};
  std::string thinner;  // joints
  bool on_pins = false;
  for (std::size_t i = 0; i < all_joints.size(); ++i) {
    pins[i] = pin_at(style, design.hardware, all_joints[i]);
    on_pins = on_pins || bored_for(style, design.hardware, all_joints[i]) == pins[i];
    if (pins[i] < style.pin_diameter) thinner += fmt::format(" {}", letter(all_joints[i]));
  }
  if (on_pins && design.cutting.hole_fit == 0)
    notes.push_back(
        fmt::format("holes are as wide as their pins, {} mm: cutting.process or cutting.hole_fit_mm gives "
                    "them room to turn",
                    by_joint(pins, [](double pin) { return fmt::format("{:.9g}", pin); })));
  if (design.hardware.differs())
    notes.push_back(
        fmt::format("hardware differs from joint to joint: contact takes every pin for one of {:.9g} mm{}, "
                    "joints stand as far apart as "
                    "holes of {:.6g} mm need; no bound is proven then",
                    style.pin_diameter, thinner.empty() ? "" : " (thinner:" + thinner + ")",
                    widest_hole(style, design.hardware, design.cutting)));
  for (const std::vector<Spacer>& spacers : spacers_of(design, joint_stacks(design)))
    for (const Spacer& spacer : spacers)
      if (const std::string words = words_on(spacer); !words.empty())
        notes.push_back(spacer.name + ": " + words);
  return notes;
}

}  // namespace kempe
