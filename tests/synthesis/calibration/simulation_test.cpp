// Whole procedures played on instruments with hidden errors: what Knight's rounds and least squares are
// worth, where to measure, and what to set afterwards.
#include "synthesis/calibration/simulation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <atomic>
#include <cmath>

#include "synthesis/calibration/settings.hpp"
#include "synthesis/calibration/task.hpp"
#include "tests/synthesis/calibration/specimens.hpp"

namespace kempe {
namespace {

const std::optional<DrawnDesign> variable_ratio;  // no design: the instrument of [instrument]

/// A thousand instruments of 500 mm arms at 1/2, scale errors up to 1 mm.
Measurements knights_instruments(CalibrationMethod method, int readings, int rounds) {
  Measurements file;
  file.instrument = VariableRatioSpec{500, 0.5};
  file.fit.method = method;
  SimulationSpec simulation;
  simulation.instruments = 1000;
  simulation.largest_error = 1;
  simulation.resolution = 0.01;
  simulation.readings = readings;
  simulation.rounds = rounds;
  file.simulation = simulation;
  return file;
}

SimulationRecord played(const Measurements& file, const std::optional<DrawnDesign>& design,
                        std::uint64_t seed) {
  const std::atomic<bool> never = false;
  return simulate_calibration(
             file, design, seed, [](double) {}, never)
      .value();
}

TEST(CalibrationSimulation, KnightBringsEveryInstrumentBelowATenthWithinThreeRounds) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const SimulationRecord record =
        played(knights_instruments(CalibrationMethod::knight, 2, 3), variable_ratio, seed);
    EXPECT_EQ(record.instruments, 1000);
    EXPECT_EQ(record.failed, 0);
    EXPECT_GT(record.departure_mean, 1);
    EXPECT_LT(record.rounds.back().residual_largest, 0.1);
    EXPECT_EQ(record.rounds.back().reached, 1);
  }
}

TEST(CalibrationSimulation, LeastSquaresWithTenReadingsIsBelowThreeHundredthsAfterOneRound) {
  for (const double noise : {0.0, 0.005}) {
    Measurements file = knights_instruments(CalibrationMethod::least_squares, 10, 1);
    file.simulation->noise = noise;
    const SimulationRecord record = played(file, variable_ratio, 3);
    EXPECT_EQ(record.instruments, 1000);
    EXPECT_LT(record.rounds.front().residual_largest, 0.03) << noise;
  }
}

TEST(CalibrationSimulation, KnightsMechanicalConditionsDoNotSpoilIt) {
  Measurements file = knights_instruments(CalibrationMethod::knight, 2, 3);
  file.simulation->arm_error_percent = 0.006;
  file.simulation->bearing_error_percent = 0.003;
  EXPECT_LT(played(file, variable_ratio, 4).rounds.back().residual_largest, 0.1);
}

TEST(CalibrationSimulation, IntervalsHoldTheTruthAsOftenAsTheySay) {
  for (const CalibrationMethod method : {CalibrationMethod::knight, CalibrationMethod::least_squares}) {
    Measurements file = knights_instruments(method, method == CalibrationMethod::knight ? 2 : 10, 1);
    file.simulation->resolution = 0;
    file.simulation->noise = 0.01;
    const SimulatedRound round = played(file, variable_ratio, 5).rounds.front();
    EXPECT_EQ(round.intervals, 4000U);
    EXPECT_GT(round.coverage, 0.93);
    EXPECT_LT(round.coverage, 0.97);
  }
}

TEST(CalibrationSimulation, SameSeedSameRecord) {
  const Measurements file = knights_instruments(CalibrationMethod::knight, 2, 2);
  EXPECT_EQ(played(file, variable_ratio, 7).departure_mean, played(file, variable_ratio, 7).departure_mean);
  EXPECT_NE(played(file, variable_ratio, 7).departure_mean, played(file, variable_ratio, 8).departure_mean);
}

TEST(CalibrationJob, SaysWhatToGiveWhereThereAreNoReadings) {
  Measurements file = knights_instruments(CalibrationMethod::knight, 2, 1);
  file.simulation.reset();
  const auto record = run_calibration(file, variable_ratio, "file.toml");
  ASSERT_FALSE(record);
  EXPECT_NE(record.error().message().find("--plan"), std::string::npos) << record.error().message();
}

