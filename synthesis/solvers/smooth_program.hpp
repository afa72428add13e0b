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

/// Minimise objective(x) subject to every constraint >= 0, every equality = 0 and lower <= x <= upper.
template <class Vector, class Matrix>
struct NonlinearProgram {
  /// The values at x, and the gradients if a place for them is given.
  using Rows = std::function<void(const Vector& x, ConstraintValues& values, ConstraintGradients* gradients)>;

  Vector lower, upper;
  int constraint_count = 0;
  /// The value, and the gradient if a place for it is given.
  std::function<double(const Vector& x, Vector* gradient)> objective{};
  Rows constraints{};
  /// Hessian of  objective_factor * objective - sum multipliers[i] * constraint[i], the equalities behind the constraints.
  std::function<Matrix(const Vector& x, double objective_factor, const Eigen::VectorXd& multipliers)>
      hessian{};
  int equality_count = 0;
  Rows equalities{};

  int size() const { return static_cast<int>(lower.size()); }
};

/// Where a solver stopped. Cost and constraints must be evaluated again before use.
template <class Vector>
struct LocalSolution {
  bool usable = false;  ///< the solver says that x is a solution or a point close to one
  Vector x{};
  int evaluations = 0;
};

/// Of a design's few variables.
using SmoothProgram = NonlinearProgram<DesignVector, DesignMatrix>;
using LocalResult = LocalSolution<DesignVector>;

/// Of any number of variables.
using LongProgram = NonlinearProgram<Eigen::VectorXd, Eigen::MatrixXd>;
using LongResult = LocalSolution<Eigen::VectorXd>;

}  // namespace kempe
