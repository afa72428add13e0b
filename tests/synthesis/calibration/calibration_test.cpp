// Least-squares calibration: hidden deviations recovered, covered by their intervals, or named as not to be
// told.
#include "synthesis/calibration/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/calibration/knight.hpp"
#include "tests/synthesis/calibration/specimens.hpp"

namespace kempe {
namespace {

using namespace calibration_specimens;

CalibrationTask knights_task(const Measures& hidden, int count, double noise, Chance& chance) {
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  CalibrationTask task;
  task.setups = {instrument};
  task.readings = drawn_readings(instrument, hidden, on_the_axis(500, count), noise, chance);
  task.free = knights_scales;
  return task;
}

TEST(Calibration, ReturnsHiddenScaleErrorsWithoutNoise) {
  Chance chance(21);
  for (int i = 0; i < 200; ++i) {
    const Measures hidden = hidden_deviations(knights_scales, 1, chance);
    const auto found = calibrate(knights_task(hidden, 2 + i % 9, 0, chance));
    ASSERT_TRUE(found) << found.error().found;
    EXPECT_TRUE(found->indistinct.empty());
    EXPECT_LT((found->deviations - hidden).cwiseAbs().maxCoeff(), 1e-9);
  }
}

/// The deviations that the result calls determined, against the truth.
double determined_error(const Calibration& found, const Measures& hidden) {
  double largest = 0;
  for (int j = 0; j < measure_count; ++j)
    if (found.determined[j]) largest = std::max(largest, std::abs(found.deviations[j] - hidden[j]));
  return largest;
}

CalibrationTask task_over_the_reach(const CopyingLinkage& linkage, const std::vector<Measure>& free,
                                    const Measures& hidden, int count, double noise, Chance& chance) {
  CalibrationTask task;
  task.setups = {instrument_of(linkage)};
  task.readings =
      drawn_readings(task.setups[0], hidden, over_the_reach(linkage, count, chance), noise, chance);
  task.free = free;
  return task;
}

TEST(Calibration, WithoutNoiseReturnsEveryMeasureOrNamesTheCombination) {
  Chance chance(22);
  int complete = 0, all = 0;
  for (const CopyingLinkage& linkage : linkages())
    for (int i = 0; i < 20; ++i) {
      std::vector<Measure> free = links;
      if (i % 2) free.insert(free.end(), {Measure::pole_x, Measure::pole_y});
      const Measures hidden = hidden_deviations(free, 1, chance);
      const auto found = calibrate(task_over_the_reach(linkage, free, hidden, 24, 0, chance));
      ASSERT_TRUE(found) << found.error().found;
      EXPECT_LT(determined_error(*found, hidden), 1e-9);
      ++all;
      complete += found->indistinct.empty();
    }
  EXPECT_EQ(complete, all);
}

TEST(Calibration, WithNoiseNamesTheTwoSizesThatNoCopyTells) {
  // A parallelogram of any two sides copies alike as long as the plates fit it.
  Chance chance(23);
  for (const CopyingLinkage& linkage : linkages()) {
    const Measures hidden = hidden_deviations(links, 0.5, chance);
    const auto found = calibrate(task_over_the_reach(linkage, links, hidden, 14, 0.01, chance));
    ASSERT_TRUE(found) << found.error().found;
    ASSERT_EQ(found->indistinct.size(), 2u);
    for (const Indistinct& one : found->indistinct) {
      // Moving along the combination changes no copy: to first order of a thousandth of a millimetre,
      // nothing.
      Instrument moved = instrument_of(linkage);
      for (const auto& [measure, factor] : one.parts) moved.drawn[index_of(measure)] += 1e-3 * factor;
      for (const Point& input : over_the_reach(linkage, 20, chance))
        EXPECT_LT((output_at(moved, moved.drawn, input)->at - wanted_output(moved, input)).norm(), 1e-7);
    }
  }
}

TEST(Calibration, MeasuringTwoLengthsTellsAll) {
  Chance chance(24);
  for (const CopyingLinkage& linkage : linkages()) {
    const Measures hidden = hidden_deviations(links, 0.5, chance);
    CalibrationTask task = task_over_the_reach(linkage, links, hidden, 16, 0.01, chance);
    const auto made = lengths_of(task.setups[0].drawn + hidden).values;
    task.lengths = {{5, made[5], 0.01}, {7, made[7], 0.01}};  // CX, CY
    task.reading_uncertainty = 0.01;
    const auto found = calibrate(task);
    ASSERT_TRUE(found) << found.error().found;
    EXPECT_TRUE(found->indistinct.empty());
    for (const Measure measure : links) {
      const int j = index_of(measure);
      EXPECT_LT(std::abs(found->deviations[j] - hidden[j]), 4.5 * found->uncertainty(measure))
          << name(measure);
      EXPECT_LT(found->uncertainty(measure), 0.2);
    }
  }
}

TEST(Calibration, CorrectionsBringTheCopyRightEvenWhereLengthsCannotBeTold) {
  Chance chance(25);
  for (const CopyingLinkage& linkage : linkages())
    for (int i = 0; i < 10; ++i) {
      const Measures hidden = hidden_deviations(links, 0.5, chance);
      const CalibrationTask task = task_over_the_reach(linkage, links, hidden, 16, 0.01, chance);
      const auto found = calibrate(task);
      ASSERT_TRUE(found);
      EXPECT_GT(*departure_with(task, hidden, Measures::Zero()), 0.2);
      EXPECT_LT(*departure_with(task, hidden, -found->deviations), 0.1);
    }
}

struct Coverage {
  int inside = 0, all = 0;
  double share() const { return static_cast<double>(inside) / all; }
  void count(const Calibration& found, const Measures& hidden, const std::vector<Measure>& free) {
    for (const Measure measure : free) {
      if (!found.determined[index_of(measure)]) continue;
      ++all;
      const double half_width = found.coverage_factor * found.uncertainty(measure);
      inside += std::abs(found.deviations[index_of(measure)] - hidden[index_of(measure)]) <= half_width;
    }
  }
};

TEST(Calibration, IntervalsCoverKnightsScalesWithNoiseStatedOrEstimated) {
  Chance chance(26);
  Coverage stated, estimated;
  for (int i = 0; i < 1000; ++i) {
    const Measures hidden = hidden_deviations(knights_scales, 1, chance);
    CalibrationTask task = knights_task(hidden, 10, 0.01, chance);
    estimated.count(*calibrate(task), hidden, knights_scales);
    task.reading_uncertainty = 0.01;
    stated.count(*calibrate(task), hidden, knights_scales);
  }
  EXPECT_EQ(stated.all, 4000);
  EXPECT_GT(stated.share(), 0.93);
  EXPECT_LT(stated.share(), 0.97);
  EXPECT_GT(estimated.share(), 0.93);
  EXPECT_LT(estimated.share(), 0.97);
}

TEST(Calibration, IntervalsCoverAllLengthsOfEveryGrounding) {
  Chance chance(27);
  std::vector<Measure> free = links;
  free.insert(free.end(), {Measure::pole_x, Measure::pole_y});
  for (const CopyingLinkage& linkage : linkages()) {
    Coverage coverage, told;
    for (int i = 0; i < 300; ++i) {
      const Measures hidden = hidden_deviations(free, 0.5, chance);
      CalibrationTask task = task_over_the_reach(linkage, free, hidden, 16, 0.02, chance);
      told.count(*calibrate(task), hidden, free);
      const auto made = lengths_of(task.setups[0].drawn + hidden).values;
      task.lengths = {{5, made[5] + 0.02 * chance.normal(), 0.02},
                      {7, made[7] + 0.02 * chance.normal(), 0.02}};
      coverage.count(*calibrate(task), hidden, free);
    }
    EXPECT_EQ(coverage.all, 3000);
    EXPECT_GT(coverage.share(), 0.93);
    EXPECT_LT(coverage.share(), 0.97);
  }
}

TEST(Calibration, NamesTheReadingThatWasMistyped) {
  Chance chance(28);
  for (int i = 0; i < 100; ++i) {
    const Measures hidden = hidden_deviations(knights_scales, 1, chance);
    CalibrationTask task = knights_task(hidden, 10, 0.01, chance);
    const std::size_t wrong = static_cast<std::size_t>(i) % 10;
    task.readings[wrong].output += Point(0.3, -0.2);
    const auto found = calibrate(task);
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 10; ++j) EXPECT_EQ(found->readings[j].outlier, j == wrong) << i << " " << j;
    EXPECT_LT((found->deviations - hidden).cwiseAbs().maxCoeff(), 0.06);
    task.keep_outliers = true;
    const auto kept = calibrate(task);
    EXPECT_TRUE(kept->readings[wrong].outlier);
    EXPECT_GT((kept->deviations - hidden).cwiseAbs().maxCoeff(),
              (found->deviations - hidden).cwiseAbs().maxCoeff());
  }
}

TEST(Calibration, NamesTwoWrongReadingsThatHideEachOther) {
  Chance chance(29);
  for (int i = 0; i < 50; ++i) {
    CalibrationTask task = knights_task(hidden_deviations(knights_scales, 1, chance), 12, 0.01, chance);
    task.readings[5].output += Point(0.4, 0.4);
    task.readings[6].output += Point(0.4, 0.4);
    const auto found = calibrate(task);
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 12; ++j) EXPECT_EQ(found->readings[j].outlier, j == 5 || j == 6) << j;
  }
}

