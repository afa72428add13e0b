#pragma once
// What rings enclose, as triangles of their own corners.

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/region.hpp"

namespace kempe {

struct Triangulation {
  std::vector<Point> corners;
  std::vector<std::array<std::size_t, 3>> triangles;  ///< places in `corners`, anticlockwise
};

/// The points that are inside an odd number of rings. Guarantees:
///  1. the corners are the rings' own, none twice; only where rings cross does the rounded crossing join them;
///  2. every triangle has an area, however small, and no corner inside it or within one of its edges;
///  3. two triangles share an edge, a corner or nothing.
/// All decisions are exact, so there is no tolerance: collinear corners, needles and rings that touch in a corner are nothing
/// special. Edges must not lie on each other.
Triangulation triangulated(const std::vector<Ring>& rings);

}  // namespace kempe
