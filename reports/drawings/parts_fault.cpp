#include "reports/drawings/parts_fault.hpp"

#include <fmt/format.h>

#include <functional>

#include "reports/drawings/part_drawings.hpp"
#include "specs/hardware.hpp"

namespace kempe {
namespace {

std::optional<PartsFault> no_hole(double hole, double pin, const CuttingSpec& cutting) {
  if (hole <= 0)
    return PartsFault{
        "the fit leaves nothing of their holes",
        fmt::format(
            "a fit of {:.6g} mm (cutting.hole_fit_mm) leaves nothing of the holes for pins of {:.6g} mm",
            cutting.hole_fit, pin)};
  if (hole - cutting.kerf > least_wall_share * hole) return std::nullopt;
  return PartsFault{"the kerf is wider than their holes",
                    fmt::format("a kerf of {:.6g} mm (cutting.kerf_mm) is too wide to cut holes of {:.6g} mm",
                                cutting.kerf, hole)};
}

std::optional<PartsFault> no_wall_beside(double hole, double width) {
  if (0.5 * (width - hole) > least_wall_share * hole) return std::nullopt;
  return PartsFault{"their holes are as wide as the links",
                    fmt::format("holes of {:.6g} mm leave no wall in links {:.6g} mm wide; thinner pins "
                                "(links.pin_diameter_mm) or wider links would do",
                                hole, width)};
}

/// `hole_at`: of a joint, kerf apart, mm.
std::optional<PartsFault> no_wall_between(const CutPart& part, const std::function<double(Joint)>& hole_at) {
  for (std::size_t i = 0; i < part.holes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = (part.holes[i].centre - part.holes[j].centre).norm();
      const double one = hole_at(part.holes[j].joint), other = hole_at(part.holes[i].joint);
      const double holes = 0.5 * (one + other);
      if (apart - holes > least_wall_share * holes) continue;
      const std::string wide =
          one == other ? fmt::format("{:.6g}", one) : fmt::format("{:.6g} and {:.6g}", one, other);
      return PartsFault{
          "their holes run into each other",
          fmt::format("link {} has its holes {} and {}, {} mm wide, {:.6g} mm apart, which leaves no "
                      "wall between them; thinner pins (links.pin_diameter_mm) or longer links would do",
                      part.name, letter(part.holes[j].joint), letter(part.holes[i].joint), wide, apart)};
    }
  return std::nullopt;
}

}  // namespace

std::optional<PartsFault> parts_fault(const Design& design, const CuttingSpec& cutting) {
  const auto hole_at = [&](Joint joint) {
    return hole_diameter(design.style, design.hardware, joint, cutting);
  };
  for (const Joint joint : all_joints)
    if (auto fault = no_hole(hole_at(joint), pin_at(design.style, design.hardware, joint), cutting))
      return fault;
  if (auto fault = no_wall_beside(widest_hole(design.style, design.hardware, cutting), design.style.width))
    return fault;
  for (const CutPart& part : cut_parts(design, cutting))
    if (auto fault = no_wall_between(part, hole_at)) return fault;
  return std::nullopt;
}

}  // namespace kempe
