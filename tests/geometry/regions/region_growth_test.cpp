#include "geometry/regions/region_growth.hpp"

#include <gtest/gtest.h>

#include "geometry/regions/region_algebra.hpp"
#include "specs/drawings/drawing_cover.hpp"
#include "tests/geometry/grid_outlines.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

bool keeps_invariant(const Region& region) {
  std::vector<Ring> outers, holes;
  for (const Polygon& polygon : region.polygons) {
    outers.push_back(polygon.outer);
    holes.insert(holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  const auto again = assemble_region(outers, holes);
  return again && area(*again) == area(region);
}

TEST(Grown, ByNothingIsTheRegion) {
  const Region region{{{{{0, 0}, {1, 0}, {1, 1}}, {}}}};
  EXPECT_EQ(grown(region, 0), region);
}

TEST(Grown, ContainsAllPointsWithinTheMarginAndNoneFarBeyond) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 40; ++i) {
    Region region{{{star_ring(random, 4 + i % 12, 50), {}}}};
    if (i % 3 == 2) region.polygons[0].outer = test::grid_polygon_about(random, Point::Zero(), 50).outer;
    Ring second = star_ring(random, 5, 30);
    for (Point& corner : second) corner += Point(90, 20);
    region.polygons.push_back({second, {}});
    const double margin = uniform(random, 0.5, 20);
    const auto larger = grown(region, margin);
    ASSERT_TRUE(larger) << larger.error();
    EXPECT_TRUE(keeps_invariant(*larger));
    for (int probe = 0; probe < 300; ++probe) {
      const Point point(uniform(random, -80, 150), uniform(random, -80, 80));
      const double away = distance(region, point);
      if (away <= margin) {
        EXPECT_TRUE(contains(*larger, point)) << away << " of " << margin;
      } else if (away > 1.005 * margin) {
        EXPECT_FALSE(contains(*larger, point)) << away << " of " << margin;
      }
    }
  }
}

TEST(Grown, ClosesHolesNarrowerThanTwiceTheMargin) {
  Ring hole{{4, 4}, {4, 7}, {7, 7}, {7, 4}};
  const Region frame{{{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {hole}}}};
  EXPECT_EQ(grown(frame, 1)->polygons[0].holes.size(), 1u);
  EXPECT_EQ(grown(frame, 1.6)->polygons[0].holes.size(), 0u);
}

TEST(Grown, OfScribblesWithManySmallHolesContainsAllPointsWithinTheMargin) {
  std::mt19937_64 random(4);
  std::size_t holes = 0;
  for (const int corners : {60, 120, 200, 350, 350, 500}) {
    Ring scribble = tangled_ring(random, corners, 0);
    for (Point& corner : scribble) corner *= 90;
    const auto drawn = covered_region({{scribble, true}}, "", "scribble", {.cover = Cover::outline});
    ASSERT_TRUE(drawn) << drawn.error().message();
    for (const Polygon& polygon : drawn->polygons) holes += polygon.holes.size();
    const double margin = uniform(random, 0.2, 2);
    const auto larger = grown(*drawn, margin);
    ASSERT_TRUE(larger) << larger.error();
    EXPECT_TRUE(keeps_invariant(*larger));
    EXPECT_GE(area(*larger), area(*drawn));
    for (int probe = 0; probe < 300; ++probe) {
      const double x = uniform(random, -5, 95);
      const Point point(x, uniform(random, -5, 95));
      const double away = distance(*drawn, point);
      if (away <= margin) {
        EXPECT_TRUE(contains(*larger, point)) << away << " of " << margin;
      } else if (away > 1.005 * margin) {
        EXPECT_FALSE(contains(*larger, point)) << away << " of " << margin;
      }
    }
  }
  EXPECT_GT(holes, 40U);
}

