// rounded_lengths(): the errors of rounding, and the copy error of an instrument that is made to the rounded lengths.
#include "synthesis/design/rounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/tolerance/copy_error.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

Design with_tolerance(double length) {
  Design design =
      testing::sample_design(copy_ratio(1.4, radians(50)), Grounding::tracer, 91.2345678, 73.87654321, 1);
  if (length > 0) design.tolerance = Tolerance{.length = length, .play = 0.02};
  return design;
}

TEST(RoundedLengths, AreAsCoarseAsTheToleranceCanTell) {
  for (const auto& [tolerance, step] :
       {std::pair{0.0, 0.01}, {0.05, 0.01}, {0.5, 0.1}, {0.02, 0.001}, {5.0, 1.0}})
    EXPECT_NEAR(rounded_lengths(with_tolerance(tolerance)).step, step, 1e-12) << tolerance;
}

TEST(RoundedLengths, AreTheNearestMultiples) {
  for (const double tolerance : {0.0, 0.01, 0.05, 0.5}) {
    const Design design = with_tolerance(tolerance);
    const RoundedLengths rounded = rounded_lengths(design);
    const auto exact = design.linkage.lengths().values(), made = rounded.lengths.values();
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_LE(std::abs(exact[i] - made[i]), rounded.step / 2 * (1 + 1e-9));
      EXPECT_NEAR(made[i] / rounded.step, std::round(made[i] / rounded.step), 1e-6);
    }
  }
}

TEST(RoundedLengths, OfLengthsThatAreRoundCostNothing) {
  Design design = testing::sample_design(Complex(2.5), Grounding::pole, 90, 70, 0);
  const RoundedLengths rounded = rounded_lengths(design);
  ASSERT_TRUE(rounded.copy_error);
  EXPECT_NEAR(*rounded.copy_error, 0, 1e-9);
}

TEST(RoundedLengths, AddToTheTolerances) {
  Design design = with_tolerance(0.05);
  const RoundedLengths rounded = rounded_lengths(design);
  const auto without =
      copy_error_over(design.linkage, CopyTolerance::uniform(*design.tolerance), design.region);
  ASSERT_TRUE(without && rounded.with_tolerance && rounded.copy_error);
  EXPECT_GE(*rounded.with_tolerance, without->worst);
  EXPECT_LE(*rounded.with_tolerance, without->worst + *rounded.copy_error + 1e-9);
  EXPECT_LE(*rounded.copy_error, 0.2 * *rounded.with_tolerance);
}

/// A limit that the exact lengths keep with next to nothing to spare makes the step finer, until it is kept.
TEST(RoundedLengths, KeepTheLimitsThatTheExactOnesKeep) {
  Design design = with_tolerance(0.05);
  const auto exact =
      copy_error_over(design.linkage, CopyTolerance::uniform(*design.tolerance), design.region);
  ASSERT_TRUE(exact);
  design.quality.copy_error_worst = exact->worst;
  design.limits.copy_error = exact->worst * (1 + 1e-4);
  const RoundedLengths rounded = rounded_lengths(design);
  EXPECT_LT(rounded.step, 0.01);
  EXPECT_LE(*rounded.with_tolerance, *design.limits.copy_error);
  design = with_tolerance(5);
  const auto lengths = design.linkage.lengths().values();
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  design.limits.longest_strip = longest + design.style.width;
  const auto made = rounded_lengths(design).lengths.values();
  EXPECT_LE(*std::max_element(made.begin(), made.end()), longest + 1e-6);
}

}  // namespace
}  // namespace kempe
