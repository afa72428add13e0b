// Both local solvers on programs whose solutions are printed: with inequalities and equalities, without a Hessian.
#include <gtest/gtest.h>

#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {
namespace {

using Eigen::VectorXd;

/// Problem 71 of Hock and Schittkowski, Test Examples for Nonlinear Programming Codes (1981): the least a d (a + b + c) + c with
/// a b c d >= 25 and a^2 + b^2 + c^2 + d^2 = 40, all between 1 and 5.
LongProgram problem_71() {
  LongProgram program{.lower = VectorXd::Constant(4, 1), .upper = VectorXd::Constant(4, 5)};
  program.objective = [](const VectorXd& x, VectorXd* gradient) {
    const double sum = x[0] + x[1] + x[2];
    if (gradient) *gradient = Eigen::Vector4d(x[3] * (sum + x[0]), x[0] * x[3], x[0] * x[3] + 1, x[0] * sum);
    return x[0] * x[3] * sum + x[2];
  };
  program.constraint_count = 1;
  program.constraints = [](const VectorXd& x, ConstraintValues& values, ConstraintGradients* gradients) {
    values[0] = x.prod() - 25;
    if (gradients) gradients->row(0) = x.prod() * x.cwiseInverse();
  };
  program.equality_count = 1;
  program.equalities = [](const VectorXd& x, ConstraintValues& values, ConstraintGradients* gradients) {
    values[0] = x.squaredNorm() - 40;
    if (gradients) gradients->row(0) = 2 * x;
  };
  return program;
}

void expect_printed_solution(const LongResult& result) {
  EXPECT_TRUE(result.usable);
  EXPECT_GT(result.evaluations, 3);
  ASSERT_EQ(result.x.size(), 4);
  const Eigen::Vector4d printed(1, 4.7429994, 3.8211503, 1.3794082);
  EXPECT_LT((result.x - printed).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_NEAR(problem_71().objective(result.x, nullptr), 17.0140173, 1e-6);
}

TEST(LocalSolvers, ReachThePrintedSolution) {
  const VectorXd start = Eigen::Vector4d(1, 5, 5, 1);
  expect_printed_solution(minimize_by_sqp(problem_71(), start, 400));
  expect_printed_solution(polish(problem_71(), start));
}

/// The least square of a number of lines' distances from a place, whose normal equations hold at the end.
TEST(LocalSolvers, MeetTheNormalEquations) {
  Eigen::MatrixXd lines(6, 3);
  lines << 1, 2, -1, 0.5, -1, 2, 2, 0.3, 1, -1, 1, 1, 0.2, 0.7, -0.4, 1.5, -2, 0.1;
  const VectorXd offsets = (VectorXd(6) << 1, -0.5, 0.7, 0.2, 1.1, -0.3).finished();
  LongProgram program{.lower = VectorXd::Constant(3, -10), .upper = VectorXd::Constant(3, 10)};
  program.objective = [&](const VectorXd& x, VectorXd* gradient) {
    const VectorXd distances = lines * x - offsets;
    if (gradient) *gradient = 2 * lines.transpose() * distances;
    return distances.squaredNorm();
  };
  const VectorXd start = VectorXd::Constant(3, 2);
  for (const LongResult& result : {minimize_by_sqp(program, start, 400), polish(program, start)}) {
    ASSERT_TRUE(result.usable);
    EXPECT_LT((lines.transpose() * (lines * result.x - offsets)).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace kempe
