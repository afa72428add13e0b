#include "synthesis/solvers/newton_polish.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "synthesis/solvers/slack.hpp"

namespace kempe {
namespace {

constexpr int most_steps = 8;

/// Active constraints: the program's own by index, then bounds by variable with the side they are on.
struct ActiveSet {
  std::vector<int> constraints;
  std::vector<std::pair<int, double>> bounds;  ///< variable, +1 lower or -1 upper
  int size() const { return static_cast<int>(constraints.size() + bounds.size()); }
  void erase(int i) {
    const int n = static_cast<int>(constraints.size());
    if (i < n)
      constraints.erase(constraints.begin() + i);
    else
      bounds.erase(bounds.begin() + (i - n));
  }
};

struct Linearized {
  Eigen::VectorXd objective;  ///< gradient
  Eigen::VectorXd values;     ///< of the active constraints
  Eigen::MatrixXd gradients;  ///< a row each
};

Linearized linearize(const SmoothProgram& program, const ActiveSet& active, const DesignVector& x) {
  const int n = program.size(), m = program.constraint_count;
  DesignVector gradient(n);
  program.objective(x, &gradient);
  ConstraintValues values(m);
  ConstraintGradients gradients(m, n);
  if (m > 0) program.constraints(x, values, &gradients);
  Linearized result{gradient, Eigen::VectorXd(active.size()), Eigen::MatrixXd::Zero(active.size(), n)};
  int row = 0;
  for (const int i : active.constraints) {
    result.values[row] = values[i];
    result.gradients.row(row++) = gradients.row(i);
  }
  for (const auto& [variable, side] : active.bounds) {
    result.values[row] = side * (x[variable] - (side > 0 ? program.lower : program.upper)[variable]);
    result.gradients(row++, variable) = side;
  }
  return result;
}

ActiveSet active_at(const SmoothProgram& program, const DesignVector& x) {
  ActiveSet active;
  ConstraintValues values(program.constraint_count);
  if (program.constraint_count > 0) program.constraints(x, values, nullptr);
  for (int i = 0; i < program.constraint_count; ++i)
    if (std::abs(values[i]) < slack::active_below) active.constraints.push_back(i);
  for (int i = 0; i < program.size(); ++i) {
    if (x[i] - program.lower[i] < slack::active_below)
      active.bounds.emplace_back(i, 1.0);
    else if (program.upper[i] - x[i] < slack::active_below)
      active.bounds.emplace_back(i, -1.0);
  }
  return active;
}

Eigen::VectorXd least_norm(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  if (matrix.size() == 0) return Eigen::VectorXd::Zero(matrix.cols());
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(matrix.rows(), matrix.cols());
  decomposition.setThreshold(slack::rank_tolerance);
  decomposition.compute(matrix);
  return solution_of(decomposition, right);
}

/// Drops the constraints that hold nothing: multipliers that come out negative, the worst first.
void drop_idle(const SmoothProgram& program, const DesignVector& x, ActiveSet& active) {
  while (active.size() > 0) {
    const Linearized here = linearize(program, active, x);
    const Eigen::VectorXd multipliers = least_norm(here.gradients.transpose(), here.objective);
    Eigen::Index worst = 0;
    if (multipliers.minCoeff(&worst) >= -slack::multiplier_rounding) return;
    active.erase(static_cast<int>(worst));
  }
}

/// One Newton step for x and the multipliers together; returns the step in x.
Eigen::VectorXd newton_step(const SmoothProgram& program, const ActiveSet& active, const DesignVector& x) {
  const int n = program.size(), m = active.size();
  const Linearized here = linearize(program, active, x);
  const Eigen::VectorXd multipliers = least_norm(here.gradients.transpose(), here.objective);
  Eigen::VectorXd of_constraints = Eigen::VectorXd::Zero(program.constraint_count);
  for (std::size_t i = 0; i < active.constraints.size(); ++i)
    of_constraints[active.constraints[i]] = multipliers[static_cast<Eigen::Index>(i)];
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
  system.topLeftCorner(n, n) = program.hessian(x, 1, of_constraints);
  system.topRightCorner(n, m) = -here.gradients.transpose();
  system.bottomLeftCorner(m, n) = here.gradients;
  Eigen::VectorXd right(n + m);
  right << -(here.objective - here.gradients.transpose() * multipliers), -here.values;
  return least_norm(system, right).head(n);
}

}  // namespace

DesignVector newton_polish(const SmoothProgram& program, const DesignVector& start) {
  ActiveSet active = active_at(program, start);
  drop_idle(program, start, active);
  DesignVector x = start;
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::VectorXd step = newton_step(program, active, x);
    if (!step.allFinite() || step.cwiseAbs().maxCoeff() > slack::longest_step) return start;
    x += step;
    if (step.cwiseAbs().maxCoeff() < slack::converged_step) break;
    if (i + 1 == most_steps && step.cwiseAbs().maxCoeff() > slack::last_step) return start;
  }
  return x.cwiseMax(program.lower).cwiseMin(program.upper);
}

}  // namespace kempe
