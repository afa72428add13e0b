// Readings that stand out: how often a good one is named, how often a wrong one is found, stated noise or not, one wrong
// reading or several that hide each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "synthesis/calibration/calibration.hpp"
#include "synthesis/calibration/statistics.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/calibration/specimens.hpp"

namespace kempe {
namespace {

using namespace calibration_specimens;

constexpr double sigma = 0.01;

/// Knight's instrument read at some places on its axis.
CalibrationTask knights(int count, bool stated, Chance& chance) {
  const Instrument instrument = variable_ratio_instrument(500, 0.5);
  CalibrationTask task;
  task.setups = {instrument};
  task.readings = drawn_readings(instrument, hidden_deviations(knights_scales, 1, chance),
                                 on_the_axis(500, count), sigma, chance);
  task.free = knights_scales;
  if (stated) task.reading_uncertainty = sigma;
  return task;
}

/// A plotter with all its links and its pole free, two lengths taken with a ruler.
CalibrationTask plotter(int count, bool stated, Chance& chance) {
  const CopyingLinkage linkage = linkages()[0];
  std::vector<Measure> free = links;
  free.insert(free.end(), {Measure::pole_x, Measure::pole_y});
  const Measures hidden = hidden_deviations(free, 0.5, chance);
  CalibrationTask task;
  task.setups = {instrument_of(linkage)};
  task.readings =
      drawn_readings(task.setups[0], hidden, over_the_reach(linkage, count, chance), sigma, chance);
  task.free = free;
  const auto made = lengths_of(task.setups[0].drawn + hidden).values;
  for (const std::size_t length : {std::size_t{5}, std::size_t{7}})
    task.lengths.push_back(
        {length, made[static_cast<Eigen::Index>(length)] + sigma * chance.normal(), sigma});
  if (stated) task.reading_uncertainty = sigma;
  return task;
}

using Making = CalibrationTask (*)(int, bool, Chance&);

std::vector<std::size_t> named(const CalibrationTask& task) {
  const auto found = calibrate(task);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; found && i < found->readings.size(); ++i)
    if (found->readings[i].outlier) all.push_back(i);
  return all;
}

/// Some readings made wrong by so many times the noise, each in a direction of its own.
std::vector<std::size_t> spoil(CalibrationTask& task, std::size_t count, double times, Chance& chance) {
  std::vector<std::size_t> wrong;
  while (wrong.size() < count) {
    const auto i = static_cast<std::size_t>(chance.uniform(0, static_cast<double>(task.readings.size())));
    if (std::find(wrong.begin(), wrong.end(), i) != wrong.end()) continue;
    wrong.push_back(i);
    const double direction = chance.uniform(0, 2 * pi);
    task.readings[i].output += times * sigma * Point(std::cos(direction), std::sin(direction));
  }
  std::sort(wrong.begin(), wrong.end());
  return wrong;
}

double share_named(Making make, int count, bool stated, int instruments, std::uint64_t seed) {
  Chance chance(seed);
  int fits = 0;
  for (int i = 0; i < instruments; ++i) fits += !named(make(count, stated, chance)).empty();
  return static_cast<double>(fits) / instruments;
}

TEST(CalibrationOutliers, GoodReadingsAreNamedInAtMostOneOfAThousandFits) {
  // Of 2,000 fits two are allowed on the average; 8 by chance once in a thousand such tests.
  const int fits = test::samples(2000), allowed = 8;
  for (const bool stated : {true, false}) {
    EXPECT_LE(share_named(knights, 10, stated, fits, 41) * fits, allowed) << stated;
    EXPECT_LE(share_named(knights, 5, stated, fits, 42) * fits, allowed) << stated;
    EXPECT_LE(share_named(plotter, 12, stated, fits / 4, 44) * fits / 4, 4) << stated;
  }
  // Not far below it either: the estimated noise uses what is allowed.
  if (!test::shortened()) {
    EXPECT_GE(share_named(knights, 10, false, 8000, 45), 3e-4);
  }
}

struct Detection {
  double exactly = 0, good_named = 0;  ///< shares of the fits
};
Detection detection(Making make, int count, bool stated, std::size_t wrong_count, double times) {
  Chance chance(100);
  Detection share;
  const int fits = test::samples(100);
  for (int i = 0; i < fits; ++i) {
    CalibrationTask task = make(count, stated, chance);
    const auto wrong = spoil(task, wrong_count, times, chance);
    const auto found = named(task);
    share.exactly += (found == wrong ? 1.0 : 0.0) / fits;
    const bool good = !std::includes(wrong.begin(), wrong.end(), found.begin(), found.end());
    share.good_named += (good ? 1.0 : 0.0) / fits;
  }
  return share;
}

TEST(CalibrationOutliers, WrongReadingsAreNamedAloneOrTogetherAndNoGoodOneWithThem) {
  struct Asked {
    Making make;
    int count;
    bool stated;
    std::size_t wrong;
    double times, at_least;
  };
  for (const Asked& one : {
           Asked{knights, 10, true, 1, 5, 0.35}, {knights, 10, true, 1, 10, 0.9},
           {knights, 10, true, 1, 50, 0.99},     {knights, 10, true, 1, 500, 0.99},
           {knights, 10, true, 2, 10, 0.8},      {knights, 10, true, 2, 50, 0.97},
           {knights, 10, true, 3, 20, 0.95},     {knights, 10, true, 3, 500, 0.97},
           {knights, 10, false, 1, 10, 0.85},    {knights, 10, false, 2, 20, 0.95},
           {knights, 10, false, 3, 50, 0.95},    {knights, 10, false, 3, 500, 0.97},
           {plotter, 12, true, 1, 20, 0.9},      {plotter, 12, true, 2, 50, 0.9},
           {plotter, 12, true, 3, 500, 0.97},    {plotter, 12, false, 1, 20, 0.9},
           {plotter, 12, false, 3, 500, 0.95},   {plotter, 20, true, 3, 20, 0.95},
           {knights, 10, true, 1, 5000, 0.97},   {plotter, 12, true, 1, 5000, 0.97},
       }) {
    const Detection share = detection(one.make, one.count, one.stated, one.wrong, one.times);
    if (!test::shortened()) {
      EXPECT_GE(share.exactly, one.at_least) << one.count << " readings, " << one.wrong << " wrong by "
                                             << one.times << ", stated " << one.stated;
      EXPECT_LE(share.good_named, 0.02);
    }
  }
}

TEST(CalibrationOutliers, StatingTheNoiseHidesNoneThatIsFoundWithoutIt) {
  Chance chance(7);
  for (int i = 0; i < 100; ++i) {
    CalibrationTask task = knights(10, false, chance);
    const auto wrong = spoil(task, 1 + static_cast<std::size_t>(i) % 3, 30, chance);
    const auto without = named(task);
    task.reading_uncertainty = sigma;
    const auto with = named(task);
    EXPECT_TRUE(std::includes(with.begin(), with.end(), without.begin(), without.end())) << i;
    const auto found = calibrate(task);
    if (with == wrong) {
      EXPECT_NEAR(found->noise, sigma, 1e-12) << i;
      EXPECT_TRUE(found->otherwise.has_value());
    }
  }
}

TEST(CalibrationOutliers, ContradictionWithTheStatedNoiseIsToldWhereNoReadingIsToBlame) {
  Chance chance(8);
  for (int i = 0; i < 50; ++i) {
    CalibrationTask task = knights(12, true, chance);
    const auto well = calibrate(task);
    ASSERT_TRUE(well && well->check);
    EXPECT_EQ(well->check->freedom, 20);
    task.reading_uncertainty = sigma / 10;
    const auto worse = calibrate(task);
    EXPECT_TRUE(worse->check->contradicts());
    EXPECT_EQ(worse->noise_source, NoiseSource::larger_residuals);
    for (const ReadingFit& reading : worse->readings) EXPECT_FALSE(reading.outlier) << i;
  }
}

TEST(CalibrationOutliers, ThreeReadingsCannotTellWhichOfThemIsWrong) {
  Chance chance(9);
  for (int i = 0; i < 100; ++i) {
    CalibrationTask task = knights(3, true, chance);
    spoil(task, 1, 100, chance);
    const auto found = calibrate(task);
    ASSERT_TRUE(found && found->check);
    for (const ReadingFit& reading : found->readings) EXPECT_FALSE(reading.outlier);
    EXPECT_TRUE(found->check->contradicts() || found->check->chi_squared < 20);
  }
}

TEST(CalibrationStatistics, ChiSquaredIsItsDensitysIntegral) {
  for (const int freedom : {1, 2, 3, 4, 7, 16, 45, 200})
    for (const double share : {0.3, 1.0, 1.7, 3.0}) {
      const double value = share * freedom, end = value + 60 * std::sqrt(2.0 * freedom) + 400;
      double sum = 0;
      constexpr int places = 200000;
      for (int i = 0; i < places; ++i) {
        const double x = value + (end - value) * (i + 0.5) / places;
        sum += std::exp((0.5 * freedom - 1) * std::log(x) - 0.5 * x - 0.5 * freedom * std::log(2.0) -
                        std::lgamma(0.5 * freedom));
      }
      EXPECT_NEAR(chi_squared_upper_probability(value, freedom), sum * (end - value) / places, 2e-4)
          << freedom;
    }
}

}  // namespace
}  // namespace kempe
