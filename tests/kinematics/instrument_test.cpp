// The made instrument: closed loops, exact slopes, every mounting, against the closed form and against
// differences.
#include "kinematics/instrument.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

struct Drawn {
  CopyingLinkage linkage;
  Instrument instrument;
};

/// A linkage of any grounding; every third has straight plates.
Drawn random_drawn(std::mt19937_64& random) {
  const auto uniform = [&](double lower, double upper) { return test::uniform(random, lower, upper); };
  for (;;) {
    const Grounding grounding = all_groundings[random() % 3];
    const double turn = random() % 3 == 0 ? (random() % 2 ? pi : 0) : uniform(-pi, pi);
    const Complex k = copy_ratio(uniform(0.3, 3), turn);
    const auto linkage =
        CopyingLinkage::make(k, grounding, uniform(50, 300), uniform(50, 300), static_cast<int>(random() % 4),
                             Point(uniform(-50, 50), uniform(-50, 50)));
    if (linkage && std::abs(1.0 - k) > 0.1 && linkage->assembly_mode().openings.width() > 0.7)
      return {*linkage, instrument_of(*linkage)};
  }
}

Point random_tracer(const CopyingLinkage& linkage, std::mt19937_64& random) {
  const auto uniform = [&] { return test::share(random); };
  const OpeningInterval openings = shrink(linkage.assembly_mode().openings, 0.25);
  return linkage.tracer_at(openings.lower + uniform() * openings.width(), 2 * pi * uniform());
}

double place_error(const Pose& a, const Pose& b) {
  double largest = 0;
  for (const Joint joint : all_joints) largest = std::max(largest, (a[joint] - b[joint]).norm());
  return largest;
}

TEST(Instrument, AsDrawnStandsWhereTheClosedFormPutsIt) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const Drawn drawn = random_drawn(random);
    const Point tracer = random_tracer(drawn.linkage, random);
    const auto pose = pose_of(drawn.instrument, drawn.instrument.drawn, tracer);
    const auto expected = drawn.linkage.pose_with_tracer_at(tracer);
    ASSERT_TRUE(pose && expected);
    EXPECT_LT(place_error(*pose, *expected), 1e-8);
    EXPECT_LT((wanted_output(drawn.instrument, tracer) - (*expected)[drawn.linkage.pen_joint()]).norm(),
              1e-9);
  }
}

TEST(Instrument, HasTheLinkagesEightLengths) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const Drawn drawn = random_drawn(random);
    const auto lengths = lengths_of(drawn.instrument.drawn).values;
    for (int j = 0; j < 8; ++j)
      EXPECT_NEAR(lengths[j], drawn.linkage.lengths().values()[static_cast<std::size_t>(j)], 1e-9);
  }
}

/// Any measures near the drawn ones, in a frame that is moved and turned.
Measures disturbed(const Measures& drawn, std::mt19937_64& random) {
  const auto symmetric = [&] { return 2 * test::share(random) - 1; };
  Measures measures = drawn;
  for (int i = 0; i < 10; ++i) measures[i] += 0.2 * symmetric();
  for (int i = 10; i < 12; ++i) measures[i] += 20 * symmetric();
  measures[index_of(Measure::turn)] += 0.3 * symmetric();
  return measures;
}

TEST(Instrument, KeepsItsLengthsInEveryPose) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    const Drawn drawn = random_drawn(random);
    const Measures measures = disturbed(drawn.instrument.drawn, random);
    const auto pose = pose_of(drawn.instrument, measures, random_tracer(drawn.linkage, random));
    ASSERT_TRUE(pose);
    const auto lengths = lengths_of(measures).values;
    const std::array<double, 8> found{(pose->A - pose->V).norm(), (pose->B - pose->V).norm(),
                                      (pose->C - pose->A).norm(), (pose->C - pose->B).norm(),
                                      (pose->X - pose->A).norm(), (pose->X - pose->C).norm(),
                                      (pose->Y - pose->B).norm(), (pose->Y - pose->C).norm()};
    for (int j = 0; j < 8; ++j) EXPECT_NEAR(found[static_cast<std::size_t>(j)], lengths[j], 1e-8);
  }
}