// The region united with its boundary, each edge of which is grown as a stroke.
TEST(Grown, IsTheRegionAndItsGrownBoundary) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100; ++i) {
    Region region{{test::grid_polygon_about(random, Point::Zero(), 50)}};
    if (i % 2) region.polygons[0] = {star_ring(random, 4 + i % 20, 50), {}};
    std::vector<Stroke> boundary;
    const auto add = [&](const Ring& ring) {
      boundary.push_back(ring);
      boundary.back().push_back(ring.front());
    };
    add(region.polygons[0].outer);
    for (const Ring& hole : region.polygons[0].holes) add(hole);
    const double margin = i % 5 == 0 ? 5 : uniform(random, 0.5, 30);
    const auto larger = grown(region, margin), around = grown(boundary, margin);
    ASSERT_TRUE(larger && around);
    EXPECT_TRUE(keeps_invariant(*larger));
    const double both = area(united({as_arcs(region), as_arcs(*around)}));
    EXPECT_NEAR(area(*larger), both, 1e-9 * both) << i;
  }
}

// Each edge is nearer than the margin to hundreds of others.
TEST(Grown, OfACombFinerThanTheMarginIsFilled) {
  Ring comb;
  constexpr int teeth = 1000;
  for (int i = 0; i < teeth; ++i)
    for (const Point& corner : {Point(0, 0), Point(0.018, 40), Point(0.022, 40)})
      comb.push_back(Point(0.04 * i, 0) + corner);
  for (const Point& corner : {Point(40, 0), Point(40, -1), Point(0, -1)}) comb.push_back(corner);
  std::reverse(comb.begin(), comb.end());
  const auto larger = grown(Region{{{comb, {}}}}, 10);
  ASSERT_TRUE(larger) << larger.error();
  ASSERT_EQ(larger->polygons.size(), 1u);
  EXPECT_TRUE(larger->polygons[0].holes.empty());
  EXPECT_LT(larger->polygons[0].outer.size(), 2 * teeth + 100);
  EXPECT_NEAR(area(*larger), 40 * 41 + 2 * 10 * 81 + pi * 100, 3);
}

TEST(Grown, StrokesCoverTheirNeighbourhood) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 30; ++i) {
    std::vector<Stroke> strokes(static_cast<std::size_t>(1 + i % 3));
    for (Stroke& stroke : strokes) {
      for (int c = 0; c < 1 + i % 6; ++c)
        stroke.emplace_back(uniform(random, 0, 100), uniform(random, 0, 100));
    }
    const double margin = uniform(random, 0.5, 10);
    const auto region = grown(strokes, margin);
    ASSERT_TRUE(region) << region.error();
    EXPECT_TRUE(keeps_invariant(*region));
    for (const Stroke& stroke : strokes) {
      for (std::size_t c = 0; c < stroke.size(); ++c) {
        const Point along = stroke[c] + uniform(random, 0, 1) * (stroke[(c + 1) % stroke.size()] - stroke[c]);
        const Point& on_stroke = c + 1 < stroke.size() ? along : stroke[c];
        const Point near = on_stroke + as_point(std::polar(0.999 * margin, uniform(random, 0, 2 * pi)));
        EXPECT_TRUE(contains(*region, near));
      }
    }
  }
}

TEST(United, CoversWhatAnyOfTheRingsCovers) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 60; ++i) {
    std::vector<Ring> rings;
    for (int r = 0; r < 6; ++r) {
      Ring ring = star_ring(random, 3 + r, 20);
      const Point shift(uniform(random, -30, 30), uniform(random, -30, 30));
      for (Point& corner : ring) corner += shift;
      if (r % 2 == 0) std::reverse(ring.begin(), ring.end());
      rings.push_back(ring);
    }
    const auto sum = united(rings);
    ASSERT_TRUE(sum) << sum.error();
    for (int probe = 0; probe < 200; ++probe) {
      const Point point(uniform(random, -50, 50), uniform(random, -50, 50));
      const bool covered = std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) {
        return contains({{{ring, {}}}}, point);
      });
      EXPECT_EQ(contains(*sum, point), covered);
    }
  }
}

TEST(United, TooMuchIsRefusedInWords) {
  std::vector<Ring> rings(1, Ring(300'000, Point(0, 0)));
  EXPECT_FALSE(united(rings));
  EXPECT_FALSE(grown(Region{{{Ring(30'000, Point(0, 0)), {}}}}, 1));
}

}  // namespace
}  // namespace kempe
