#include "synthesis/function_generator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "synthesis/precision_points.hpp"

namespace kempe {
namespace {

FunctionTask logarithm() {
  FunctionTask task;
  task.wanted = [](double x) { return std::log10(x); };
  task.x_lower = 1;
  task.x_upper = 2;
  task.input_range = radians(60);
  task.output_range = radians(90);
  task.ground = 100;
  return task;
}

/// Distance of generated from wanted value at x, by interpolation-free evaluation of the linkage.
double miss_at(const FunctionTask& task, const FunctionDesign& design, double x) {
  const double phi = design.input_start + task.input_range * (x - task.x_lower) / (task.x_upper - task.x_lower);
  const double psi = design.output_start +
                     task.output_range * (task.wanted(x) - design.y_lower) / (design.y_upper - design.y_lower);
  return std::remainder(design.linkage.output_angle(phi).value() - psi, 2 * pi);
}

TEST(PrecisionPoints, AreTheReportsWithItsArithmeticMended) {
  const auto x = chebyshev_points(5.6, 7.5, 3);
  ASSERT_EQ(x.size(), 3U);
  EXPECT_NEAR(x[0], 7.37272, 5e-6);  // the report prints 7.3127
  EXPECT_NEAR(x[1], 6.55, 1e-12);
  EXPECT_NEAR(x[2], 5.72728, 5e-6);  // the report prints 5.787
}

TEST(FunctionGenerator, IsExactAtItsPrecisionPoints) {
  for (const int points : {3, 4, 5}) {
    FunctionTask task = logarithm();
    task.points = points;
    const auto design = generate_function(task);
    ASSERT_TRUE(design) << points << ": " << design.error().sentence;
    ASSERT_EQ(design->precision_points.size(), static_cast<std::size_t>(points));
    for (const double x : design->precision_points) EXPECT_NEAR(miss_at(task, *design, x), 0, 1e-9) << points;
  }
}

TEST(FunctionGenerator, GivenStartsSolveInClosedForm) {
  FunctionTask task = logarithm();
  task.input_start = radians(45);
  task.output_start = radians(-40);
  const auto design = generate_function(task);
  if (!design) GTEST_FAIL() << design.error().sentence;
  for (const double x : design->precision_points) EXPECT_NEAR(miss_at(task, *design, x), 0, 1e-12);
}

TEST(FunctionGenerator, MorePointsAndMinimaxMakeTheErrorSmaller) {
  FunctionTask task = logarithm();
  const double three = generate_function(task)->error_largest;
  task.points = 5;
  const double five = generate_function(task)->error_largest;
  task.points = 3;
  task.method = FunctionMethod::minimax;
  const auto minimax = generate_function(task);
  task.method = FunctionMethod::least_squares;
  const auto squares = generate_function(task);
  EXPECT_LE(minimax->error_largest, three);
  EXPECT_LE(minimax->error_largest, 1.0001 * five);
  EXPECT_LE(minimax->error_largest, 1.0001 * squares->error_largest);
  EXPECT_LE(squares->error_rms, 1.0001 * minimax->error_rms);
}

TEST(FunctionGenerator, MinimaxRipplesAreEqual) {
  FunctionTask task = logarithm();
  task.method = FunctionMethod::minimax;
  const auto design = generate_function(task);
  ASSERT_TRUE(design);
  int ripples = 0;
  for (std::size_t i = 0; i < design->curve.size(); ++i) {
    const double here = design->curve[i].error;
    const bool first = i == 0, last = i + 1 == design->curve.size();
    const double left = first ? 0 : design->curve[i - 1].error, right = last ? 0 : design->curve[i + 1].error;
    if (std::abs(here) >= std::abs(left) && std::abs(here) >= std::abs(right) &&
        std::abs(here) > 0.97 * design->error_largest)
      ++ripples;
  }
  EXPECT_GE(ripples, 4);
}

TEST(FunctionGenerator, FindsALinkageThatIsKnownToGenerateTheFunction) {
  std::mt19937_64 random(7);
  int tried = 0;
  while (tried < 5) {
    const auto uniform = [&](double lower, double upper) {
      return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const FourBar hidden{100, uniform(40, 150), uniform(80, 200), uniform(40, 150)};
    const double start = uniform(-2, 2), range = 1.0;
    bool closes = true;
    for (int i = 0; i <= 20; ++i) closes = closes && hidden.closure_margin(start + range * i / 20) > 0.05;
    if (!closes) continue;
    const double first = *hidden.output_angle(start), last = *hidden.output_angle(start + range);
    const double turn = std::remainder(last - first, 2 * pi);
    bool monotone = std::abs(turn) > 0.3;
    for (int i = 1; i <= 50; ++i)
      monotone = monotone && turn * std::remainder(*hidden.output_angle(start + range * i / 50) -
                                                   *hidden.output_angle(start + range * (i - 1) / 50), 2 * pi) > 0;
    if (!monotone) continue;
    ++tried;
    FunctionTask task;
    task.wanted = [=](double x) {
      return std::remainder(*hidden.output_angle(start + range * x) - first, 2 * pi) * (turn > 0 ? 1 : -1);
    };
    task.input_range = range;
    task.output_range = turn;
    task.input_start = start;
    task.output_start = first;
    const auto design = generate_function(task);
    ASSERT_TRUE(design) << design.error().sentence;
    EXPECT_LT(design->error_largest, 1e-9);
    EXPECT_NEAR(design->linkage.input, hidden.input, 1e-6);
    EXPECT_NEAR(design->linkage.output, hidden.output, 1e-6);
  }
}

TEST(FunctionGenerator, KeepsTheTransmissionLimit) {
  FunctionTask task = logarithm();
  task.transmission = radians(35);
  task.method = FunctionMethod::minimax;
  const auto design = generate_function(task);
  ASSERT_TRUE(design);
  EXPECT_GE(design->transmission_min, task.transmission - 1e-9);
}

TEST(FunctionGenerator, SaysWhyThereIsNone) {
  FunctionTask constant = logarithm();
  constant.wanted = [](double) { return 1.0; };
  EXPECT_FALSE(generate_function(constant));
  FunctionTask pole = logarithm();
  pole.wanted = [](double x) { return 1 / (x - 1.5); };
  EXPECT_FALSE(generate_function(pole));
  FunctionTask steep = logarithm();
  steep.transmission = radians(89);
  const auto none = generate_function(steep);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().commonest, FunctionDefect::transmission);
}

}  // namespace
}  // namespace kempe
