#include "geometry/regions/ring_sweep.hpp"

#include <gtest/gtest.h>

#include "geometry/orientation.hpp"
#include "geometry/regions/region_checks.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

struct Segment {
  Point from, to;
};
Segment segment(const std::vector<Ring>& rings, const RingEdge& edge) {
  const Ring& ring = rings[edge.ring];
  return {ring[edge.edge], ring[(edge.edge + 1) % ring.size()]};
}

/// The definition, pair by pair.
bool may_not_share_a_point(const std::vector<Ring>& rings, const RingEdge& a, const RingEdge& b) {
  const Segment s = segment(rings, a), t = segment(rings, b);
  const std::size_t count = rings[a.ring].size();
  const bool a_then_b = a.ring == b.ring && (a.edge + 1) % count == b.edge;
  const bool b_then_a = a.ring == b.ring && (b.edge + 1) % count == a.edge;
  if (!a_then_b && !b_then_a) return segments_meet(s.from, s.to, t.from, t.to);
  const Point& tip = a_then_b ? s.to : s.from;
  const Point before = a_then_b ? s.from : t.from, after = a_then_b ? t.to : s.to;
  return orientation(before, tip, after) == 0 && (before - tip).dot(after - tip) > 0;
}

bool meets_by_brute_force(const std::vector<Ring>& rings) {
  std::vector<RingEdge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t e = 0; e < rings[r].size(); ++e) edges.push_back({r, e});
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (may_not_share_a_point(rings, edges[i], edges[j])) return true;
    }
  }
  return false;
}

std::size_t compare_with_brute_force(const std::vector<Ring>& rings) {
  const auto swept = examine_rings(rings);
  EXPECT_EQ(!swept.has_value(), meets_by_brute_force(rings));
  if (!swept) {
    EXPECT_TRUE(may_not_share_a_point(rings, swept.error().first, swept.error().second));
  }
  return swept ? 1 : 0;
}

TEST(RingSweep, AgreesWithBruteForceOnRandomRings) {
  std::mt19937_64 random(1);
  std::size_t simple = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ring ring = without_repeated_corners(tangled_ring(random, 3 + i % 6, i % 3 == 0 ? 0 : 5));
    if (ring.size() >= 3) simple += compare_with_brute_force({ring});
  }
  EXPECT_GT(simple, 500u);
}

TEST(RingSweep, AgreesWithBruteForceOnSeveralRings) {
  std::mt19937_64 random(2);
  std::size_t apart = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Ring> rings;
    for (int r = 0; r < 4; ++r) {
      Ring ring = star_ring(random, 3 + static_cast<int>(random() % 6), uniform(random, 1, 6));
      const Point shift(uniform(random, -10, 10), uniform(random, -10, 10));
      for (Point& corner : ring) {
        corner += shift;
        if (i % 2 == 0) corner = corner.array().round().matrix();
      }
      ring = without_repeated_corners(ring);
      if (ring.size() >= 3) rings.push_back(ring);
    }
    apart += compare_with_brute_force(rings);
  }
  EXPECT_GT(apart, 200u);
}

TEST(RingSweep, FindsAFaultInAnotherwiseSimpleRing) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    Ring ring = star_ring(random, 40, 50);
    std::swap(ring[random() % 40], ring[random() % 40]);
    compare_with_brute_force({ring});
  }
}

TEST(RingSweep, KnowsDirectionAndNesting) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    // A box, in it a box run the other way, in that a third; beside the first a fourth.
    const double a = uniform(random, 0, 6.28);
    const auto box = [&](double x, double size, bool counter_clockwise) {
      Ring ring;
      for (const Point& corner : {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)}) {
        ring.push_back(as_point(std::polar(1.0, a) * as_complex(Point(x, 0) + size * corner)));
      }
      if (!counter_clockwise) std::reverse(ring.begin(), ring.end());
      return ring;
    };
    const auto swept =
        examine_rings({box(0, 1, true), box(0, 3, false), box(7, 2, false), box(0.5, 4, true)});
    ASSERT_TRUE(swept);
    EXPECT_EQ(swept->counter_clockwise, (std::vector<bool>{true, false, false, true}));
    EXPECT_EQ(swept->parent, (std::vector<std::optional<std::size_t>>{1, 3, std::nullopt, std::nullopt}));
  }
}

TEST(RingSweep, NestingAgreesWithPointInPolygon) {
  std::mt19937_64 random(5);
  int nested = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Ring> rings;
    for (int r = 0; r < 5; ++r) {
      Ring ring = star_ring(random, 3 + static_cast<int>(random() % 6), std::pow(4.0, r));
      const Point shift(uniform(random, -100, 100), uniform(random, -100, 100));
      for (Point& corner : ring) corner += shift;
      rings.push_back(ring);
    }
    const auto swept = examine_rings(rings);
    if (!swept) continue;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      std::optional<std::size_t> smallest;
      for (std::size_t other = 0; other < rings.size(); ++other) {
        if (other == r || !contains({{{rings[other], {}}}}, rings[r][0])) continue;
        if (!smallest || std::abs(signed_area(rings[other])) < std::abs(signed_area(rings[*smallest])))
          smallest = other;
      }
      EXPECT_EQ(swept->parent[r], smallest);
      EXPECT_TRUE(swept->counter_clockwise[r]);
      nested += smallest.has_value();
    }
  }
  EXPECT_GT(nested, 100);
}

/// A comb of long slanted teeth: every tooth's box overlaps every other's.
TEST(RingSweep, HandlesAQuarterOfAMillionLongSlantedEdges) {
  Ring comb;
  const int teeth = 125000;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back({i * 1e-3, 0});
    comb.push_back({1000 + i * 1e-3, 1000});
  }
  comb.push_back({teeth * 1e-3, 0});
  comb.push_back({teeth * 1e-3, -1});
  comb.push_back({0, -1});
  EXPECT_TRUE(examine_rings({comb}));
  comb[comb.size() / 2].y() += 2000;
  EXPECT_FALSE(examine_rings({comb}));
}

TEST(RingSweep, HandlesAMillionCornersOnACircle) {
  Ring circle;
  for (int i = 0; i < 1'000'000; ++i) circle.push_back(as_point(std::polar(50.0, 2 * pi * i / 1e6)));
  const auto swept = examine_rings({circle});
  ASSERT_TRUE(swept);
  EXPECT_TRUE(swept->counter_clockwise[0]);
  std::swap(circle[777'777], circle[777'778]);
  EXPECT_FALSE(examine_rings({circle}));
}

}  // namespace
}  // namespace kempe
