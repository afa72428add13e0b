#pragma once
// A polygon as convex parts whose union it is.

#include <vector>

#include "geometry/region.hpp"

namespace kempe {

using ConvexPart = std::vector<Complex>;

/// Of an anticlockwise ring; corners within straight edges do no harm.
bool is_convex(const Ring& ring);

/// The polygon itself if it is convex, else triangles joined as long as they stay convex. Guarantees:
///  1. the corners are the polygon's own, so nothing is rounded: the union is the polygon, and no part reaches outside;
///  2. parts run anticlockwise, have an area, and overlap at most in edges;
///  3. they are at most one more than twice the reflex corners;
///  4. all this holds wherever a ring begins, with corners within straight edges, and where rings touch in a corner.
std::vector<ConvexPart> convex_parts(const Polygon& polygon);

}  // namespace kempe
