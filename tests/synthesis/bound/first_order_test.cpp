// Figures to first order against what they are of, at places of the box.
#include "synthesis/bound/first_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

using bounding::FirstOrder;
using Place = std::array<double, FirstOrder::coordinates>;  // each in [-1, 1]

/// A figure, and the same in doubles.
struct Both {
  FirstOrder figure;
  std::function<double(const Place&)> value;
};

/// A linear figure about `middle`, whose parts go with `width`.
Both linear(double middle, double width, test::SpecDice& dice) {
  Both both{bounding::constant(Interval(middle)), {}};
  Place slopes;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slopes[i] = width * dice.uniform(-0.2, 0.2);
    both.figure.along[i] = Interval(slopes[i]);
  }
  both.value = [middle, slopes](const Place& y) {
    double sum = middle;
    for (std::size_t i = 0; i < slopes.size(); ++i) sum += slopes[i] * y[i];
    return sum;
  };
  return both;
}

/// What sums, products and functions of two figures above 0 come to.
Both composed(const Both& f, const Both& g) {
  return {bounding::root(f.figure * g.figure) + bounding::inverse_root(g.figure) * f.figure -
              bounding::function_of(f.figure, Interval(1) / f.figure.middle,
                                    Interval(-1) / CGAL::square(f.figure.middle),
                                    Interval(2) / (CGAL::square(f.figure.all()) * f.figure.all())),
          [f, g](const Place& y) {
            const double u = f.value(y), v = g.value(y);
            return std::sqrt(u * v) + u / std::sqrt(v) - 1 / u;
          }};
}

TEST(FirstOrder, HoldsWhatItIsOfAllOverTheBox) {
  test::SpecDice dice(431);
  for (int i = 0; i < test::samples(2000); ++i) {
    const double width = dice.log_uniform(1e-6, 1);
    Place y;
    for (double& each : y) each = dice.uniform(-1, 1);
    const OutwardRounding rounding;
    const Both f = linear(dice.uniform(1, 3), width, dice), g = linear(dice.uniform(1, 3), width, dice);
    const Both both = composed(f, g);
    double value = 0;
    {
      const NearestRounding nearest;
      value = both.value(y);
    }
    Interval told = both.figure.middle + both.figure.off;
    for (std::size_t c = 0; c < y.size(); ++c) told += both.figure.along[c] * Interval(y[c]);
    EXPECT_LE(told.inf(), value + 1e-14) << i;
    EXPECT_GE(told.sup(), value - 1e-14) << i;
    EXPECT_LE(told.sup() - told.inf(), 3 * width * width + 1e-13) << i;
  }
}

}  // namespace
}  // namespace kempe
