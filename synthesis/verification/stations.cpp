// Along every ring, then over a hatch of the inside.

#include "synthesis/verification/stations.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/verification/plain_distance.hpp"

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
      const Point foot = a + plain::nearest_share(Point::Zero(), a, along) * along;
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

/// Parallel lines across the region, evenly spread.
class Hatch {
 public:
  Hatch(const Region& region, int lines, bool upright)
      : along_(upright ? 1 : 0), box_(bounding_box(region)), crossings_(static_cast<std::size_t>(lines)) {
    for (const Polygon& polygon : region.polygons) {
      look(polygon.outer);
      for (const Ring& hole : polygon.holes) look(hole);
    }
    for (std::vector<double>& at : crossings_) std::sort(at.begin(), at.end());
  }

  std::size_t lines() const { return crossings_.size(); }
  Point from(std::size_t line) const { return end(box_.lower, line); }
  Point to(std::size_t line) const { return end(box_.upper, line); }
  /// Parameters in [0, 1] at which a line crosses the region's boundary, ascending.
  const std::vector<double>& crossings(std::size_t line) const { return crossings_[line]; }

 private:
  double extent() const { return box_.upper[1 - along_] - box_.lower[1 - along_]; }

  Point end(Point corner, std::size_t line) const {
    corner[1 - along_] =
        box_.lower[1 - along_] + extent() * (static_cast<double>(line) + 0.5) / static_cast<double>(lines());
    return corner;
  }

  void look(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) look(ring[i], ring[(i + 1) % ring.size()]);
  }

  /// At the lines that the edge comes to, and one more on either side for the sake of rounding.
  void look(const Point& from, const Point& to) {
    const auto line_at = [&](double place) {
      const double share = extent() > 0 ? (place - box_.lower[1 - along_]) / extent() : 0;
      return share * static_cast<double>(lines()) - 0.5;
    };
    const double one = line_at(from[1 - along_]), other = line_at(to[1 - along_]);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(std::min(one, other)) - 1));
    const auto last = static_cast<std::size_t>(std::max(0.0, std::ceil(std::max(one, other)) + 1));
    for (std::size_t line = first; line <= last && line < lines(); ++line) cross_line(line, from, to);
  }

  void cross_line(std::size_t line, const Point& from, const Point& to) {
    const Point a = this->from(line), along = this->to(line) - a, edge = to - from;
    const double before = cross(along, from - a), after = cross(along, from + edge - a);
    if ((before < 0) == (after < 0)) return;
    const Point meeting = from + edge * (before / (before - after));
    crossings_[line].push_back((meeting - a).dot(along) / along.squaredNorm());
  }

  int along_;
  Box box_;
  std::vector<std::vector<double>> crossings_;
};

void hatch(const Region& region, const Point& pole, int lines, bool upright, std::vector<Point>& stations) {
  const Hatch all(region, lines, upright);
  for (std::size_t i = 0; i < all.lines(); ++i) {
    const Point a = all.from(i), b = all.to(i);
    const std::vector<double>& at = all.crossings(i);
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
