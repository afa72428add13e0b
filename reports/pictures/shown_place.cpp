#include "reports/pictures/shown_place.hpp"

#include <optional>
#include <vector>

#include "geometry/region.hpp"
#include "synthesis/design/assemble.hpp"

namespace kempe {
namespace {

Point centroid(const Ring& ring) {
  double doubled = 0;
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    doubled += cross(a, b);
    sum += cross(a, b) * (a + b);
  }
  return doubled == 0 ? ring[0] : Point(ring[0] + sum / (3 * doubled));
}

/// Some place of the free workspace, the middle of its openings preferred; nothing if none is met.
std::optional<Point> free_place(const Design& design) {
  constexpr int bearings = 72;
  const MapTask task = map_task(design);
  for (const double share : {0.5, 0.3, 0.7, 0.1, 0.9})
    for (int i = 0; i < bearings && !design.opening.empty(); ++i) {
      const double opening = design.opening.lower + share * design.opening.width();
      const Point at = design.linkage.tracer_at(opening, 2 * pi * i / bearings);
      if (verdict_at(task, at).free) return at;
    }
  return std::nullopt;
}

}  // namespace

Point place_to_show(const Design& design) {
  const CopyingLinkage& linkage = design.linkage;
  if (design.region.empty())
    if (const auto place = free_place(design)) return *place;
  const auto good = [&](const Point& at) {
    const auto opening = linkage.opening_at((at - linkage.pole()).norm());
    return opening && (design.opening.empty() || design.opening.contains(*opening));
  };
  std::vector<Point> candidates;
  for (const Polygon& polygon : design.region.polygons) {
    const Point middle = centroid(polygon.outer);
    if (contains(design.region, middle)) candidates.push_back(middle);
  }
  for (const Polygon& polygon : design.region.polygons)
    candidates.insert(candidates.end(), polygon.outer.begin(), polygon.outer.end());
  for (const Point& at : candidates)
    if (good(at)) return at;
  return linkage.tracer_at(openings_to_show(design).middle(), 0);
}

}  // namespace kempe
