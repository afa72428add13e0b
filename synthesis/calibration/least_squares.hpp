#pragma once
// Nonlinear least squares as calibration needs it; the library behind it stays in its own source.

#include <Eigen/Core>
#include <functional>

namespace kempe {

/// Residuals at x and, if `slopes` is not null, d residuals / d x. False where they do not exist: the solver
/// turns back.
using Residuals =
    std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd* slopes)>;

struct LeastSquaresSolution {
  Eigen::VectorXd x;
  double square_sum = 0;
  /// True if the last full Gauss-Newton step from x, taken by our own check after the library, was at most
  /// `settled`.
  bool converged = false;
  int evaluations = 0;
};

/// Minimises |residuals|^2 from `start`, where the residuals must exist; `rows` >= start.size().
/// Levenberg-Marquardt, then Gauss-Newton steps until they no longer shrink. Never worse than the start.
LeastSquaresSolution least_squares(const Residuals& residuals, const Eigen::VectorXd& start,
                                   Eigen::Index rows, double settled, int most_evaluations = 2000);

}  // namespace kempe
