#include "geometry/convex_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

/// Twice the area of whole points, exactly.
std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
  return whole(b.x() - a.x()) * whole(c.y() - a.y()) - whole(b.y() - a.y()) * whole(c.x() - a.x());
}

/// A place is a corner if some line through it has all others strictly on one side: it lies in no triangle of others and between
/// no two of them.
bool is_corner(std::size_t at, const std::vector<Point>& points) {
  const Point& p = points[at];
  const auto holds = [&](const Point& a, const Point& b, const Point& c) {
    const auto ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
    const auto lower = std::min({ab, bc, ca}), upper = std::max({ab, bc, ca});
    if (lower == 0 && upper == 0) {  // all on one line
      const auto side = [&](const Point& q) { return (q - p).dot(a - p) < 0 || (q - p).dot(b - p) < 0; };
      return side(a) || side(b) || side(c);
    }
    return lower >= 0 || upper <= 0;
  };
  for (const Point& a : points)
    for (const Point& b : points)
      for (const Point& c : points)
        if (a != p && b != p && c != p && holds(a, b, c)) return false;
  return true;
}

std::vector<Point> grid_points(std::mt19937_64& random, int count, int across) {
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const double x = std::floor(uniform(random, 0, across)), y = std::floor(uniform(random, 0, across));
    points.emplace_back(x, y);
  }
  return points;
}

std::vector<Point> without_repetitions(std::vector<Point> points) {
  std::vector<Point> kept;
  for (const Point& point : points)
    if (std::find(kept.begin(), kept.end(), point) == kept.end()) kept.push_back(point);
  return kept;
}

TEST(ConvexHull, HoldsExactlyTheCornersThatNoTriangleOfOthersHolds) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Point> points = grid_points(random, 1 + i % 14, 2 + i % 7);
    const std::vector<Point> hull = convex_hull(points), places = without_repetitions(points);
    std::size_t corners = 0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      const bool in_hull = std::find(hull.begin(), hull.end(), places[j]) != hull.end();
      EXPECT_EQ(in_hull, is_corner(j, places)) << "case " << i << ", place " << places[j].transpose();
      corners += in_hull ? 1 : 0;
    }
    EXPECT_EQ(hull.size(), corners) << "case " << i;
  }
}

TEST(ConvexHull, RunsCounterClockwiseFromTheLeftmostLowestCorner) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Point> hull = convex_hull(grid_points(random, 20, 3 + i));
    ASSERT_GE(hull.size(), 3U);
    for (std::size_t j = 0; j < hull.size(); ++j) {
      EXPECT_GT(turn(hull[j], hull[(j + 1) % hull.size()], hull[(j + 2) % hull.size()]), 0);
      EXPECT_TRUE(hull[0].x() < hull[j].x() || (hull[0].x() == hull[j].x() && hull[0].y() <= hull[j].y()));
    }
  }
}

TEST(ConvexHull, DecidesByAHair) {
  const double above = std::nextafter(0.5, 1.0), below = std::nextafter(0.5, 0.0);
  EXPECT_EQ(convex_hull({{0, 0}, {0.5, 0.5}, {1, 1}, {1, 0}}).size(), 3U);
  EXPECT_EQ(convex_hull({{0, 0}, {0.5, below}, {1, 1}, {1, 0}}).size(), 3U);
  EXPECT_EQ(convex_hull({{0, 0}, {0.5, above}, {1, 1}, {1, 0}}).size(), 4U);
}

TEST(ConvexHull, OfNothingOnePlaceAndALine) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}}), std::vector<Point>({{1, 2}}));
  EXPECT_EQ(convex_hull({{3, 3}, {1, 1}, {2, 2}}), std::vector<Point>({{1, 1}, {3, 3}}));
}

}  // namespace
}  // namespace kempe