/// Knight's two readings of an instrument with scale errors, in as many rounds as corrections take.
TEST(CalibrationJob, RoundsAddUpToTheHiddenErrors) {
  calibration_specimens::Chance chance(9);
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  const Measures hidden =
      calibration_specimens::hidden_deviations(calibration_specimens::knights_scales, 1, chance);
  Measurements file;
  file.instrument = VariableRatioSpec{500, 0.5};
  Measures present = hidden;
  for (int round = 1; round <= 3; ++round) {
    for (const double degrees : {30.0, 60.0}) {
      ReadingSpec reading;
      reading.round = round;
      reading.arm_angle = radians(degrees);
      const Point stylus(1000 * std::cos(radians(degrees)), 0);
      reading.tracer = stylus;
      reading.error =
          output_at(instrument, instrument.drawn + present, stylus)->at - wanted_output(instrument, stylus);
      file.readings.push_back(reading);
    }
    const auto record = run_calibration(file, variable_ratio, "file.toml");
    ASSERT_TRUE(record) << record.error().message();
    ASSERT_EQ(record->rounds.size(), static_cast<std::size_t>(round));
    present = present - record->rounds.back().deviations;
    if (round == 3) {
      const ScaleErrors truth = scale_errors_of(hidden);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(record->total[i].error, truth.values()[i], 1e-6) << record->total[i].name;
    }
  }
  EXPECT_LT(present.cwiseAbs().maxCoeff(), 1e-6);
}

/// The determinant of what chosen readings would tell.
double told(const CalibrationTask& task, const std::vector<Candidate>& readings, double noise) {
  return information_of(task, readings, noise).determinant();
}

TEST(CalibrationPlan, TellsMoreThanEveryOtherChoiceOfAsManyReadings) {
  const Measurements file = knights_instruments(CalibrationMethod::least_squares, 2, 1);
  const TaskMaking making(file, variable_ratio);
  const std::vector<Candidate> all = candidates_on_axis(making.task(), 0, 500, radians(20), radians(70), 15);
  const double most = told(making.task(), d_optimal(making.task(), all, 4, 0.01), 0.01);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        for (std::size_t l = 0; l < k; ++l)
          EXPECT_LE(told(making.task(), {all[i], all[j], all[k], all[l]}, 0.01), most * (1 + 1e-9));
}

TEST(CalibrationPlan, StylusAndPencilExchangedTellMore) {
  // At 1/2 the pencil then moves twice as far as the stylus, and so do the errors.
  const Measurements file = knights_instruments(CalibrationMethod::least_squares, 2, 1);
  TaskMaking making(file, variable_ratio);
  const std::size_t exchanged = making.setup_number(making.reference_ratio(), true);
  const auto plain = candidates_on_axis(making.task(), 0, 500, radians(20), radians(70), 8);
  const auto enlarged = candidates_on_axis(making.task(), exchanged, 500, radians(20), radians(70), 8);
  EXPECT_GT(told(making.task(), enlarged, 0.01), told(making.task(), plain, 0.01));
  std::vector<Candidate> both = plain;
  both.insert(both.end(), enlarged.begin(), enlarged.end());
  for (const Candidate& chosen : d_optimal(making.task(), both, 8, 0.01)) EXPECT_EQ(chosen.setup, exchanged);
}

TEST(CalibrationSettings, PredictedErrorIsKeptByInstrumentsSetByTheTable) {
  // Instruments calibrated at 1/2 with noisy readings, then set for other ratios: true departures against the
  // prediction.
  calibration_specimens::Chance chance(11);
  int kept = 0, all = 0;
  for (int n = 0; n < 100; ++n) {
    const Measures hidden =
        calibration_specimens::hidden_deviations(calibration_specimens::knights_scales, 1, chance);
    CalibrationTask task;
    task.setups = {variable_ratio_instrument(500, 0.5)};
    task.readings = calibration_specimens::drawn_readings(
        task.setups[0], hidden, calibration_specimens::on_the_axis(500, 10), 0.01, chance);
    task.free = calibration_specimens::knights_scales;
    task.reading_uncertainty = 0.01;
    const auto found = calibrate(task);
    ASSERT_TRUE(found);
    SettingTask settings;
    settings.arm = 500;
    settings.deviations = found->deviations;
    settings.covariance = found->covariance;
    settings.coverage_factor = found->coverage_factor;
    for (const double ratio : {0.25, 0.5, 0.75}) {
      const SettingRow row = setting_for(settings, {"", ratio}, false);
      ASSERT_TRUE(row.impossible.empty()) << row.impossible;
      const Instrument set = variable_ratio_instrument(500, ratio);
      double departure = 0;
      for (double angle = 20; angle <= 70; angle += 2.5) {
        const Point stylus(1000 * std::cos(radians(angle)), 0);
        const auto at = output_at(set, set.drawn + hidden + deviations_of(row.corrections), stylus);
        departure = std::max(departure, (at->at - wanted_output(set, stylus)).norm());
      }
      ++all;
      kept += departure <= row.predicted ? 1 : 0;
    }
  }
  EXPECT_GT(static_cast<double>(kept) / all, 0.95);
}

}  // namespace
}  // namespace kempe
