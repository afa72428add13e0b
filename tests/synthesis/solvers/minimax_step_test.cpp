// The linear program of a minimax step against what random points and its own multipliers say.
#include "synthesis/solvers/minimax_step.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}
  double operator()() { return 2 * test::share(random_) - 1; }
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return (*this)(); });
  }

 private:
  std::mt19937_64 random_;
};

MinimaxProgram random_program(Chance& chance, Eigen::Index unknowns, Eigen::Index figures,
                              Eigen::Index limits) {
  MinimaxProgram program;
  program.figure_slopes = chance.matrix(figures, unknowns);
  program.figures = chance.matrix(figures, 1);
  program.limit_slopes = chance.matrix(limits, unknowns);
  program.limits = chance.matrix(limits, 1).cwiseAbs() * -0.05;  // d = 0 keeps them
  program.box = 0.3;
  return program;
}

double highest(const MinimaxProgram& program, const Eigen::VectorXd& d) {
  return (program.figures + program.figure_slopes * d).maxCoeff();
}

TEST(MinimaxStep, KeepsEveryConditionAndIsBelowEveryRandomPoint) {
  Chance chance(1);
  for (int n = 0; n < 300; ++n) {
    const MinimaxProgram program = random_program(chance, 1 + n % 5, 20 + n % 40, n % 7);
    const auto step = solve_minimax_step(program);
    ASSERT_TRUE(step) << n;
    EXPECT_LE(step->d.cwiseAbs().maxCoeff(), program.box + 1e-9);
    EXPECT_NEAR(highest(program, step->d), step->t, 1e-9);
    if (program.limits.size() > 0) {
      EXPECT_LE((program.limits + program.limit_slopes * step->d).maxCoeff(), 1e-9);
    }
    for (int i = 0; i < 300; ++i) {
      const Eigen::VectorXd d = program.box * chance.matrix(program.figure_slopes.cols(), 1);
      if (program.limits.size() > 0 && (program.limits + program.limit_slopes * d).maxCoeff() > 0) continue;
      EXPECT_GE(highest(program, d), step->t - 1e-9);
    }
  }
}

TEST(MinimaxStep, MultipliersProveTheOptimum) {
  // Duality: where the box does not hold the step, t equals the multipliers' mean of figures and limits at d
  // = 0.
  Chance chance(2);
  int inside = 0;
  for (int n = 0; n < 300; ++n) {
    MinimaxProgram program = random_program(chance, 3, 60, 4);
    program.box = 5;
    const auto step = solve_minimax_step(program);
    ASSERT_TRUE(step);
    EXPECT_GE(step->figure_multipliers.minCoeff(), 0);
    EXPECT_GE(step->limit_multipliers.minCoeff(), 0);
    EXPECT_NEAR(step->figure_multipliers.sum(), 1, 1e-9);
    if (step->at_box) continue;
    ++inside;
    EXPECT_NEAR(step->figure_multipliers.dot(program.figures) + step->limit_multipliers.dot(program.limits),
                step->t, 1e-9);
    EXPECT_LT((program.figure_slopes.transpose() * step->figure_multipliers +
               program.limit_slopes.transpose() * step->limit_multipliers)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
  }
  EXPECT_GT(inside, 200);
}

TEST(MinimaxStep, SaysThatContradictingLimitsCannotBeKept) {
  MinimaxProgram program;
  program.figure_slopes = Eigen::MatrixXd::Constant(1, 2, 1);
  program.figures = Eigen::VectorXd::Constant(1, 1);
  program.limit_slopes.resize(2, 2);
  program.limit_slopes << 1, 0, -1, 0;
  program.limits = Eigen::Vector2d(0.5, 0.5);  // d_0 <= -0.5 and d_0 >= 0.5
  EXPECT_FALSE(solve_minimax_step(program));
}

}  // namespace
}  // namespace kempe
