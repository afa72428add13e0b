#include "geometry/regions/ring_loops.hpp"

#include <gtest/gtest.h>

#include "geometry/regions/ring_sweep.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

/// How often the ring runs around the point, by signed crossings of a ray.
int winding_number(const Ring& ring, const Point& point) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double side = cross(b - a, point - a);
    if (a.y() <= point.y() && b.y() > point.y() && side > 0) ++turns;
    if (a.y() > point.y() && b.y() <= point.y() && side < 0) --turns;
  }
  return turns;
}

TEST(SimpleLoops, OfASimpleRingAreTheRing) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    Ring ring = star_ring(random, 3 + i % 10, 5);
    EXPECT_EQ(simple_loops(ring), std::vector<Ring>{ring});
  }
}

TEST(SimpleLoops, OfABowTieAreItsTwoTriangles) {
  const auto loops = simple_loops({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->size(), 2u);
  EXPECT_DOUBLE_EQ(signed_area((*loops)[0]), 1);
  EXPECT_DOUBLE_EQ(signed_area((*loops)[1]), 1);
}

TEST(SimpleLoops, OfAPentagramCoverItsMiddle) {
  Ring star;
  for (int i = 0; i < 5; ++i) star.push_back(as_point(std::polar(10.0, 2 * pi * 2 * i / 5)));
  const auto loops = simple_loops(star);
  ASSERT_TRUE(loops);
  EXPECT_TRUE(std::any_of(loops->begin(), loops->end(), [](const Ring& r) {
    return winding_number(r, {0, 0}) != 0;
  }));
}

TEST(SimpleLoops, OfALineThereAndBackAreNone) {
  EXPECT_EQ(simple_loops({{0, 0}, {5, 0}, {9, 0}, {5, 0}}), std::vector<Ring>{});
  EXPECT_EQ(simple_loops({{0, 0}, {5, 0}}), std::vector<Ring>{});
  EXPECT_EQ(simple_loops({}), std::vector<Ring>{});
}

TEST(SimpleLoops, AreSimpleAndCoverWhatTheRingWindsAround) {
  std::mt19937_64 random(2);
  int several = 0;
  for (int i = 0; i < 1500; ++i) {
    const Ring ring = tangled_ring(random, 3 + i % 12, i % 3 == 0 ? 0 : 6);
    const auto loops = simple_loops(ring);
    ASSERT_TRUE(loops);
    several += loops->size() > 1;
    for (const Ring& loop : *loops) {
      const auto examined = examine_rings({loop});
      ASSERT_TRUE(examined);
      EXPECT_TRUE(examined->counter_clockwise[0]);
    }
    const double size = i % 3 == 0 ? 1 : 6;
    for (int probe = 0; probe < 40; ++probe) {
      const Point point(uniform(random, 0, size), uniform(random, 0, size));
      const bool covered = std::any_of(loops->begin(), loops->end(),
                                       [&](const Ring& loop) { return winding_number(loop, point) != 0; });
      EXPECT_TRUE(covered || winding_number(ring, point) == 0) << i;
    }
  }
  EXPECT_GT(several, 500);
}

TEST(SimpleLoops, GiveUpRatherThanWorkWithoutEnd) {
  std::mt19937_64 random(3);
  EXPECT_FALSE(simple_loops(tangled_ring(random, 400, 0), 1000));
}

}  // namespace
}  // namespace kempe