TEST(Calibration, HardlyEverNamesAGoodReading) {
  Chance chance(30);
  int named = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto found =
        calibrate(knights_task(hidden_deviations(knights_scales, 1, chance), 10, 0.01, chance));
    for (const ReadingFit& reading : found->readings) named += reading.outlier;
  }
  EXPECT_LE(named, 8);
}

TEST(Calibration, SaysThatTheReadingsAreWorseThanStated) {
  Chance chance(31);
  CalibrationTask task = knights_task(hidden_deviations(knights_scales, 1, chance), 12, 0.1, chance);
  task.reading_uncertainty = 0.01;
  const auto found = calibrate(task);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->noise_source, NoiseSource::larger_residuals);
  EXPECT_NEAR(found->noise, 0.1, 0.05);
}

// What is refused, and the words that help.

std::string refusal(const CalibrationTask& task) {
  const auto found = calibrate(task);
  return found ? "" : found.error().found + "; " + found.error().allowed;
}

TEST(Calibration, RefusesTooFewReadings) {
  Chance chance(32);
  const CopyingLinkage linkage = linkages()[0];
  const std::string words = refusal(task_over_the_reach(linkage, links, Measures::Zero(), 3, 0, chance));
  EXPECT_NE(words.find("3 readings for 8 unknown"), std::string::npos) << words;
  EXPECT_NE(words.find("at least 4"), std::string::npos) << words;
}

