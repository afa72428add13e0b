#include "geometry/regions/region_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/geometry/grid_outlines.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

using testing::HasSubstr;

Ring square_ring(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}
Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST(AssembleRegion, TurnsRingsTheRightWay) {
  for (const bool flip_outer : {false, true}) {
    for (const bool flip_hole : {false, true}) {
      const auto region =
          assemble_region({flip_outer ? reversed(square_ring(0, 0, 9)) : square_ring(0, 0, 9)},
                          {flip_hole ? reversed(square_ring(2, 2, 3)) : square_ring(2, 2, 3)});
      ASSERT_TRUE(region);
      EXPECT_GT(signed_area(region->polygons[0].outer), 0);
      EXPECT_LT(signed_area(region->polygons[0].holes.at(0)), 0);
      EXPECT_DOUBLE_EQ(area(*region), 72);
    }
  }
}

TEST(AssembleRegion, GivesEachHoleToThePolygonAroundIt) {
  const auto region = assemble_region({square_ring(0, 0, 9), square_ring(20, 0, 9), square_ring(3, 3, 1)},
                                      {square_ring(22, 2, 2), square_ring(2, 2, 4)});
  ASSERT_TRUE(region) << region.error().found;
  EXPECT_EQ(region->polygons[0].holes.size(), 1u);
  EXPECT_EQ(region->polygons[1].holes.size(), 1u);
  EXPECT_EQ(region->polygons[2].holes.size(), 0u);
  EXPECT_DOUBLE_EQ(area(*region), 81 - 16 + 1 + 81 - 4);
}

TEST(AssembleRegion, DropsRepeatedCorners) {
  const auto region = assemble_region({{{0, 0}, {0, 0}, {5, 0}, {5, 5}, {5, 5}, {0, 5}, {0, 0}}}, {});
  ASSERT_TRUE(region);
  EXPECT_EQ(region->polygons[0].outer.size(), 4u);
}

struct Refused {
  std::vector<Ring> outers, holes;
  const char* found;
};

TEST(AssembleRegion, RefusesWhatIsNoRegionAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<Refused> cases{
      {{}, {}, "no polygon"},
      {{{}}, {}, "a ring of 0 different corners"},
      {{{{0, 0}, {1, 1}, {0, 0}, {1, 1}, {1, 1}}}, {}, "no area"},
      {{{{0, 0}, {1, 1}, {1, 1}}}, {}, "a ring of 2 different corners"},
      {{{{0, 0}, {1, 1}, {2, 2}}}, {}, "no area"},
      {{{{0, 0}, {1e-9, 0}, {0, 1e-9}}}, {}, "no area"},
      {{{{0, 0}, {nan, 0}, {0, 1}}}, {}, "a corner at [nan, 0]"},
      {{{{0, 0}, {inf, 0}, {0, 1}}}, {}, "a corner at [inf, 0]"},
      {{{{0, 0}, {1e12, 0}, {0, 1}}}, {}, "a corner at [1000000000000, 0]"},
      {{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
       {},
       "edge 1 from [0, 0] to [2, 2] meets edge 3 from [2, 0] to [0, 2]"},
      {{square_ring(0, 0, 4), square_ring(3, 3, 4)}, {}, "polygon 1 and polygon 2 cross or touch"},
      {{square_ring(0, 0, 4), square_ring(4, 0, 4)}, {}, "polygon 1 and polygon 2 cross or touch"},
      {{square_ring(0, 0, 4), square_ring(1, 1, 1)}, {}, "polygon 2 lies inside polygon 1"},
      {{square_ring(0, 0, 4)}, {square_ring(7, 7, 1)}, "hole 1 lies outside every polygon"},
      {{square_ring(0, 0, 9)}, {square_ring(1, 1, 5), square_ring(2, 2, 2)}, "hole 2 lies inside hole 1"},
      {{square_ring(0, 0, 9)}, {square_ring(0, 0, 9)}, "cross or touch"},
  };
  for (const Refused& refused : cases) {
    const auto region = assemble_region(refused.outers, refused.holes);
    ASSERT_FALSE(region) << refused.found;
    EXPECT_THAT(region.error().found, HasSubstr(refused.found));
    EXPECT_FALSE(region.error().allowed.empty());
  }
}

TEST(AssembleRegion, KeepsItsInvariantOnRandomRings) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    Ring ring = i % 3 == 0 ? test::grid_polygon(random, 6).outer : star_ring(random, 3 + i % 30, 100);
    if (i % 2 == 0) std::reverse(ring.begin(), ring.end());
    const auto region = assemble_region({ring}, {});
    ASSERT_TRUE(region);
    EXPECT_NEAR(area(*region), std::abs(signed_area(ring)), 1e-9);
    EXPECT_GT(area(*region), 0);
  }
}

}  // namespace
}  // namespace kempe
