// The quick distance of a point alone, against the general one of two sets and against places sampled on the set.
#include "geometry/convex_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/chance.hpp"
#include "geometry/point.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

/// Corners on an ellipse in either direction; one makes a point, two a segment.
std::vector<Complex> convex_corners(Chance& chance) {
  const auto count = static_cast<std::size_t>(1 + 4 * (1 + chance.symmetric()));
  std::vector<double> turns(count);
  for (double& turn : turns) turn = chance.symmetric(pi);
  std::sort(turns.begin(), turns.end());
  if (chance.symmetric() > 0) std::reverse(turns.begin(), turns.end());
  const Complex centre(chance.symmetric(50), chance.symmetric(50));
  const double wide = 1 + 20 * std::abs(chance.symmetric()), high = 1 + 20 * std::abs(chance.symmetric());
  std::vector<Complex> corners;
  for (const double turn : turns)
    corners.push_back(centre + Complex(wide * std::cos(turn), high * std::sin(turn)));
  return corners;
}

TEST(ConvexDistance, OfAPointAloneIsThatOfTheTwoSets) {
  Chance chance(11);
  int inside = 0;
  for (int n = 0; n < test::samples(2000); ++n) {
    const std::vector<Complex> corners = convex_corners(chance);
    const Complex point = corners.front() + Complex(chance.symmetric(30), chance.symmetric(30));
    const double distance = distance_from(point, corners);
    EXPECT_NEAR(distance, nearest_features({&point, 1}, corners).distance, 1e-9);
    inside += distance < 0;
  }
  EXPECT_GT(inside, test::expected(50));
}

TEST(ConvexDistance, WithoutItsFeaturesItIsTheSameToTheLastBit) {
  Chance chance(13);
  int overlapping = 0, beyond = 0;
  for (int n = 0; n < test::samples(5000); ++n) {
    std::vector<Complex> first = convex_corners(chance), second = convex_corners(chance);
    const double exact = nearest_features(first, second).distance;
    const FixedConvex fixed(second);
    EXPECT_EQ(convex_distance(first, second), exact);
    EXPECT_EQ(convex_distance(first, fixed), exact);
    const double enough = exact + chance.symmetric(10);
    for (const double told : {convex_distance(first, second, enough), convex_distance(first, fixed, enough)})
      if (exact <= enough) {
        EXPECT_EQ(told, exact);
      } else {
        EXPECT_GT(told, enough);
        EXPECT_LE(told, exact + 1e-9);
      }
    overlapping += exact < 0;
    beyond += exact > enough;
  }
  EXPECT_GT(overlapping, test::expected(100));
  EXPECT_GT(beyond, test::expected(500));
}

TEST(ConvexDistance, OfSegmentsInOneLineIsTheGapBetweenThem) {
  Chance chance(14);
  for (int n = 0; n < test::samples(20000); ++n) {
    const Complex origin(chance.symmetric(100), chance.symmetric(100));
    const Complex along = std::polar(1.0, chance.symmetric(pi));
    const double first_length = std::abs(chance.symmetric(50)), gap = std::abs(chance.symmetric(10)),
                 second_length = std::abs(chance.symmetric(50));
    const std::vector<Complex> first{origin, origin + along * first_length};
    const std::vector<Complex> second{origin + along * (first_length + gap),
                                      origin + along * (first_length + gap + second_length)};
    EXPECT_NEAR(nearest_features(first, second).distance, gap, 1e-9);
    EXPECT_NEAR(convex_distance(first, FixedConvex(second)), gap, 1e-9);
  }
}

TEST(ConvexDistance, NoPlaceOfTheOutlineIsNearer) {
  Chance chance(12);
  for (int n = 0; n < test::samples(300); ++n) {
    const std::vector<Complex> corners = convex_corners(chance);
    const Complex point = corners.front() + Complex(chance.symmetric(30), chance.symmetric(30));
    double least = infinity;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int j = 0; j <= 200; ++j)
        least = std::min(
            least,
            std::abs(corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) * (j / 200.0) - point));
    const double distance = std::abs(distance_from(point, corners));
    EXPECT_LE(distance, least + 1e-9);
    EXPECT_GE(distance, least - 0.5);  // half a step along the longest edge
  }
}

}  // namespace
}  // namespace kempe
