// Along every ring, then over a hatch of the inside.

#include "synthesis/verification/stations.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

double perimeter(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return sum;
}

/// About `count` places along a ring, corners preferred; all corners if there are no more than `count`.
void follow_ring(const Ring& ring, const Point& pole, std::size_t count, std::vector<Point>& stations) {
  const std::size_t stride = std::max<std::size_t>(1, ring.size() / std::max<std::size_t>(1, count));
  const double spacing = perimeter(ring) / static_cast<double>(std::max<std::size_t>(1, count));
  for (std::size_t i = 0; i < ring.size(); i += stride) {
    const Point from = ring[i] - pole, to = ring[(i + 1) % ring.size()] - pole;
    stations.push_back(from);
    if (stride > 1) continue;
    const int pieces = static_cast<int>(std::min(1000.0, std::ceil((to - from).norm() / spacing)));
    for (int j = 1; j < pieces; ++j)
      stations.push_back(from + (to - from) * (static_cast<double>(j) / pieces));
  }
  stations.push_back(ring.front() - pole);
}

/// The corners nearest to and farthest from the pole, and the places of edges nearest to it: where limits bind.
void add_extremes(const Region& region, const Point& pole, std::vector<Point>& stations) {
  Point nearest = region.polygons.front().outer.front() - pole, farthest = nearest;
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i] - pole, along = ring[(i + 1) % ring.size()] - ring[i];
      const double share =
          along.squaredNorm() > 0 ? std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
      const Point foot = a + share * along;
      if (foot.norm() < nearest.norm()) nearest = foot;
      if (a.norm() > farthest.norm()) farthest = a;
    }
  };
  for (const Polygon& polygon : region.polygons) {
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
  }
  stations.push_back(nearest);
  stations.push_back(farthest);
}

/// Parameters in [0, 1] at which the line from `a` to `b` crosses the region's boundary, ascending.
std::vector<double> crossings(const Region& region, const Point& a, const Point& b) {
  std::vector<double> at;
  const Point along = b - a;
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& from = ring[i];
      const Point edge = ring[(i + 1) % ring.size()] - from;
      const double before = cross(along, from - a), after = cross(along, from + edge - a);
      if ((before < 0) == (after < 0)) continue;
      const Point meeting = from + edge * (before / (before - after));
      at.push_back((meeting - a).dot(along) / along.squaredNorm());
    }
  };
  for (const Polygon& polygon : region.polygons) {
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
  }
  std::sort(at.begin(), at.end());
  return at;
}

void hatch(const Region& region, const Point& pole, int lines, bool upright, std::vector<Point>& stations) {
  const Box box = bounding_box(region);
  const int along = upright ? 1 : 0, across = 1 - along;
  for (int i = 0; i < lines; ++i) {
    Point a = box.lower, b = box.upper;
    a[across] = b[across] = box.lower[across] + (box.upper[across] - box.lower[across]) * (i + 0.5) / lines;
    const auto at = crossings(region, a, b);
    for (std::size_t j = 0; j + 1 < at.size(); j += 2) {
      constexpr int pieces = 8;  // there and back alternately, so that the tracer draws a meander
      for (int n = 0; n <= pieces; ++n) {
        const double share = (i % 2 ? pieces - n : n) / static_cast<double>(pieces);
        stations.push_back(a - pole + (b - a) * (at[j] + (at[j + 1] - at[j]) * share));
      }
    }
  }
}

}  // namespace

std::vector<Point> stations_over(const Region& region, const Point& pole,
                                 const VerificationOptions& options) {
  std::vector<Point> stations;
  if (region.empty()) return stations;
  double total = 0;
  for (const Polygon& polygon : region.polygons) {
    total += perimeter(polygon.outer);
    for (const Ring& hole : polygon.holes) total += perimeter(hole);
  }
  const auto share = [&](const Ring& ring) {
    return 1 +
           static_cast<std::size_t>(static_cast<double>(options.outline_samples) * perimeter(ring) / total);
  };
  for (const Polygon& polygon : region.polygons) {
    follow_ring(polygon.outer, pole, share(polygon.outer), stations);
    for (const Ring& hole : polygon.holes) follow_ring(hole, pole, share(hole), stations);
  }
  add_extremes(region, pole, stations);
  hatch(region, pole, options.hatch_lines, false, stations);
  hatch(region, pole, options.hatch_lines, true, stations);
  return stations;
}

}  // namespace kempe
