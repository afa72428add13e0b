#include "synthesis/solvers/nlopt_backend.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "synthesis/solvers/slack.hpp"

namespace kempe {
namespace {

using Solver = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Solver make_solver(nlopt_algorithm algorithm, int dimensions) {
  return Solver(nlopt_create(algorithm, static_cast<unsigned>(dimensions)), &nlopt_destroy);
}

struct Exploration {
  const ExploreTask* task;
  nlopt_opt solver;
  std::vector<Explored>* seen;
};

double record(unsigned n, const double* z, double*, void* data) {
  auto& exploration = *static_cast<Exploration*>(data);
  if (exploration.task->stop()) nlopt_force_stop(exploration.solver);
  const std::span<const double> place(z, n);
  const double merit = exploration.task->merit(place);
  exploration.seen->push_back({{place.begin(), place.end()}, merit});
  return merit;
}

void explore_by(nlopt_algorithm algorithm, int evaluations, const ExploreTask& task,
                std::vector<Explored>& seen) {
  const Solver solver = make_solver(algorithm, task.dimensions);
  Exploration exploration{&task, solver.get(), &seen};
  nlopt_set_lower_bounds1(solver.get(), 0);
  nlopt_set_upper_bounds1(solver.get(), 1);
  nlopt_set_maxeval(solver.get(), evaluations);
  nlopt_set_min_objective(solver.get(), record, &exploration);
  std::vector<double> start(static_cast<std::size_t>(task.dimensions), 0.5);
  if (!seen.empty())
    start = std::min_element(seen.begin(), seen.end(), [](const Explored& a, const Explored& b) {
              return a.merit < b.merit;
            })->z;
  double merit = 0;
  nlopt_optimize(solver.get(), start.data(), &merit);
}

/// SLSQP on a program, which NLopt calls back with plain arrays.
template <class Vector, class Matrix>
class Slsqp {
 public:
  using Program = NonlinearProgram<Vector, Matrix>;

  Slsqp(const Program& program, const StopFlag& stop)
      : program_(program), stop_(stop), solver_(make_solver(NLOPT_LD_SLSQP, program.size())) {
    nlopt_set_lower_bounds(solver_.get(), program.lower.data());
    nlopt_set_upper_bounds(solver_.get(), program.upper.data());
    nlopt_set_min_objective(solver_.get(), cost, this);
    const std::vector<double> tolerance(
        static_cast<std::size_t>(std::max(program.constraint_count, program.equality_count)),
        slack::solver_constraint);
    if (program.constraint_count > 0)
      nlopt_add_inequality_mconstraint(solver_.get(), static_cast<unsigned>(program.constraint_count),
                                       inequalities, this, tolerance.data());
    if (program.equality_count > 0)
      nlopt_add_equality_mconstraint(solver_.get(), static_cast<unsigned>(program.equality_count), equalities,
                                     this, tolerance.data());
    nlopt_set_xtol_rel(solver_.get(), slack::solver_variables);
  }

  LocalSolution<Vector> end(const Vector& start, int most_evaluations, double cost_at_rest) {
    nlopt_set_ftol_rel(solver_.get(), cost_at_rest);
    nlopt_set_maxeval(solver_.get(), most_evaluations);
    LocalSolution<Vector> result{.x = start.cwiseMax(program_.lower).cwiseMin(program_.upper)};
    double value = 0;
    const nlopt_result status = nlopt_optimize(solver_.get(), result.x.data(), &value);
    result.usable = (status > 0 || status == NLOPT_ROUNDOFF_LIMITED) && result.x.allFinite();
    result.evaluations = evaluations_;
    return result;
  }

 private:
  static Vector copied(const double* x, unsigned n) { return Eigen::Map<const Eigen::VectorXd>(x, n); }

  static double cost(unsigned n, const double* x, double* gradient, void* data) {
    auto& run = *static_cast<Slsqp*>(data);
    ++run.evaluations_;
    if (run.stop_()) nlopt_force_stop(run.solver_.get());
    Vector derivative(n);
    const double value = run.program_.objective(copied(x, n), gradient ? &derivative : nullptr);
    if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, n) = derivative;
    return value;
  }

  static void equalities(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                         void* data) {
    ConstraintValues values(m);
    ConstraintGradients gradients(m, n);
    static_cast<Slsqp*>(data)->program_.equalities(copied(x, n), values, gradient ? &gradients : nullptr);
    Eigen::Map<Eigen::VectorXd>(result, m) = values;
    if (gradient) Eigen::Map<ConstraintGradients>(gradient, m, n) = gradients;
  }

  /// NLopt's constraints are <= 0.
  static void inequalities(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                           void* data) {
    ConstraintValues values(m);
    ConstraintGradients gradients(m, n);
    static_cast<Slsqp*>(data)->program_.constraints(copied(x, n), values, gradient ? &gradients : nullptr);
    Eigen::Map<Eigen::VectorXd>(result, m) = -values;
    if (gradient) Eigen::Map<ConstraintGradients>(gradient, m, n) = -gradients;
  }

  const Program& program_;
  const StopFlag& stop_;
  Solver solver_;
  int evaluations_ = 0;
};

}  // namespace

std::string nlopt_name() {
  int major = 0, minor = 0, bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  return "NLopt " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(bugfix);
}

std::vector<Explored> explore(const ExploreTask& task) {
  nlopt_srand(static_cast<unsigned long>(task.seed));  // the generator is the calling thread's own
  std::vector<Explored> seen;
  seen.reserve(static_cast<std::size_t>(task.evaluations) + 64);
  explore_by(NLOPT_GN_DIRECT_L, task.evaluations / 2, task, seen);
  if (!task.stop()) explore_by(NLOPT_GN_CRS2_LM, task.evaluations - task.evaluations / 2, task, seen);
  return seen;
}

LocalResult minimize_by_sqp(const SmoothProgram& program, const DesignVector& start, int most_evaluations,
                            const StopFlag& stop) {
  return Slsqp(program, stop).end(start, most_evaluations, slack::solver_cost);
}

LongResult minimize_by_sqp(const LongProgram& program, const Eigen::VectorXd& start, int most_evaluations) {
  const StopFlag never;
  return Slsqp(program, never).end(start, most_evaluations, 0);
}

}  // namespace kempe