TEST(Instrument, SlopesAgreeWithDifferencesInEveryMounting) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 200; ++i) {
    const Drawn drawn = random_drawn(random);
    const Instrument instrument = i % 2 ? drawn.instrument.exchanged() : drawn.instrument;
    const Measures measures = disturbed(drawn.instrument.drawn, random);
    Point input = random_tracer(drawn.linkage, random);
    if (i % 2) input = wanted_output(drawn.instrument, input);
    const auto output = output_at(instrument, measures, input);
    ASSERT_TRUE(output);
    for (int j = 0; j < measure_count; ++j) {
      const double step = j == index_of(Measure::turn) ? 1e-5 : 1e-3;
      Measures above = measures, below = measures;
      above[j] += step;
      below[j] -= step;
      const Point slope =
          (output_at(instrument, above, input)->at - output_at(instrument, below, input)->at) / (2 * step);
      EXPECT_LT((slope - output->by.col(j)).norm(), 1e-5 * (1 + output->by.col(j).norm())) << j;
    }
  }
}

TEST(Instrument, ExchangedIsTheInverseMap) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    const Drawn drawn = random_drawn(random);
    Measures measures = disturbed(drawn.instrument.drawn, random);
    measures.tail<3>().setZero();  // one frame for both
    const Point input = random_tracer(drawn.linkage, random);
    const auto output = output_at(drawn.instrument, measures, input);
    ASSERT_TRUE(output);
    const auto back = output_at(drawn.instrument.exchanged(), measures, output->at);
    ASSERT_TRUE(back);
    EXPECT_LT((back->at - input).norm(), 1e-7);
    EXPECT_LT(std::abs(drawn.instrument.ratio * drawn.instrument.exchanged().ratio - 1.0), 1e-12);
  }
}

TEST(Instrument, VariableRatioHalvesAtOneHalf) {
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  for (const double angle : {20.0, 30.0, 60.0, 80.0}) {
    const Point stylus(1000 * std::cos(radians(angle)), 0);
    const auto pencil = output_at(instrument, instrument.drawn, stylus);
    ASSERT_TRUE(pencil);
    EXPECT_LT((pencil->at - 0.5 * stylus).norm(), 1e-11);
    const auto pose = pose_of(instrument, instrument.drawn, stylus);
    EXPECT_GT(pose->C.y(), 0);
    EXPECT_NEAR(std::atan2(pose->C.y(), pose->C.x()), radians(angle), 1e-12);
  }
}

TEST(Instrument, SaysWhyItDoesNotClose) {
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  EXPECT_EQ(output_at(instrument, instrument.drawn, Point(1000.1, 0)).error(), ClosureFault::too_far);
  EXPECT_EQ(output_at(instrument, instrument.drawn, Point(1000, 0)).error(), ClosureFault::flat);
  Measures unequal = instrument.drawn;
  unequal[index_of(Measure::CX)] += 1;
  EXPECT_EQ(output_at(instrument, unequal, Point(0.5, 0)).error(), ClosureFault::too_near);
}

TEST(Instrument, MountedWithThePoleInTheMiddleReverses) {
  const Instrument erect = variable_ratio_instrument(400, 1.0 / 3);
  const Instrument reversed = erect.mounted({.pole = Joint::V, .input = Joint::Y, .output = Joint::X});
  EXPECT_LT(std::abs(reversed.ratio - Complex(-0.5)), 1e-15);
  const auto pencil = output_at(reversed, reversed.drawn, Point(300, 40));
  ASSERT_TRUE(pencil);
  EXPECT_LT((pencil->at - Point(-150, -20)).norm(), 1e-10);
}

}  // namespace
}  // namespace kempe
