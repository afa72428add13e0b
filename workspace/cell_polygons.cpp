#include "workspace/cell_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace kempe {
namespace {

std::int64_t within_turn(std::int64_t x) { return x & (static_cast<std::int64_t>(AngleGrid::turn) - 1); }

Point place(const AngleGrid& grid, double radius, std::int64_t x) {
  return grid.linkage().pole() +
         as_point(std::polar(radius, AngleGrid::bearing(static_cast<double>(within_turn(x)))));
}

/// Appends the side from `from` to `to`, its start included: an arc in parts of half a turn at most, or a
/// segment.
void add_side(ArcRing& ring, const AngleGrid& grid, const GridPoint& from, const GridPoint& to) {
  const double radius = grid.radius(static_cast<double>(from.y));
  if (from.y != to.y) {
    ring.push_back({place(grid, radius, from.x), 0});
    return;
  }
  const std::int64_t sweep = to.x - from.x, half = AngleGrid::turn / 2;
  const std::int64_t parts = std::max<std::int64_t>(1, (std::abs(sweep) + half - 1) / half);
  const double bulge =
      std::tan(0.25 * AngleGrid::bearing(static_cast<double>(sweep) / static_cast<double>(parts)));
  for (std::int64_t i = 0; i < parts; ++i)
    ring.push_back({place(grid, radius, from.x + sweep * i / parts), bulge});
}

ArcRing plane_ring(const AngleGrid& grid, const GridRing& ring) {
  ArcRing result;
  result.reserve(ring.corners.size());
  for (std::size_t i = 0; i + 1 < ring.corners.size(); ++i)
    add_side(result, grid, ring.corners[i], ring.corners[i + 1]);
  GridPoint closing = ring.corners.front();
  closing.x += ring.winding * static_cast<std::int64_t>(AngleGrid::turn);
  add_side(result, grid, ring.corners.back(), closing);
  // Bearing to the right and distance upwards is a left-handed frame: rings turn over unless distance falls
  // upwards.
  return grid.radius(AngleGrid::rise) > grid.radius(0) ? reversed(result) : result;
}

}  // namespace

ArcRegion polygons_of(const AngleGrid& grid, const GridOutline& outline) {
  std::map<std::size_t, ArcPolygon> by_component;
  for (const GridRing& ring : outline.rings) {
    ArcRing mapped = plane_ring(grid, ring);
    const double enclosed = signed_area(mapped);
    if (enclosed > 0)
      by_component[ring.component].outer = std::move(mapped);
    else if (enclosed < 0)
      by_component[ring.component].holes.push_back(std::move(mapped));
  }
  ArcRegion region;
  for (auto& [component, polygon] : by_component)
    if (!polygon.outer.empty()) region.push_back(std::move(polygon));
  return region;
}

ArcRegion polygons_of(const AngleGrid& grid, const std::vector<GridCell>& cells, Corners corners) {
  return polygons_of(grid, outline_of(cells, corners));
}

}  // namespace kempe