TEST(Calibration, RefusesReadingsAtOneOpening) {
  Chance chance(33);
  const CopyingLinkage linkage = linkages()[1];
  CalibrationTask task = task_over_the_reach(linkage, links, Measures::Zero(), 0, 0, chance);
  std::vector<Point> inputs;
  for (int i = 0; i < 10; ++i)
    inputs.push_back(linkage.tracer_at(linkage.assembly_mode().openings.middle(), 0.1 * i));
  task.readings = drawn_readings(task.setups[0], Measures::Zero(), inputs, 0, chance);
  EXPECT_NE(refusal(task).find("one opening"), std::string::npos) << refusal(task);
}

TEST(Calibration, RefusesPlacesOutOfReachAndGuessesTheUnit) {
  Chance chance(34);
  CalibrationTask task = knights_task(Measures::Zero(), 10, 0, chance);
  task.readings[3].input *= 10;
  EXPECT_NE(refusal(task).find("beyond the reach"), std::string::npos) << refusal(task);
  EXPECT_EQ(calibrate(task).error().reading, 3u);
  task = knights_task(Measures::Zero(), 10, 0, chance);
  for (auto& reading : task.readings) reading.output /= 25.4;
  EXPECT_NE(refusal(task).find("25.4"), std::string::npos) << refusal(task);
}

TEST(Calibration, RefusesExchangedPlaces) {
  Chance chance(35);
  CalibrationTask task = knights_task(Measures::Zero(), 10, 0, chance);
  for (auto& reading : task.readings) std::swap(reading.input, reading.output);
  EXPECT_NE(refusal(task).find("exchanged?"), std::string::npos) << refusal(task);
}

TEST(Calibration, SameTaskSameBytes) {
  Chance chance(36);
  const CalibrationTask task = knights_task(hidden_deviations(knights_scales, 1, chance), 10, 0.01, chance);
  const auto a = calibrate(task), b = calibrate(task);
  EXPECT_EQ(a->deviations, b->deviations);
  EXPECT_EQ(a->covariance, b->covariance);
}

}  // namespace
}  // namespace kempe
