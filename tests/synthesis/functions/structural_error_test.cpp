// Fits whose best error is known in closed form: Chebyshev polynomials, lines under convex functions,
// rational families.
#include "synthesis/functions/structural_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/point.hpp"
#include "synthesis/functions/precision_points.hpp"
#include "tests/random.hpp"

namespace kempe {
namespace {

/// Polynomials of degree n - 1 against a function.
StructuralErrorTask polynomial_task(std::function<double(double)> wanted, int parameters, double lower,
                                    double upper) {
  StructuralErrorTask task;
  task.residual = [wanted](double x, const Eigen::VectorXd& p,
                           Eigen::VectorXd* gradient) -> std::optional<double> {
    double sum = -wanted(x), power = 1;
    for (Eigen::Index i = 0; i < p.size(); ++i, power *= x) {
      sum += p[i] * power;
      if (gradient) (*gradient)[i] = power;
    }
    return sum;
  };
  task.lower = lower;
  task.upper = upper;
  task.start = Eigen::VectorXd::Zero(parameters);
  return task;
}

TEST(StructuralError, MonomialsLeaveTheChebyshevPolynomial) {
  for (int n = 2; n <= 8; ++n) {
    const auto task = polynomial_task([n](double x) { return std::pow(x, n); }, n, -1, 1);
    const double least = std::pow(2.0, 1 - n);
    const auto minimax = fit_minimax(task);
    ASSERT_TRUE(minimax) << n;
    EXPECT_EQ(minimax->verdict, FitVerdict::equal_ripples);
    EXPECT_NEAR(minimax->largest, least, 1e-9 * least);
    EXPECT_EQ(minimax->ripples.size(), static_cast<std::size_t>(n) + 1);
    EXPECT_NEAR(minimax->evenness(), 1, 1e-8);
    // Here Chebyshev's points do as well: the structural error between them is the same polynomial.
    const auto points = fit_through_chebyshev_points(task);
    ASSERT_TRUE(points) << n;
    EXPECT_NEAR(points->largest, least, 1e-9 * least);
    std::vector<double> zeros = chebyshev_points(-1, 1, n);
    std::reverse(zeros.begin(), zeros.end());
    ASSERT_EQ(points->zeros.size(), zeros.size());
    ASSERT_EQ(minimax->zeros.size(), zeros.size());
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      EXPECT_NEAR(points->zeros[i], zeros[i], 1e-9);
      EXPECT_NEAR(minimax->zeros[i], zeros[i], 1e-7);
    }
  }
}

TEST(StructuralError, TheBestLineUnderTheExponentialHasItsClosedForm) {
  // Slope m = (e^b - e^a)/(b - a) touches at ln m; the three errors e^a - m a - c, m - m ln m - c are
  // opposite.
  for (const auto& [a, b] : {std::pair{0.0, 1.0}, {-1.0, 2.0}, {0.3, 0.31}}) {
    const double m = (std::exp(b) - std::exp(a)) / (b - a);
    const double least = 0.5 * ((std::exp(a) - m * a) - (m - m * std::log(m)));
    const auto fit = fit_minimax(polynomial_task([](double x) { return std::exp(x); }, 2, a, b));
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->verdict, FitVerdict::equal_ripples);
    EXPECT_NEAR(fit->largest, least, 1e-7 * least);
    EXPECT_NEAR(fit->parameters[1], m, 1e-6 * m);
  }
}

TEST(StructuralError, TheBestLineUnderTheHyperbolaHasItsClosedForm) {
  const double a = 1, b = 3, least = std::pow(std::sqrt(b) - std::sqrt(a), 2) / (2 * a * b);
  const auto fit = fit_minimax(polynomial_task([](double x) { return 1 / x; }, 2, a, b));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->largest, least, 1e-9);
}

TEST(StructuralError, LeastSquaresLeavesTheLegendrePolynomial) {
  // x^3 less its best parabola is the monic Legendre polynomial x^3 - 3x/5, whose mean square is 4/175.
  const auto fit = fit_least_squares(polynomial_task([](double x) { return x * x * x; }, 3, -1, 1));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[1], 0.6, 1e-4);
  EXPECT_NEAR(fit->rms, std::sqrt(4.0 / 175), 1e-4);
}

/// a / (b + x), nonlinear in b.
StructuralErrorTask hyperbola_task(std::function<double(double)> wanted, double lower, double upper) {
  StructuralErrorTask task;
  task.residual = [wanted](double x, const Eigen::VectorXd& p,
                           Eigen::VectorXd* gradient) -> std::optional<double> {
    const double under = p[1] + x;
    if (!(under > 0)) return std::nullopt;
    if (gradient) *gradient << 1 / under, -p[0] / (under * under);
    return p[0] / under - wanted(x);
  };
  task.lower = lower;
  task.upper = upper;
  task.start = Eigen::Vector2d(1, 1);
  return task;
}

