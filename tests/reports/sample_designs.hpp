#pragma once
// Designs for the tests of what the program writes: made directly, without a search.

#include <algorithm>
#include <cmath>

#include "synthesis/design/design.hpp"

namespace kempe::testing {

inline Design sample_design(Complex k, Grounding grounding, double VA, double VB, int assembly_mode,
                            PlateStyle plate = PlateStyle::bent, Point pole = Point::Zero()) {
  Design design{.linkage = *CopyingLinkage::make(k, grounding, VA, VB, assembly_mode, pole)};
  design.scale = std::abs(k);
  design.rotation = std::arg(k);
  design.style = {.width = 12, .pin_diameter = 6, .thickness = 4, .plate = plate};
  design.opening = shrink(design.linkage.assembly_mode().openings,
                          std::min(radians(20), 0.25 * design.linkage.assembly_mode().openings.width()));
  design.quality.size = design.linkage.size();
  design.quality.transmission_min = radians(20);
  design.quality.clearance_min = 1.25;
  const Point at = design.linkage.tracer_at(design.opening.middle(), 0.3);
  const double half = 2;
  design.region = {{Polygon{
      {at + Point(-half, -half), at + Point(half, -half), at + Point(half, half), at + Point(-half, half)},
      {{at + Point(-1, -1), at + Point(-1, 1), at + Point(1, 1), at + Point(1, -1)}}}}};
  design.map.certified_opening = design.opening;
  design.map.coverage.covered = true;
  design.verification = {.samples = 100, .scale = design.scale, .rotation = design.rotation, .holds = true};
  design.search = SearchRecord{.objective = Objective::size,
                               .value = design.linkage.size(),
                               .solvers = {"NLopt 2.7.1"},
                               .evaluations = 12,
                               .seed = 7};
  return design;
}

/// The report's plagiograph in mm: k = 1.4i, VA = 50, VB = 35.
inline Design plagiograph() {
  return sample_design(copy_ratio(1.4, radians(90)), Grounding::pole, 50, 35, 3);
}

}  // namespace kempe::testing
