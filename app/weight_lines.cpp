#include "app/weight_lines.hpp"

#include <fmt/format.h>

#include "synthesis/loads/feel.hpp"
#include "workspace/reach.hpp"

namespace kempe::app {
namespace {

std::string sag_line(const Design& design) {
  if (!design.quality.sag) return "";
  const bool plays = design.tolerance && design.tolerance->play > 0;
  return fmt::format("sag          {:.4g} mm at most at tracer and pen, by weight{}\n", *design.quality.sag,
                     plays ? " and play" : "");
}

std::string balance_lines(const Feel& feel, double tilt) {
  std::string text =
      fmt::format("weight       the hand holds up to {:.3g} N on the table tilted by {:.4g} degrees\n",
                  feel.weight_most, degrees(tilt));
  text += "balance      " + words(feel.counterweights[0]) + "\n             " +
          words(feel.counterweights[1]) + "\n";
  if (feel.springs)
    text +=
        "  or springs " + words((*feel.springs)[0]) + "\n             " + words((*feel.springs)[1]) + "\n";
  return text;
}

}  // namespace

std::string weight_lines(const Design& design) {
  std::string text = sag_line(design);
  if (!design.material || !design.load) return text;
  const auto openings = openings_over(design.linkage, design.region);
  if (!openings) return text;
  const Feel feel =
      feel_over(design.linkage, design.style, design.hardware, *design.material, *design.load, *openings);
  text += fmt::format(
      "feel         {:.3g} to {:.3g} kg at the tracer, friction adds up to {:.2g} % to the work\n",
      feel.mass_least, feel.mass_most, 100 * feel.friction_share);
  return design.load->tilt > 0 ? text + balance_lines(feel, design.load->tilt) : text;
}

}  // namespace kempe::app
