// Enclosures against the same functions with eleven bits more (long double).
#include "geometry/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

bool holds(const Interval& interval, long double value) {
  return static_cast<long double>(interval.inf()) <= value &&
         value <= static_cast<long double>(interval.sup());
}

TEST(Intervals, ADivisionIsRoundedOutwards) {
  const OutwardRounding rounding;
  const Interval third = Interval(1) / Interval(3);
  EXPECT_LT(third.inf(), third.sup());
  EXPECT_TRUE(holds(third, 1.0L / 3.0L));
}

/// Whether the processor rounds upwards, by what it does.
bool rounds_upwards() {
  const volatile double one = 1, little = 1e-30;
  return one + little > 1;
}

TEST(Intervals, TheProcessorRoundsToNearestAgainAfterwards) {
  {
    const OutwardRounding rounding;
    EXPECT_TRUE(rounds_upwards());
    cosine(Interval(1));
    EXPECT_TRUE(rounds_upwards());
    {
      const NearestRounding nearest;
      EXPECT_FALSE(rounds_upwards());
    }
    EXPECT_TRUE(rounds_upwards());
  }
  EXPECT_FALSE(rounds_upwards());
}

TEST(Intervals, CosinesSinesArcsAndLogarithmsHoldTheTrueOnes) {
  Dice dice(501);
  const OutwardRounding rounding;
  for (int i = 0; i < 200'000; ++i) {
    const double angle = dice.between(-7, 7),
                 width = i % 2 == 0 ? 0 : std::ldexp(dice.between(0, 1), -dice.below(50));
    const Interval angles(angle, angle + width);
    const long double inside = angle + dice.between(0, 1) * (static_cast<long double>(angles.sup()) - angle);
    ASSERT_TRUE(holds(cosine(angles), std::cos(inside))) << angle << " " << width;
    ASSERT_TRUE(holds(sine(angles), std::sin(inside))) << angle << " " << width;
    const double c = i % 3 == 0 ? 1 - std::ldexp(dice.between(0, 1), -dice.below(55)) : dice.between(-1, 1);
    ASSERT_TRUE(holds(arc_cosine(Interval(c)), std::acos(static_cast<long double>(c)))) << c;
    ASSERT_LT(arc_cosine(Interval(c)).sup() - arc_cosine(Interval(c)).inf(), 1e-14) << c;
    const double positive = std::ldexp(dice.between(0.5, 1), dice.below(200) - 100);
    const Interval numbers(positive, positive * (1 + width));
    const long double one =
        positive + dice.between(0, 1) * (static_cast<long double>(numbers.sup()) - positive);
    ASSERT_TRUE(holds(logarithm(numbers), std::log(one))) << positive << " " << width;
  }
  EXPECT_GE(arc_cosine(Interval(-1.5, 1.5)).sup(), pi);
  EXPECT_EQ(arc_cosine(Interval(-1.5, 1.5)).inf(), 0);
}

TEST(Intervals, ComplexOperationsHoldTheTrueResults) {
  Dice dice(502);
  const OutwardRounding rounding;
  using Exact = std::complex<long double>;
  const auto random = [&] {
    const double size = std::pow(10, dice.between(-3, 3));
    return Complex(size * dice.between(-1, 1), size * dice.between(-1, 1));
  };
  for (int i = 0; i < 20'000; ++i) {
    const Complex u = random(), v = random();
    const Exact a(u.real(), u.imag()), b(v.real(), v.imag());
    const auto check = [&](const IntervalComplex& result, const Exact& exact) {
      // The reference itself is off by some units in its last place, of the size of its terms.
      const long double room = 1e-18L * (std::abs(exact) + std::abs(a) + std::abs(b));
      ASSERT_TRUE(result.re.inf() <= exact.real() + room && exact.real() - room <= result.re.sup());
      ASSERT_TRUE(result.im.inf() <= exact.imag() + room && exact.imag() - room <= result.im.sup());
    };
    check(exactly(u) + exactly(v), a + b);
    check(exactly(u) - exactly(v), a - b);
    check(exactly(u) / exactly(v), a / b);
    const Exact product = a * b;
    EXPECT_NEAR((exactly(u) * exactly(v)).re.inf(), static_cast<double>(product.real()),
                1e-14 * std::abs(u) * std::abs(v));
    const Interval size = length(exactly(u));
    ASSERT_TRUE(holds(size, std::abs(a)) ||
                std::abs(static_cast<double>(std::abs(a)) - size.inf()) < 1e-15 * size.sup());
  }
}

}  // namespace
}  // namespace kempe
