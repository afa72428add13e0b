#include "synthesis/design/other_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "specs/hardware.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/loads/assess_loads.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/link_forces.hpp"
#include "synthesis/loads/plane_weight.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/loads/strength.hpp"
#include "synthesis/loads/top_over.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

constexpr double flat_widths[] = {6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100};
constexpr double flat_thicknesses[] = {2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40};
constexpr double dowel_diameters[] = {1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 30};

template <std::size_t size>
double next_of(const double (&sizes)[size], double value) {
  const auto* larger =
      std::find_if(std::begin(sizes), std::end(sizes), [&](double one) { return one > 1.05 * value; });
  return larger != std::end(sizes) ? *larger : 1.5 * value;
}

/// True if links of this section bear their stress and bars do not buckle.
bool bears(const Design& design, const OpeningInterval& openings, const LinkStyle& style) {
  Spec spec = spec_of(design);
  spec.links.style = style;
  const CopyingLinkage& linkage = design.linkage;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const double strength = design.material->strength;
  if (!(load_figures_over(spec, linkage, openings).stress_max <= strength)) return false;
  if (largest_push_in_bars(design, style) >
      buckling_load(style, *design.material, std::max(lengths.VA, lengths.VB)))
    return false;
  const auto stresses =
      LayeredErrorProfile(linkage.k(), linkage.grounding(), sag_conditions(spec, design.layers),
                          most_force_at_pen(*design.load))
          .stresses_over(lengths, openings, widest_hole(style, design.hardware, design.cutting));
  return !stresses || stresses->largest() <= strength;
}

}  // namespace

double next_width(double width) { return next_of(flat_widths, width); }
double next_thickness(double thickness) { return next_of(flat_thicknesses, thickness); }
double next_pin_diameter(double diameter) { return next_of(dowel_diameters, diameter); }

std::string section_words(const LinkStyle& style) {
  return fmt::format("{:.4g} x {:.4g} mm", style.width, style.thickness);
}

bool keeps_the_rest(const Design& design, const LinkStyle& style, const JointHardware& hardware) {
  Spec spec = spec_of(design);
  spec.links.style = style;
  spec.links.hardware = hardware;
  spec.pole.place = design.linkage.pole();  // a given mechanism's spec has no other
  Requirements limits = requirements_of(spec);
  limits.load_error = limits.sag = limits.copy_error = std::nullopt;
  const DesignCheck check = check_design(spec, limits, design.linkage, design.layers);
  return check.feasible &&
         (!has_obstructions(map_task(design)) || check_obstacles(spec, limits, design.linkage, design.layers,
                                                                 check.opening, {}, SmallestGap::as_limit)
                                                     .clear);
}

double largest_push_in_bars(const Design& design, const LinkStyle& style) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.load || !openings) return 0;
  const CopyingLinkage& linkage = design.linkage;
  const PlaneWeight weight(linkage.k(), linkage.grounding(), style, design.material.value_or(Material{}),
                           design.load->tilt);
  const double force = most_force_at_pen(*design.load);
  const auto push = [&](double opening) {
    const PinForces forces = force * pin_forces(linkage.k(), linkage.grounding(), opening) +
                             weight.pin_forces({linkage.VA(), linkage.VB()}, opening);
    return std::max(forces.A, forces.B);
  };
  return push(top_over(*openings, push));
}

std::optional<LinkStyle> section_that_bears(const Design& design) {
  constexpr int sizes = 6;
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.load || !design.material || !openings || bears(design, *openings, design.style))
    return std::nullopt;
  std::optional<LinkStyle> smallest;
  const auto look = [&](double LinkStyle::*side, double (*next)(double)) {
    LinkStyle style = design.style;
    for (int i = 0; i < sizes; ++i) {
      style.*side = next(style.*side);
      if (smallest && style.width * style.thickness >= smallest->width * smallest->thickness) return;
      if (!bears(design, *openings, style)) continue;
      smallest = style;
      return;
    }
  };
  look(&LinkStyle::width, next_width);
  look(&LinkStyle::thickness, next_thickness);
  return smallest;
}

}  // namespace kempe
