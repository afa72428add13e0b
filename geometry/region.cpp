#include "geometry/region.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

/// Calls `visit` with the two ends of each edge.
template <typename Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0, previous = ring.size() - 1; i < ring.size(); previous = i++) {
    visit(ring[previous], ring[i]);
  }
}

template <typename Visit>
void for_each_ring(const Polygon& polygon, Visit visit) {
  visit(polygon.outer);
  for (const Ring& hole : polygon.holes) visit(hole);
}

enum class Side { outside, boundary, inside };

/// What one edge does to the ray from `point` towards +x: crosses it, passes, or goes through the point
/// itself.
struct Crossing {
  bool crosses, touches;
};
Crossing crossing(const Point& from, const Point& to, const Point& point) {
  // The edge is taken from its lower end, so that two polygons with a common edge judge it alike.
  const bool upward = from.y() < to.y() || (from.y() == to.y() && from.x() < to.x());
  const Point& low = upward ? from : to;
  const Point& high = upward ? to : from;
  if (point.y() < low.y() || point.y() > high.y()) return {false, false};
  const double turn = cross(high - low, point - low);
  if (turn == 0 && std::min(low.x(), high.x()) <= point.x() && point.x() <= std::max(low.x(), high.x())) {
    return {false, true};
  }
  return {point.y() < high.y() && turn > 0, false};
}

Side side_of(const Polygon& polygon, const Point& point) {
  bool odd = false, touches = false;
  for_each_ring(polygon, [&](const Ring& ring) {
    for_each_edge(ring, [&](const Point& from, const Point& to) {
      const Crossing at = crossing(from, to, point);
      odd ^= at.crosses;
      touches |= at.touches;
    });
  });
  if (touches) return Side::boundary;
  return odd ? Side::inside : Side::outside;
}

double squared_distance_to_box(const Box& box, const Point& point) {
  const Point outside = (box.lower - point).cwiseMax(point - box.upper).cwiseMax(0.0);
  return outside.squaredNorm();
}

Box box_of(const Ring& ring) {
  Box box{Point::Constant(infinity), Point::Constant(-infinity)};
  for (const Point& corner : ring) {
    box.lower = box.lower.cwiseMin(corner);
    box.upper = box.upper.cwiseMax(corner);
  }
  return box;
}

double squared_distance_to_rings(const Polygon& polygon, const Point& point, double best) {
  for_each_ring(polygon, [&](const Ring& ring) {
    if (squared_distance_to_box(box_of(ring), point) >= best) return;
    for_each_edge(ring, [&](const Point& from, const Point& to) {
      best = std::min(best, squared_distance(point, from, to));
    });
  });
  return best;
}

Ring image(const Ring& ring, Complex k, const Point& pole) {
  Ring result;
  result.reserve(ring.size());
  for (const Point& corner : ring) result.push_back(pole + as_point(k * as_complex(corner - pole)));
  return result;
}

/// What a circle's polygon has.
constexpr int circle_corners = 1440;

}  // namespace

Region Region::rectangle(const Point& lower_left, const Point& size) {
  const Point corner = lower_left + size;
  return {{{{lower_left, {corner.x(), lower_left.y()}, corner, {lower_left.x(), corner.y()}}, {}}}};
}

Region Region::circle(const Point& centre, double radius) {
  const double reach = radius / std::cos(pi / circle_corners);
  Ring ring;
  for (int i = 0; i < circle_corners; ++i)
    ring.push_back(centre + as_point(std::polar(reach, 2 * pi * i / circle_corners)));
  return {{{std::move(ring), {}}}};
}

Region Region::polygon(Ring outer, std::vector<Ring> holes) {
  return {{{std::move(outer), std::move(holes)}}};
}

double signed_area(const Ring& ring) {
  if (ring.empty()) return 0;
  // Relative to a corner: far from the origin the products would cancel.
  const Point& origin = ring.front();
  double doubled = 0;
  for_each_edge(ring,
                [&](const Point& from, const Point& to) { doubled += cross(from - origin, to - origin); });
  return 0.5 * doubled;
}

double area(const Region& region) {
  double sum = 0;
  for (const Polygon& polygon : region.polygons) {
    for_each_ring(polygon, [&](const Ring& ring) { sum += signed_area(ring); });
  }
  return sum;
}

Ring thinned(const Ring& ring, double detail) {
  Ring kept;
  for (const Point& corner : ring)
    if (kept.empty() || (corner - kept.back()).norm() >= detail) kept.push_back(corner);
  return kept;
}

Box bounding_box(const Region& region) {
  Box box{Point::Constant(infinity), Point::Constant(-infinity)};
  for (const Polygon& polygon : region.polygons) {
    const Box own = box_of(polygon.outer);
    box.lower = box.lower.cwiseMin(own.lower);
    box.upper = box.upper.cwiseMax(own.upper);
  }
  return box;
}

double grid_step(const Region& region, double places) {
  constexpr double most = 100'000;
  const Box box = bounding_box(region);
  const Point size = box.upper - box.lower;
  return std::max({std::sqrt(std::max(0.0, area(region)) / places), std::sqrt(size.x() * size.y() / most),
                   size.maxCoeff() / most});
}

bool contains(const Region& region, const Point& point) {
  return std::any_of(region.polygons.begin(), region.polygons.end(), [&](const Polygon& polygon) {
    return squared_distance_to_box(box_of(polygon.outer), point) == 0 &&
           side_of(polygon, point) != Side::outside;
  });
}

double distance(const Region& region, const Point& point) {
  if (contains(region, point)) return 0;
  double best = infinity;
  for (const Polygon& polygon : region.polygons) best = squared_distance_to_rings(polygon, point, best);
  return std::sqrt(best);
}

DistanceRange distance_range(const Region& region, const Point& centre) {
  double farthest2 = 0;
  for (const Polygon& polygon : region.polygons) {
    for (const Point& corner : polygon.outer)
      farthest2 = std::max(farthest2, (corner - centre).squaredNorm());
  }
  return {distance(region, centre), std::sqrt(farthest2)};
}

Region similar_image(const Region& region, Complex k, const Point& pole) {
  Region result;
  result.polygons.reserve(region.polygons.size());
  for (const Polygon& polygon : region.polygons) {
    Polygon& copy = result.polygons.emplace_back();
    copy.outer = image(polygon.outer, k, pole);
    for (const Ring& hole : polygon.holes) copy.holes.push_back(image(hole, k, pole));
  }
  return result;
}

}  // namespace kempe
