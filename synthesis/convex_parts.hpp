#pragma once
// A polygon as convex parts whose union it is.

#include <vector>

#include "specs/region.hpp"

namespace kempe {

using ConvexPart = std::vector<Complex>;

/// The polygon itself if it is convex; else triangles (ear clipping) if it has no holes, and trapezoids between its corners'
/// heights if it has. Anticlockwise; parts overlap at most in edges. O(n^2).
std::vector<ConvexPart> convex_parts(const Polygon& polygon);

}  // namespace kempe
