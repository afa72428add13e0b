#pragma once
// Are a program's derivatives those of its values? A product feature: run it on any program before blaming a solver.

#include <optional>

#include "synthesis/solvers/smooth_program.hpp"

namespace kempe {

/// The largest deviations from central differences, each relative to 1 + |derivative|.
struct DerivativeDeviation {
  double objective_gradient = 0;
  double constraint_gradients = 0;
  std::optional<int> worst_constraint;  ///< nothing: there are none
  double hessian = 0;                   ///< of the Lagrangian, against differences of the gradients
};

/// Compares at x with differences of step `step` (about 1e-6 for variables of order 1); `multipliers` weigh the
/// constraints in the Hessian. Where a function has a kink within a step the deviation is large and means nothing.
DerivativeDeviation check_derivatives(const SmoothProgram& program, const DesignVector& x,
                                      const Eigen::VectorXd& multipliers, double step = 1e-6);

}  // namespace kempe
