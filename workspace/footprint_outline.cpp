#include "workspace/footprint_outline.hpp"

#include <algorithm>
#include <cmath>

#include "workspace/grid_outline.hpp"

namespace kempe {
namespace {

/// A ring of the grid's outline in the plane. Outer arcs are drawn outside their circle, so that chords do
/// not cut in.
Ring in_the_plane(const GridRing& ring, int bins, double step, const Point& pole, std::int64_t unit_x) {
  constexpr int chord_bins = 16;
  const double bin = 2 * pi / bins;
  Ring result;
  for (std::size_t i = 0; i < ring.corners.size(); ++i) {
    const GridPoint from = ring.corners[i], to = ring.corners[(i + 1) % ring.corners.size()];
    const double first = static_cast<double>(from.x) / static_cast<double>(unit_x);
    double past = static_cast<double>(to.x) / static_cast<double>(unit_x);
    if (i + 1 == ring.corners.size()) past += ring.winding * bins;
    const double radius = static_cast<double>(from.y) / 16.0 * step;
    const double outward = past < first ? 1 / std::cos(0.5 * chord_bins * bin) : 1;
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(past - first) / chord_bins)));
    for (int j = 0; j < pieces; ++j) {
      const double angle = (first + (past - first) * j / pieces) * bin;
      result.push_back(pole + outward * radius * Point(std::cos(angle), std::sin(angle)));
    }
  }
  std::reverse(result.begin(), result.end());  // bearing and distance make a left-handed frame
  return result;
}

}  // namespace

Region outline_in_the_plane(const sweep::PolarBins& filled, const Point& pole) {
  const std::int64_t unit_x = static_cast<std::int64_t>(AngleGrid::turn) / filled.bins();
  std::vector<GridCell> cells;
  for (int ring = 0; ring < filled.rings(); ++ring)
    for (const auto& [from, to] : filled.runs(ring))
      cells.push_back({static_cast<std::uint32_t>(from * unit_x), static_cast<std::uint32_t>(ring * 16),
                       static_cast<std::uint32_t>((to - from) * unit_x), 16});
  const GridOutline outline = outline_of(cells, Corners::join);
  std::vector<std::pair<std::size_t, Polygon>> parts;
  for (const bool holes : {false, true})
    for (const GridRing& ring : outline.rings) {
      Ring points = in_the_plane(ring, filled.bins(), filled.step(), pole, unit_x);
      if (signed_area(points) == 0 || (signed_area(points) < 0) != holes) continue;  // 0: the pole itself
      if (!holes)
        parts.push_back({ring.component, {std::move(points), {}}});
      else
        for (auto& [component, polygon] : parts)
          if (component == ring.component) polygon.holes.push_back(points);
    }
  Region region;
  for (auto& part : parts) region.polygons.push_back(std::move(part.second));
  return region;
}

}  // namespace kempe
