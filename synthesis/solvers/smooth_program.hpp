#pragma once
// A nonlinear program as plain functions: what the solvers' backends are given. No solver is named here.

#include <functional>
#include <string>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "synthesis/solvers/design_vector.hpp"

namespace kempe {

using ConstraintValues = Eigen::VectorXd;
/// One row a constraint.
using ConstraintGradients = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Minimise objective(x) subject to every constraint >= 0 and lower <= x <= upper.
struct SmoothProgram {
  DesignVector lower, upper;
  int constraint_count = 0;
  /// The value, and the gradient if a place for it is given.
  std::function<double(const DesignVector& x, DesignVector* gradient)> objective{};
  /// The values, and the gradients if a place for them is given.
  std::function<void(const DesignVector& x, ConstraintValues& values, ConstraintGradients* gradients)>
      constraints{};
  /// Hessian of  objective_factor * objective - sum multipliers[i] * constraint[i].
  std::function<DesignMatrix(const DesignVector& x, double objective_factor,
                             const Eigen::VectorXd& multipliers)>
      hessian{};

  int size() const { return static_cast<int>(lower.size()); }
};

/// Where a solver stopped. Cost and constraints must be evaluated again before use.
struct LocalResult {
  bool usable = false;  ///< the solver says that x is a solution or a point close to one
  DesignVector x{};
  int evaluations = 0;
};

}  // namespace kempe
