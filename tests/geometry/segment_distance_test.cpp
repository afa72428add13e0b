#include "geometry/segment_distance.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

Point point_of_a_box(std::mt19937_64& random) {
  const double x = uniform(random, -10, 10), y = uniform(random, -10, 10);
  return {x, y};
}

TEST(SegmentDistance, NoPlaceOfTheSegmentIsNearer) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const Point point = point_of_a_box(random), a = point_of_a_box(random), b = point_of_a_box(random);
    const double found = distance(point, a, b);
    EXPECT_NEAR((nearest_on_segment(point, a, b) - point).norm(), found, 1e-12);
    double sampled = (a - point).norm();
    for (int j = 0; j <= 1000; ++j) {
      const double here = (a + (j / 1000.0) * (b - a) - point).norm();
      EXPECT_LE(found, here + 1e-12);
      sampled = std::min(sampled, here);
    }
    EXPECT_NEAR(found, sampled, 0.5 * (b - a).norm() / 1000 + 1e-12);
  }
}

TEST(SegmentDistance, NearestPlaceIsTheEndItselfBeyondIt) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    const Point a = point_of_a_box(random), b = point_of_a_box(random);
    const double beyond = uniform(random, 0.01, 3);
    EXPECT_EQ(nearest_on_segment(b + beyond * (b - a), a, b), b);
    EXPECT_EQ(nearest_on_segment(a - beyond * (b - a), a, b), a);
  }
}

TEST(SegmentDistance, OfASegmentWithoutLengthIsThatOfItsPlace) {
  EXPECT_EQ(nearest_on_segment({3, 4}, {0, 0}, {0, 0}), Point(0, 0));
  EXPECT_EQ(distance(Point(3, 4), Point(0, 0), Point(0, 0)), 5);
}

}  // namespace
}  // namespace kempe
