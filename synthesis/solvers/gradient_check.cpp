#include "synthesis/solvers/gradient_check.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

struct ProgramSample {
  double objective;
  DesignVector gradient;
  ConstraintValues values;
  ConstraintGradients gradients;
};

ProgramSample sample_at(const SmoothProgram& program, const DesignVector& x) {
  const int n = program.size(), m = program.constraint_count;
  ProgramSample sample{0, DesignVector(n), ConstraintValues(m), ConstraintGradients(m, n)};
  sample.objective = program.objective(x, &sample.gradient);
  if (m > 0) program.constraints(x, sample.values, &sample.gradients);
  return sample;
}

double deviation(double analytic, double difference) {
  return std::abs(analytic - difference) / (1 + std::abs(analytic));
}

}  // namespace

DerivativeDeviation check_derivatives(const SmoothProgram& program, const DesignVector& x,
                                      const Eigen::VectorXd& multipliers, double step) {
  DerivativeDeviation worst;
  const ProgramSample here = sample_at(program, x);
  const DesignMatrix hessian = program.hessian(x, 1, multipliers);
  for (int j = 0; j < program.size(); ++j) {
    DesignVector ahead = x, behind = x;
    ahead[j] += step;
    behind[j] -= step;
    const ProgramSample a = sample_at(program, ahead), b = sample_at(program, behind);
    worst.objective_gradient = std::max(
        worst.objective_gradient, deviation(here.gradient[j], (a.objective - b.objective) / (2 * step)));
    for (int i = 0; i < program.constraint_count; ++i) {
      const double off = deviation(here.gradients(i, j), (a.values[i] - b.values[i]) / (2 * step));
      if (off > worst.constraint_gradients || !worst.worst_constraint) worst.worst_constraint = i;
      worst.constraint_gradients = std::max(worst.constraint_gradients, off);
    }
    const Eigen::VectorXd change = (a.gradient - a.gradients.transpose() * multipliers - b.gradient +
                                    b.gradients.transpose() * multipliers) /
                                   (2 * step);
    for (int i = 0; i < program.size(); ++i)
      worst.hessian = std::max(worst.hessian, deviation(hessian(i, j), change[i]));
  }
  return worst;
}

}  // namespace kempe
