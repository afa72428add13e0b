#include "geometry/regions/region_algebra.hpp"

#include <gtest/gtest.h>

#include "tests/workspace/random_linkage.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::Dice;

Polygon box(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}};
}

Polygon star(Dice& dice, const Point& centre, double size, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.outer.push_back(centre + as_point(std::polar(size * dice.between(0.4, 1), 2 * pi * i / corners)));
  return polygon;
}

TEST(RegionAlgebra, AnnulusIsTheDifferenceOfItsDiscs) {
  const ArcRegion ring = difference({{circle({3, 4}, 50), {}}}, {{circle({3, 4}, 20), {}}});
  ASSERT_EQ(ring.size(), 1u);
  ASSERT_EQ(ring[0].holes.size(), 1u);
  EXPECT_NEAR(area(ring), pi * (2500 - 400), 1e-9);
}

TEST(RegionAlgebra, LensOfTwoDiscsHasItsClosedFormArea) {
  const double r = 10, d = 12;
  const ArcRegion lens = intersection({{circle({0, 0}, r), {}}}, {{circle({d, 0}, r), {}}});
  EXPECT_NEAR(area(lens), 2 * r * r * std::acos(d / 2 / r) - d / 2 * std::sqrt(4 * r * r - d * d), 1e-9);
}

TEST(RegionAlgebra, AreasOfUnionIntersectionAndDifferenceAddUp) {
  Dice dice(41);
  for (int i = 0; i < 25; ++i) {
    const ArcRegion a = as_region({{0, 0}, dice.between(5, 20), dice.between(25, 50)});
    const ArcRegion b =
        as_arcs({{star(dice, {dice.between(-40, 40), dice.between(-40, 40)}, dice.between(5, 40), 12)}});
    const double both = area(intersection(a, b));
    EXPECT_NEAR(area(united({a, b})), area(a) + area(b) - both, 1e-9 * area(a));
    EXPECT_NEAR(area(difference(a, b)), area(a) - both, 1e-9 * area(a));
  }
}

TEST(RegionAlgebra, OverlappingObstaclesAreUnited) {
  const ArcRegion all =
      united({as_arcs({{box(0, 0, 10, 10)}}), as_arcs({{box(5, 5, 10, 10)}}), as_arcs({{box(30, 0, 5, 5)}})});
  EXPECT_EQ(all.size(), 2u);
  EXPECT_NEAR(area(all), 175 + 25, 1e-9);
}

TEST(RegionAlgebra, ContainmentIsExactDownToTheLastDigit) {
  const ArcRegion disc{{circle({0, 0}, 50), {}}};
  const double just = std::nextafter(30.0, 31.0);
  EXPECT_TRUE(contains(disc, as_arcs({{box(-30, -40, 60, 80)}})));  // corners on the circle: 30, 40, 50
  EXPECT_FALSE(contains(disc, as_arcs({{{{{-30, -40}, {just, -40}, {just, 40}, {-30, 40}}, {}}}})));
  EXPECT_TRUE(contains(disc, as_arcs({{box(-3, -4, 6, 8)}})));
  EXPECT_FALSE(contains(disc, as_arcs({{box(100, 0, 1, 1)}})));
}

TEST(RegionAlgebra, ContainmentMindsHoles) {
  const ArcRegion annulus = as_region({{0, 0}, 20, 50});
  EXPECT_TRUE(contains(annulus, as_arcs({{box(25, -5, 10, 10)}})));
  EXPECT_FALSE(contains(annulus, as_arcs({{box(-30, -30, 60, 60)}})));
  EXPECT_FALSE(contains(annulus, as_arcs({{box(-5, -5, 10, 10)}})));
  Polygon frame = box(-30, -30, 60, 60);
  frame.holes.push_back({{-21, -21}, {-21, 21}, {21, 21}, {21, -21}});
  EXPECT_TRUE(contains(annulus, as_arcs({{frame}})));
  frame.holes[0] = {{-19, -19}, {-19, 19}, {19, 19}, {19, -19}};
  EXPECT_FALSE(contains(annulus, as_arcs({{frame}})));
}

TEST(RegionAlgebra, RegionsAreApartIfTheirNearestPointsAre) {
  const Region a{{box(0, 0, 10, 10)}}, b{{box(15, 0, 10, 10)}};
  EXPECT_TRUE(are_apart(a, b, 5));
  EXPECT_FALSE(are_apart(a, b, std::nextafter(5.0, 6.0)));
  EXPECT_TRUE(are_apart(a, {{box(10, 0, 10, 10)}}, 0));  // they touch
  EXPECT_FALSE(are_apart(a, {{box(9, 0, 10, 10)}}, 0));
  EXPECT_FALSE(are_apart(a, {{box(2, 2, 1, 1)}}, 0));  // one inside the other
  EXPECT_FALSE(are_apart(a, {{box(0, 0, 10, 10)}}, 0));
}

// Combs of so many teeth take minutes to be cut with each other exactly.
TEST(RegionAlgebra, LargeRegionsThatOverlapAreToldAtOnce) {
  Ring comb;
  constexpr int teeth = 20'000;
  for (int i = 0; i < teeth; ++i)
    for (const Point& corner : {Point(0, 0), Point(0.001, -40), Point(0.001, 0)})
      comb.push_back(Point(0.002 * i, 0) + corner);
  for (const Point& corner : {Point(40, 0), Point(40, 1), Point(0, 1)}) comb.push_back(corner);
  const Region region{{{comb, {}}}};
  for (const auto& k : {std::complex(1.0001, 0.0), std::complex(0.01, 0.0), std::complex(0.0, 1.0)})
    EXPECT_FALSE(are_apart(region, similar_image(region, k, Point(20, 0.5)), 0));
}

TEST(RegionAlgebra, NearestPlacesAgreeWithASampling) {
  Dice dice(42);
  for (int i = 0; i < 60; ++i) {
    const Region a{{star(dice, {0, 0}, 20, 15)}},
        b{{star(dice, {dice.between(-60, 60), dice.between(-60, 60)}, 20, 15)}};
    const auto nearest = nearest_places(a, b);
    ASSERT_TRUE(nearest);
    double sampled = 1e300;
    for (const Point& corner : b.polygons[0].outer) sampled = std::min(sampled, distance(a, corner));
    for (const Point& corner : a.polygons[0].outer) sampled = std::min(sampled, distance(b, corner));
    if (nearest->distance > 0) {
      EXPECT_NEAR(nearest->distance, sampled, 1e-9);
    }
    EXPECT_LE(nearest->distance, sampled + 1e-9);
    EXPECT_EQ(are_apart(a, b, 7), nearest->distance >= 7);
  }
}

}  // namespace
}  // namespace kempe
