#include "geometry/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

__extension__ typedef __int128 Wide;

/// Sign of the area in whole numbers, which do not round.
int orientation_of_integers(const std::array<std::int64_t, 6>& c) {
  const Wide area =
      static_cast<Wide>(c[2] - c[0]) * (c[5] - c[1]) - static_cast<Wide>(c[3] - c[1]) * (c[4] - c[0]);
  return (area > 0) - (area < 0);
}

Point point_of(std::int64_t x, std::int64_t y, double unit) {
  return {static_cast<double>(x) * unit, static_cast<double>(y) * unit};
}

TEST(Orientation, IsExactNearLines) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    // Points of one line through far grid points, shifted by -1, 0 or +1 units of a grid of 2^-40.
    std::array<std::int64_t, 6> c{};
    const std::int64_t dx = static_cast<std::int64_t>(random() % (1 << 20)),
                       dy = static_cast<std::int64_t>(random() % (1 << 20));
    for (std::size_t point = 0; point < 3; ++point) {
      const auto along = static_cast<std::int64_t>(random() % (1 << 20));
      c[2 * point] = along * dx + static_cast<std::int64_t>(random() % 3) - 1;
      c[2 * point + 1] = along * dy + static_cast<std::int64_t>(random() % 3) - 1;
    }
    const double unit = 0x1p-40;
    EXPECT_EQ(orientation(point_of(c[0], c[1], unit), point_of(c[2], c[3], unit), point_of(c[4], c[5], unit)),
              orientation_of_integers(c));
  }
}

TEST(Orientation, DecidesWhereFloatingPointMisleads) {
  // 0.1, 0.2, 0.3 in doubles are not on the diagonal's line through (0, 0) and (0.1, 0.1 + one unit).
  const double above = std::nextafter(0.1, 1.0);
  EXPECT_EQ(orientation({0, 0}, {0.3, 0.3}, {0.1, above}), 1);
  EXPECT_EQ(orientation({0, 0}, {0.3, 0.3}, {0.1, 0.1}), 0);
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 0.0)}), -1);
}

TEST(Orientation, ChangesSignWithTheOrderOfItsPoints) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Ring t = tangled_ring(random, 3, i % 2 == 0 ? 3 : 0);
    const int turn = orientation(t[0], t[1], t[2]);
    EXPECT_EQ(orientation(t[1], t[2], t[0]), turn);
    EXPECT_EQ(orientation(t[1], t[0], t[2]), -turn);
  }
}

TEST(SegmentsMeet, AtCrossingsTouchesAndOverlaps) {
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {2, 0}, {3, 5}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {3, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {2.1, 0}, {3, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {0, 1}, {2, 1}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 2}, {3, 3}, {4, 5}));
}

}  // namespace
}  // namespace kempe