TEST(StructuralError, ANonlinearFamilyLevelsItsRipples) {
  const auto task = hyperbola_task([](double x) { return std::exp(-x); }, 0, 2);
  const auto points = fit_through_chebyshev_points(task);
  const auto squares = fit_least_squares(task);
  const auto minimax = fit_minimax(task);
  ASSERT_TRUE(points && squares && minimax);
  EXPECT_EQ(minimax->verdict, FitVerdict::equal_ripples);
  EXPECT_EQ(minimax->ripples.size(), 3U);
  EXPECT_LT(minimax->largest, squares->largest);
  EXPECT_LT(minimax->largest, points->largest);
  EXPECT_LT(squares->rms, minimax->rms);
  EXPECT_LT(squares->rms, points->rms);
  // No neighbour on a fine grid does better.
  for (int i = -50; i <= 50; ++i)
    for (int j = -50; j <= 50; ++j) {
      const Eigen::VectorXd p = minimax->parameters + Eigen::Vector2d(i, j) * 2e-3;
      double largest = 0;
      for (int n = 0; n <= 200; ++n)
        largest = std::max(largest, std::abs(*task.residual(0.01 * n, p, nullptr)));
      EXPECT_GE(largest, minimax->largest * (1 - 1e-4));
    }
}

TEST(StructuralError, FindsAnExactMemberOfTheFamily) {
  const auto task = hyperbola_task([](double x) { return 3 / (2.5 + x); }, 0, 4);
  for (const auto& fit : {fit_through_chebyshev_points(task), fit_least_squares(task), fit_minimax(task)}) {
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->parameters[0], 3, 1e-6);
    EXPECT_NEAR(fit->parameters[1], 2.5, 1e-6);
    EXPECT_LT(fit->largest, 1e-7);
  }
}

// Law: for any smooth function minimax <= precision points and minimax <= least squares in the largest error,
// least squares <= both in the mean square; the least ripple is a lower bound (de la Vallee Poussin) for
// polynomials.
TEST(StructuralError, EachWayIsBestByItsOwnMeasure) {
  std::mt19937_64 random(1);
  const auto uniform = [&random](double lower, double upper) { return test::uniform(random, lower, upper); };
  for (int n = 0; n < 100; ++n) {
    const double a = uniform(0.5, 2), b = uniform(-2, 2), c = uniform(0.2, 1), lower = uniform(-2, 1);
    const auto wanted = [=](double x) { return std::exp(c * x) + std::sin(a * x + b); };
    const auto task = polynomial_task(wanted, 2 + n % 5, lower, lower + uniform(0.5, 2));
    const auto points = fit_through_chebyshev_points(task);
    const auto squares = fit_least_squares(task);
    const auto minimax = fit_minimax(task);
    ASSERT_TRUE(points && squares && minimax) << n;
    EXPECT_EQ(minimax->verdict, FitVerdict::equal_ripples) << n;
    EXPECT_LE(minimax->largest, points->largest * (1 + 1e-9));
    EXPECT_LE(minimax->largest, squares->largest * (1 + 1e-9));
    EXPECT_LE(squares->rms, points->rms * (1 + 1e-6));
    EXPECT_LE(squares->rms, minimax->rms * (1 + 1e-6));
    if (points->ripples.size() > static_cast<std::size_t>(task.start.size())) {
      double least = points->largest;
      for (const Ripple& ripple : points->ripples) least = std::min(least, std::abs(ripple.error));
      EXPECT_LE(least, minimax->largest * (1 + 1e-9));
    }
    for (std::size_t i = 1; i < minimax->ripples.size(); ++i)
      EXPECT_LT(minimax->ripples[i - 1].error * minimax->ripples[i].error, 0);
  }
}

TEST(StructuralError, SaysWhyThereIsNoFit) {
  auto twice = polynomial_task([](double x) { return x * x; }, 2, -1, 1);
  twice.residual = [](double x, const Eigen::VectorXd& p,
                      Eigen::VectorXd* gradient) -> std::optional<double> {
    if (gradient) *gradient << x, x;  // two names for one parameter
    return (p[0] + p[1]) * x - x * x;
  };
  EXPECT_EQ(fit_through_chebyshev_points(twice).error(), NoFit::dependent);
  EXPECT_EQ(fit_least_squares(twice).error(), NoFit::dependent);
  EXPECT_EQ(fit_minimax(twice).error(), NoFit::dependent);
  auto nowhere = hyperbola_task([](double x) { return x; }, 0, 1);
  nowhere.start = Eigen::Vector2d(1, -5);
  EXPECT_EQ(fit_least_squares(nowhere).error(), NoFit::not_defined);
  EXPECT_EQ(fit_through_points(nowhere, {0.5}).error(), NoFit::dependent);
}

TEST(StructuralError, AdmitsWhenTheRipplesAreTooFew) {
  // A constant and its shift in x of an odd function: the theorem's condition fails, the best error is not
  // levelled.
  StructuralErrorTask task = polynomial_task([](double x) { return x; }, 2, -1, 1);
  task.residual = [](double x, const Eigen::VectorXd& p, Eigen::VectorXd* gradient) -> std::optional<double> {
    if (gradient) *gradient << 1, x * x * x * x;
    return p[0] + p[1] * x * x * x * x - x;
  };
  const auto fit = fit_minimax(task);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->verdict, FitVerdict::fewer_ripples);
  EXPECT_NEAR(fit->largest, 1, 1e-6);
}

}  // namespace
}  // namespace kempe
