#pragma once
// The error of a made and loaded instrument over the region, part by part: darker is more, contours are circles about the pole.

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// Figures with their captions: tolerances, load, both together in the plane, and sag; those that are not 0. Empty without load figures.
std::string error_pictures(const Design& design);

}  // namespace kempe
