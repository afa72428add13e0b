#pragma once
// A polygon as convex parts whose union it is.

#include <vector>

#include "specs/region.hpp"

namespace kempe {

using ConvexPart = std::vector<Complex>;

/// The polygon itself if it is convex and has no holes, else triangles (holes joined to the outer ring by a cut, then ear
/// clipping). Parts overlap at most in edges. O(n^2).
std::vector<ConvexPart> convex_parts(const Polygon& polygon);

}  // namespace kempe
