#include "geometry/convex_hull.hpp"

#include <algorithm>

#include "geometry/orientation.hpp"

namespace kempe {

std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), sweeps_before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point> hull(points.size() + 1);
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return orientation(a, b, c) > 0;
  };
  hull.resize(hull_of_sorted(points, hull, turns_left));
  return hull;
}

bool lies_within(const std::vector<Point>& polygon, const Point& place) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    if (cross(to - from, place - from) < 0) return false;
  }
  return true;
}

}  // namespace kempe
