#include "geometry/region.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/geometry/grid_outlines.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Ring square_hole{{4, 4}, {4, 6}, {6, 6}, {6, 4}};
const Region frame{{{square, {square_hole}}}};

TEST(Region, AreaLeavesOutHoles) { EXPECT_DOUBLE_EQ(area(frame), 96); }

TEST(Region, AreaKeepsItsDigitsFarFromTheOrigin) {
  Ring far = square;
  for (Point& corner : far) corner += Point(1e7, -1e7);
  EXPECT_DOUBLE_EQ(signed_area(far), 100);
}

TEST(Region, AGridHasThePlacesAskedForOrNotTooMany) {
  EXPECT_DOUBLE_EQ(grid_step(frame, 24), 2);
  const Region flat{{{{{0, 0}, {300, 0}, {300, 1e-10}, {0, 1e-10}}, {}}}};
  const Region slanting{{{{{0, 0}, {200, 200}, {200, 200 + 1e-7}}, {}}}};
  Ring far = square;
  for (Point& corner : far) corner += Point(1e6, 1e6);
  const Region specks{{{square, {}}, {far, {}}}};
  for (const Region& region : {flat, slanting, specks}) {
    const Box box = bounding_box(region);
    const double step = grid_step(region, 800);
    EXPECT_LE(((box.upper.x() - box.lower.x()) / step + 1) * ((box.upper.y() - box.lower.y()) / step + 1),
              400'000);
  }
}

TEST(Region, ContainsItsBoundaryAndNotItsHoles) {
  EXPECT_TRUE(contains(frame, {1, 1}));
  EXPECT_TRUE(contains(frame, {0, 0}));
  EXPECT_TRUE(contains(frame, {10, 5}));
  EXPECT_TRUE(contains(frame, {5, 10}));
  EXPECT_TRUE(contains(frame, {4, 5}));
  EXPECT_FALSE(contains(frame, {5, 5}));
  EXPECT_FALSE(contains(frame, {10.0001, 5}));
  EXPECT_FALSE(contains(frame, {-1, 0}));
  EXPECT_FALSE(contains(frame, {11, 10}));
}

TEST(Region, DistanceIsZeroInsideAndToTheNearestEdgeOutside) {
  EXPECT_EQ(distance(frame, {1, 1}), 0);
  EXPECT_DOUBLE_EQ(distance(frame, {5, 5}), 1);
  EXPECT_DOUBLE_EQ(distance(frame, {13, 14}), 5);
  EXPECT_DOUBLE_EQ(distance(frame, {5, -2}), 2);
}

TEST(Region, DistanceRangeIsZeroAtAPoleInside) {
  const DistanceRange from_inside = distance_range(frame, {1, 1});
  EXPECT_EQ(from_inside.nearest, 0);
  EXPECT_DOUBLE_EQ(from_inside.farthest, 9 * std::sqrt(2.0));
  const DistanceRange from_outside = distance_range(frame, {-3, -4});
  EXPECT_DOUBLE_EQ(from_outside.nearest, 5);
  EXPECT_DOUBLE_EQ(from_outside.farthest, std::hypot(13, 14));
}

TEST(Region, BoundingBoxHoldsAllPolygons) {
  const Region two{{{square, {}}, {{{20, 1}, {30, 1}, {25, 12}}, {}}}};
  EXPECT_EQ(bounding_box(two).lower, Point(0, 0));
  EXPECT_EQ(bounding_box(two).upper, Point(30, 12));
}

TEST(Region, SimilarImageScalesAreasAndDistances) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const Region region{{{star_ring(random, 12, 50), {}}}};
    const Complex k = std::polar(uniform(random, 0.1, 5), uniform(random, -3, 3));
    const Point pole(uniform(random, -90, 90), uniform(random, -90, 90));
    const Region copy = similar_image(region, k, pole);
    EXPECT_NEAR(area(copy), std::norm(k) * area(region), 1e-9 * area(copy));
    const Point probe(uniform(random, -90, 90), uniform(random, -90, 90));
    const Point probe_copy = pole + as_point(k * as_complex(probe - pole));
    EXPECT_NEAR(distance(copy, probe_copy), std::abs(k) * distance(region, probe), 1e-9);
  }
}

/// Winding number by the sum of the angles at which the corners are seen.
bool inside_by_angles(const Ring& ring, const Point& point) {
  double turn = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    turn += std::arg(as_complex(ring[(i + 1) % ring.size()] - point) / as_complex(ring[i] - point));
  }
  return std::abs(turn) > pi;
}

TEST(Region, ContainsAgreesWithTheWindingNumber) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const Ring ring = i % 2 == 0 ? test::grid_polygon(random, 8).outer : star_ring(random, 3 + i % 20, 50);
    const Point probe(uniform(random, -60, 60), uniform(random, -60, 60));
    EXPECT_EQ(contains({{{ring, {}}}}, probe), inside_by_angles(ring, probe));
  }
}

TEST(Region, PointsOfACommonEdgeBelongToBothPolygons) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    const Point a(uniform(random, -9, 9), uniform(random, -9, 9)),
        b(uniform(random, -9, 9), uniform(random, -9, 9));
    const Region left{{{{a, b, a + Point(20, 20)}, {}}}}, right{{{{b, a, a - Point(20, 20)}, {}}}};
    const Point probe = a + uniform(random, 0.01, 0.99) * (b - a);
    EXPECT_TRUE(contains(left, probe) || contains(right, probe)) << i;
  }
}

}  // namespace
}  // namespace kempe
