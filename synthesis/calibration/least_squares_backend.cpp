// Levenberg-Marquardt by MINPACK's lmder (cminpack).
#include <cminpack.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/decompositions.hpp"
#include "synthesis/calibration/least_squares.hpp"
#include "synthesis/calibration/slack.hpp"

namespace kempe {
namespace {

struct Call {
  const Residuals& residuals;
  double
      wall;  ///< stands for every residual where none exist: far above the start's, so the step is taken back
  int evaluations = 0;
};

int evaluate(void* data, int m, int n, const double* x, double* values, double* slopes, int leading,
             int what) {
  auto& call = *static_cast<Call*>(data);
  const Eigen::Map<const Eigen::VectorXd> at(x, n);
  Eigen::VectorXd residuals(m);
  ++call.evaluations;
  if (what == 1) {
    const bool exists = call.residuals(at, residuals, nullptr);
    Eigen::Map<Eigen::VectorXd>(values, m) = exists ? residuals : Eigen::VectorXd::Constant(m, call.wall);
    return 0;
  }
  Eigen::MatrixXd jacobian(m, n);
  if (!call.residuals(at, residuals, &jacobian)) return -1;
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(slopes, m, n, Eigen::OuterStride<>(leading)) =
      jacobian;
  return 0;
}

Eigen::VectorXd levenberg_marquardt(Call& call, const Eigen::VectorXd& start, int m, int most_evaluations) {
  const int n = static_cast<int>(start.size());
  const auto size = [](int count) { return static_cast<std::size_t>(count); };
  std::vector<double> x(start.data(), start.data() + n), values(size(m)), slopes(size(m) * size(n)),
      scale(size(n), 1.0);
  std::vector<double> qtf(size(n)), work1(size(n)), work2(size(n)), work3(size(n)), work4(size(m));
  std::vector<int> pivots(size(n));
  int function_calls = 0, jacobian_calls = 0;
  __cminpack_func__(lmder)(evaluate, &call, m, n, x.data(), values.data(), slopes.data(), m, slack::tightest,
                           slack::tightest, 0, most_evaluations, scale.data(), 2, 1.0, 0, &function_calls,
                           &jacobian_calls, pivots.data(), qtf.data(), work1.data(), work2.data(),
                           work3.data(), work4.data());
  return Eigen::Map<const Eigen::VectorXd>(x.data(), n);
}

/// Full Gauss-Newton steps while they shrink and do no harm: the last digits, and the test of convergence.
void polish(Call& call, LeastSquaresSolution& solution, Eigen::Index rows, double settled) {
  Eigen::VectorXd residuals(rows), trial(rows);
  Eigen::MatrixXd jacobian(rows, solution.x.size());
  double last_step = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    if (!call.residuals(solution.x, residuals, &jacobian)) return;
    const Eigen::VectorXd step = solution_of(jacobian.colPivHouseholderQr(), -residuals);
    const double length = step.norm();
    ++call.evaluations;
    if (!std::isfinite(length)) return;
    solution.converged = length <= settled;
    if (!(length < 0.9 * last_step) || length == 0) return;
    if (!call.residuals(solution.x + step, trial, nullptr)) return;
    if (!(trial.squaredNorm() <= residuals.squaredNorm() * (1 + slack::squares_rounding)) && length > settled)
      return;
    solution.x += step;
    solution.square_sum = trial.squaredNorm();
    last_step = length;
  }
}

}  // namespace

LeastSquaresSolution least_squares(const Residuals& residuals, const Eigen::VectorXd& start,
                                   Eigen::Index rows, double settled, int most_evaluations) {
  LeastSquaresSolution solution{start};
  Eigen::VectorXd values(rows);
  if (!residuals(start, values, nullptr)) return solution;
  solution.square_sum = values.squaredNorm();
  if (start.size() == 0) {
    solution.converged = true;
    return solution;
  }
  Call call{residuals, 1e3 * (values.cwiseAbs().maxCoeff() + 1), 0};
  const Eigen::VectorXd x = levenberg_marquardt(call, start, static_cast<int>(rows), most_evaluations);
  if (residuals(x, values, nullptr) && values.squaredNorm() <= solution.square_sum) {
    solution.x = x;
    solution.square_sum = values.squaredNorm();
  }
  polish(call, solution, rows, settled);
  solution.evaluations = call.evaluations;
  return solution;
}

}  // namespace kempe
