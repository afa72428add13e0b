#pragma once
// The load error over the region as a picture: darker is softer, contours are circles about the pole.

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A figure with its caption; empty without load figures.
std::string load_picture(const Design& design);

}  // namespace kempe
