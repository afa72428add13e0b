#pragma once
// The outline of a set of grid cells: shared sides cancel, what is left is chained.

#include <vector>

#include "workspace/angle_grid.hpp"

namespace kempe {

/// A corner of an outline in grid units. Across a full turn x goes on counting, so that neighbours tell the
/// way between.
struct GridPoint {
  std::int64_t x, y;
  bool operator==(const GridPoint&) const = default;
};

/// A closed chain of horizontal and vertical sides with the set on its left (x to the right, y upwards). A
/// ring around the pole ends a whole turn from where it starts: `winding` is -1, 0 or 1 turns.
struct GridRing {
  std::vector<GridPoint> corners;
  int winding = 0;
  std::size_t component = 0;  ///< rings of one connected set share it
};

/// What happens where two cells of the set touch at a corner only.
enum class Corners {
  part,  ///< they stay apart: the corners of both are cut off by one unit. For sets that must not be larger.
  join   ///< they are joined by a square of two units. For sets that must not be smaller.
};

struct GridOutline {
  std::vector<GridRing> rings;            ///< none touches itself or another ring
  std::vector<std::size_t> component_of;  ///< of each cell: connected through sides (and joined corners)
};

/// The outline of disjoint cells, periodic in x with AngleGrid::turn; O(n log n).
GridOutline outline_of(const std::vector<GridCell>& cells, Corners corners);

}  // namespace kempe
