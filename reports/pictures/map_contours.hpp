#pragma once
// Contours of what depends on the opening alone: circles about the pole.

#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// On this circle about the pole a quantity has one value.
struct ContourCircle {
  double level;
  double radius;  ///< mm
};

/// The least difference between the levels of neighbouring circles; 0 where they have one level.
double step_of_levels(const std::vector<ContourCircle>& circles);
/// A circle's level in mm, of those a step apart: "0.05 mm".
std::string level_text(const ContourCircle& circle, double step, int decimals);

/// Where the transmission angle is 10, 20 ... 80 degrees (level in rad); two circles a level.
std::vector<ContourCircle> transmission_circles(const CopyingLinkage& linkage);

/// Where the worst copy error under the design's tolerance is a round number of mm: about six levels of what the
/// certified openings have, circles all over the assembly. Empty without tolerance.
std::vector<ContourCircle> copy_error_circles(const Design& design);

/// Where the load error under the design's load is a round number of mm, likewise. Empty without load.
std::vector<ContourCircle> load_error_circles(const Design& design);

}  // namespace kempe
