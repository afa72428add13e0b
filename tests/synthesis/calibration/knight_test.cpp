// Knight's equations against the equations as he printed them and against exact instruments with one length
// moved.
#include "synthesis/calibration/knight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

using test::uniform;

/// Departure of E of an instrument with these deviations, the stylus at the arm angle of the drawn arms.
Point departure(const Instrument& instrument, const Measures& deviations, double angle) {
  const double arm = instrument.drawn[index_of(Measure::CX)];
  const Point stylus(2 * arm * std::cos(angle), 0);
  return output_at(instrument, instrument.drawn + deviations, stylus)->at - wanted_output(instrument, stylus);
}

ScaleErrors from_two(const Point& at_30, const Point& at_60) {
  return knight_errors({{radians(30), at_30}, {radians(60), at_60}})->errors;
}

TEST(Knight, IsThePublishedEquations23To26) {
  std::mt19937_64 random(11);
  const double root = std::sqrt(3.0) / 2;
  for (int i = 0; i < 300; ++i) {
    const double ex30 = uniform(random, -1, 1), ey30 = uniform(random, -1, 1);
    const double ex60 = uniform(random, -1, 1), ey60 = uniform(random, -1, 1);
    const ScaleErrors found = from_two({ex30, ey30}, {ex60, ey60});
    EXPECT_NEAR(found.AC, root * (ey60 + ex30) - 0.5 * (ey30 + ex60), 1e-14);
    EXPECT_NEAR(found.CF, root * (ex30 - ey60) + 0.5 * (ey30 - ex60), 1e-14);
    EXPECT_NEAR(found.BE, root / 2 * (ex30 - ey60) - 0.25 * (ey30 - ex60), 1e-14);
    EXPECT_NEAR(found.DE, root / 2 * (ex30 + ey60) + 0.25 * (ey30 + ex60), 1e-14);
  }
}

TEST(Knight, FindsEachLengthThatWasMovedWithItsSign) {
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  const double moved = 1e-4;
  const auto found = [&](Measure measure) {
    Measures deviations = Measures::Zero();
    deviations[index_of(measure)] = moved;
    const ScaleErrors errors = from_two(departure(instrument, deviations, radians(30)),
                                        departure(instrument, deviations, radians(60)));
    Eigen::Vector4d all(errors.values().data());
    return Eigen::Vector4d(all / moved);
  };
  EXPECT_LT((found(Measure::AX) - Eigen::Vector4d(1, 0, 0, 0)).norm(), 1e-5);   // e_AC = dAB
  EXPECT_LT((found(Measure::BC) - Eigen::Vector4d(0, 1, 0, 0)).norm(), 1e-5);   // e_CF = dCD
  EXPECT_LT((found(Measure::VA) - Eigen::Vector4d(0, 0, 1, 0)).norm(), 1e-5);   // e_BE = dBE
  EXPECT_LT((found(Measure::VB) - Eigen::Vector4d(0, 0, 0, -1)).norm(), 1e-5);  // e_DE = -dDE
}

TEST(Knight, HoldsAtEveryRatioAndPairOfAnglesToFirstOrder) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 300; ++i) {
    const Instrument instrument = variable_ratio_instrument(500, uniform(random, 0.2, 0.8));
    ScaleErrors hidden{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1),
                       uniform(random, -1, 1)};
    hidden = {1e-4 * hidden.AC, 1e-4 * hidden.CF, 1e-4 * hidden.BE, 1e-4 * hidden.DE};
    const double first = radians(uniform(random, 15, 40)), second = radians(uniform(random, 50, 75));
    const auto found = knight_errors({{first, departure(instrument, deviations_of(hidden), first)},
                                      {second, departure(instrument, deviations_of(hidden), second)}});
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(found->errors.values()[j], hidden.values()[j], 1e-8);
  }
}

TEST(Knight, DepartureIsTheInverseOfTheErrors) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 300; ++i) {
    const ScaleErrors hidden{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1),
                             uniform(random, -1, 1)};
    std::vector<KnightReading> readings;
    for (const double angle : {20.0, 35.0, 50.0, 70.0})
      readings.push_back({radians(angle), departure_of(hidden, radians(angle))});
    const auto found = knight_errors(readings);
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(found->errors.values()[j], hidden.values()[j], 1e-13);
    for (const Point& left : found->left) EXPECT_LT(left.norm(), 1e-13);
  }
}

TEST(Knight, DeviationsAndScaleErrorsAreEachOthersInverse) {
  const ScaleErrors errors{0.1, -0.2, 0.3, 0.4};
  EXPECT_EQ(scale_errors_of(deviations_of(errors)), errors);
}

TEST(Knight, RefusesAnglesWhereTheEquationsLoseRank) {
  const Point error(0.1, 0.1);
  const auto fault = [&](double first, double second) {
    return knight_errors({{radians(first), error}, {radians(second), error}}).error();
  };
  EXPECT_EQ(knight_errors({{radians(30), error}}).error(), KnightFault::too_few);
  EXPECT_EQ(knight_errors({}).error(), KnightFault::too_few);
  EXPECT_EQ(fault(0, 60), KnightFault::at_an_end);
  EXPECT_EQ(fault(30, 90), KnightFault::at_an_end);
  EXPECT_EQ(fault(30, 30), KnightFault::one_angle);
  EXPECT_EQ(fault(30, 30.5), KnightFault::one_angle);
}

}  // namespace
}  // namespace kempe
