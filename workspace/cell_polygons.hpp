#pragma once
// Sets of cells of the two angles as polygons of the tracer's plane, bounded by true arcs about the pole.

#include "geometry/arc_polygon.hpp"
#include "workspace/grid_outline.hpp"

namespace kempe {

/// The polygons of an outline, one for each connected set, table frame. Arcs span half a turn at most.
ArcRegion polygons_of(const AngleGrid& grid, const GridOutline& outline);

/// The same for a set of cells.
ArcRegion polygons_of(const AngleGrid& grid, const std::vector<GridCell>& cells, Corners corners);

}  // namespace kempe
