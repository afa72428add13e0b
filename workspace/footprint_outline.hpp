#pragma once
// Filled bins about the pole as a region of the plane.

#include "geometry/region.hpp"
#include "workspace/sweep/polar_bins.hpp"

namespace kempe {

/// Contains all that is filled. Outer rings run counter-clockwise, with the holes of the same component.
Region outline_in_the_plane(const sweep::PolarBins& filled, const Point& pole);

}  // namespace kempe
