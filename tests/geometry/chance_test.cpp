#include "geometry/chance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kempe {
namespace {

constexpr int draws = 200'000;

double normal_share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

/// The largest distance between the share of the values below a place and `expected(place)`: Kolmogorov's statistic.
template <class Expected>
double distance_from_distribution(std::vector<double> values, const Expected& expected) {
  std::sort(values.begin(), values.end());
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double n = static_cast<double>(values.size()), here = expected(values[i]);
    largest = std::max({largest, std::abs(here - static_cast<double>(i) / n),
                        std::abs(here - static_cast<double>(i + 1) / n)});
  }
  return largest;
}

/// Kolmogorov's limit that chance passes once in a million: sqrt(-log(5e-7) / 2) / sqrt(n).
double limit() { return std::sqrt(-std::log(5e-7) / 2 / draws); }

template <class Draw>
std::vector<double> drawn(const Draw& draw) {
  std::vector<double> values(draws);
  std::generate(values.begin(), values.end(), draw);
  return values;
}

TEST(Chance, FirstBitsAreThoseOfTheStandardsGenerator) {
  // The standard names the 10000th number of mt19937_64 with its usual seed: 9981545732273789042.
  Chance chance(5489);
  for (int i = 1; i < 10000; ++i) chance.share();
  EXPECT_EQ(chance.share(), std::ldexp(static_cast<double>(9981545732273789042u >> 11), -53));
}

TEST(Chance, SharesAreEvenlySpreadBelowOne) {
  Chance chance(1);
  const auto values = drawn([&] { return chance.share(); });
  EXPECT_GE(*std::min_element(values.begin(), values.end()), 0);
  EXPECT_LT(*std::max_element(values.begin(), values.end()), 1);
  EXPECT_LT(distance_from_distribution(values, [](double x) { return x; }), limit());
}

TEST(Chance, UniformAndSymmetricFillTheirIntervals) {
  Chance chance(2);
  EXPECT_LT(distance_from_distribution(drawn([&] { return chance.uniform(-3, 5); }),
                                       [](double x) { return (x + 3) / 8; }),
            limit());
  EXPECT_LT(distance_from_distribution(drawn([&] { return chance.symmetric(7); }),
                                       [](double x) { return (x + 7) / 14; }),
            limit());
}

TEST(Chance, NormalFollowsTheErrorFunction) {
  Chance chance(3);
  EXPECT_LT(distance_from_distribution(drawn([&] { return chance.normal(); }), normal_share_below), limit());
}

TEST(Chance, SeedDecidesTheStream) {
  Chance one(11), same(11), other(12);
  const double first = one.share();
  EXPECT_EQ(first, same.share());
  EXPECT_NE(first, other.share());
}

}  // namespace
}  // namespace kempe
