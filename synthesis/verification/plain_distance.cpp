#include "synthesis/verification/plain_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kempe::plain {

double nearest_share(const Point& point, const Point& from, const Point& along) {
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0;
}

namespace {

double distance(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  return (from + nearest_share(point, from, along) * along - point).norm();
}

/// On which side of the line through a and b the point lies.
int side(const Point& a, const Point& b, const Point& point) {
  const double area = cross(b - a, point - a);
  return (area > 0) - (area < 0);
}

std::size_t edges_of(const Corners& corners) { return corners.size() > 2 ? corners.size() : 1; }

Box extent_of(const Corners& corners) {
  Box extent{corners.front(), corners.front()};
  for (const Point& corner : corners) extent = {extent.lower.cwiseMin(corner), extent.upper.cwiseMax(corner)};
  return extent;
}

}  // namespace

Corners corners_of(const JointHull& hull, const Pose& pose) {
  Corners corners;
  for (int i = 0; i < hull.count; ++i) corners.push_back(pose[hull.joints[static_cast<std::size_t>(i)]]);
  return corners;
}

double distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

double distance_of_edges(const Corners& one, const Corners& other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges_of(one); ++i)
    for (std::size_t j = 0; j < edges_of(other); ++j)
      least = std::min(least,
                       distance(one[i], one[(i + 1) % one.size()], other[j], other[(j + 1) % other.size()]));
  return least;
}

bool holds(const Corners& polygon, const Point& point) {
  bool within = false;
  for (std::size_t i = 0; polygon.size() > 2 && i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) within = !within;
  }
  return within;
}

double distance(const Corners& one, const Corners& other) {
  if (holds(one, other.front()) || holds(other, one.front())) return 0;
  return distance_of_edges(one, other);
}

double distance_of_boxes(const Corners& one, const Box& other) {
  const Box box = extent_of(one);
  return (box.lower - other.upper).cwiseMax(other.lower - box.upper).cwiseMax(0.0).norm();
}

double distance_of_boxes(const Corners& one, const Corners& other) {
  return distance_of_boxes(one, extent_of(other));
}

}  // namespace kempe::plain
