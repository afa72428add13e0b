// Obstacles as convex parts: with holes and without, against their area and random points.
#include "synthesis/convex_parts.hpp"

#include <gtest/gtest.h>

#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

double area_of(const ConvexPart& part) {
  double twice = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
    twice += std::imag(std::conj(part[i]) * part[(i + 1) % part.size()]);
  return twice / 2;
}

bool holds(const ConvexPart& part, Complex place) {
  for (std::size_t i = 0; i < part.size(); ++i)
    if (std::imag(std::conj(part[(i + 1) % part.size()] - part[i]) * (place - part[i])) < 0) return false;
  return true;
}

/// A square ring, clockwise as holes are.
Ring hole_at(double x, double y, double half) {
  return {{x - half, y - half}, {x - half, y + half}, {x + half, y + half}, {x + half, y - half}};
}

TEST(ConvexParts, CoverThePolygonAndNothingElse) {
  test::SpecDice dice(12);
  for (int i = 0; i < 200; ++i) {
    const double x = dice.uniform(-50, 50), y = dice.uniform(-50, 50);
    Polygon polygon = dice.star({x, y}, 100, 3 + i % 20);  // all within 20 of its centre is inside
    if (i % 2 == 1)
      polygon.holes = {hole_at(x - 6, y - 3, 2.5), hole_at(x + 5, y + 4, 2.5), hole_at(x, y + 12, 2.5)};
    const Region region{{polygon}};
    const std::vector<ConvexPart> parts = convex_parts(polygon);
    double sum = 0;
    for (const ConvexPart& part : parts) {
      EXPECT_GT(area_of(part), 0);
      sum += area_of(part);
    }
    EXPECT_NEAR(sum, area(region), 1e-9 * area(region)) << i;
    for (int j = 0; j < 50; ++j) {
      const Point place(dice.uniform(-160, 160), dice.uniform(-160, 160));
      const bool held = std::any_of(parts.begin(), parts.end(), [&](const ConvexPart& part) {
        return holds(part, {place.x(), place.y()});
      });
      EXPECT_EQ(held, contains(region, place)) << i;
    }
  }
}

}  // namespace
}  // namespace kempe
