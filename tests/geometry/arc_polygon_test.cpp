#include "geometry/arc_polygon.hpp"

#include <gtest/gtest.h>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

double area_of(const Polygon& polygon) {
  const auto shoelace = [](const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5 * twice;
  };
  double sum = shoelace(polygon.outer);
  for (const Ring& hole : polygon.holes) sum += shoelace(hole);
  return sum;
}

ArcPolygon annulus(const Point& centre, double inner, double outer) {
  return {circle(centre, outer), {reversed(circle(centre, inner))}};
}

TEST(ArcPolygon, AnnulusHasTheAreaOfTheClosedForm) {
  const ArcPolygon ring = annulus({1000, -300}, 55.9, 75);
  EXPECT_NEAR(area(ring), pi * (75.0 * 75 - 55.9 * 55.9), 1e-9 * area(ring));
}

TEST(ArcPolygon, ManyTinyArcsHaveTheAreaOfTheirCircle) {
  ArcRing ring;
  constexpr int parts = 100'000;
  for (int i = 0; i < parts; ++i)
    ring.push_back(
        {Point(std::cos(2 * pi * i / parts), std::sin(2 * pi * i / parts)) * 80, std::tan(pi / 2 / parts)});
  EXPECT_NEAR(signed_area(ring), pi * 6400, 1e-9 * 6400);
}

TEST(ArcPolygon, ReversedRingHasTheOppositeArea) {
  const ArcRing ring{{{0, 0}, 0.3}, {{10, 0}, 0}, {{10, 10}, -0.2}, {{0, 10}, 1}};
  EXPECT_NEAR(signed_area(reversed(ring)), -signed_area(ring), 1e-12);
}

TEST(ArcPolygon, FlatteningStaysOnItsSideAndWithinItsTolerance) {
  const ArcPolygon ring = annulus({3, 4}, 20, 50);
  for (const double tolerance : {1.0, 0.1, 0.001}) {
    const Polygon inner = flattened(ring, tolerance, Flatten::shrinks);
    const Polygon outer = flattened(ring, tolerance, Flatten::grows);
    EXPECT_LT(area_of(inner), area(ring));
    EXPECT_GT(area_of(outer), area(ring));
    EXPECT_GT(area_of(inner), area(ring) - tolerance * 2 * pi * 70);
    EXPECT_LT(area_of(outer), area(ring) + tolerance * 2 * pi * 70);
    for (const Point& point : inner.outer) EXPECT_LE((point - Point(3, 4)).norm(), 50 + 1e-12);
    for (const Point& point : inner.holes[0]) EXPECT_GE((point - Point(3, 4)).norm(), 20 - 1e-12);
    for (const Point& point : inner.holes[0]) EXPECT_LE((point - Point(3, 4)).norm(), 20 + tolerance + 1e-12);
  }
}

TEST(ArcPolygon, SimilarImageScalesTheAreaByTheSquareOfTheRatio) {
  const ArcRegion region{annulus({30, 40}, 5, 9)};
  const Complex k = copy_ratio(1.4, radians(77));
  const ArcRegion image = similar_image(region, k, {1, 2});
  EXPECT_NEAR(area(image), 1.96 * area(region), 1e-9);
  EXPECT_NEAR((image[0].outer[0].at - Point(1, 2)).norm(), 1.4 * (region[0].outer[0].at - Point(1, 2)).norm(),
              1e-12);
}

}  // namespace
}  // namespace kempe
