#pragma once
// Distances between points, segments and hulls of at most three points: the innermost work of every contact
// test.

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/point.hpp"

namespace kempe {

/// The place nearest to `point` on the segment a-b, as a share of the way from a to b.
inline double nearest_share(const Point& point, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0;
}

/// That place; the end itself where it is an end.
inline Point nearest_on_segment(const Point& point, const Point& a, const Point& b) {
  const double share = nearest_share(point, a, b);
  return share < 1 ? Point(a + share * (b - a)) : b;
}

inline double squared_distance(const Point& point, const Point& a, const Point& b) {
  return (nearest_on_segment(point, a, b) - point).squaredNorm();
}

inline double distance(const Point& point, const Point& a, const Point& b) {
  return std::sqrt(squared_distance(point, a, b));
}

/// True if the segments a-b and c-d cross at an inner point of both.
inline bool properly_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point ab = b - a, cd = d - c;
  return cross(ab, c - a) * cross(ab, d - a) < 0 && cross(cd, a - c) * cross(cd, b - c) < 0;
}

inline double squared_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (properly_cross(a, b, c, d)) return 0;
  return std::min(std::min(squared_distance(a, c, d), squared_distance(b, c, d)),
                  std::min(squared_distance(c, a, b), squared_distance(d, a, b)));
}

/// The hull of one, two or three points.
struct Hull {
  std::array<Point, 3> at;
  int count;
};

/// True if the point lies strictly inside the triangle of a hull of three points.
inline bool inside(const Hull& hull, const Point& point) {
  if (hull.count < 3) return false;
  const double a = cross(hull.at[1] - hull.at[0], point - hull.at[0]);
  const double b = cross(hull.at[2] - hull.at[1], point - hull.at[1]);
  const double c = cross(hull.at[0] - hull.at[2], point - hull.at[2]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

/// Distance between two hulls, 0 where they overlap.
inline double distance(const Hull& one, const Hull& other) {
  if (inside(one, other.at[0]) || inside(other, one.at[0])) return 0;
  const auto edges = [](const Hull& hull) { return static_cast<std::size_t>(hull.count == 3 ? 3 : 1); };
  const auto end = [](const Hull& hull, std::size_t i) {
    return hull.at[(i + 1) % static_cast<std::size_t>(hull.count)];
  };
  double least = (one.at[0] - other.at[0]).squaredNorm();
  for (std::size_t i = 0; i < edges(one); ++i)
    for (std::size_t j = 0; j < edges(other); ++j)
      least = std::min(least, squared_distance(one.at[i], end(one, i), other.at[j], end(other, j)));
  return std::sqrt(least);
}

}  // namespace kempe
