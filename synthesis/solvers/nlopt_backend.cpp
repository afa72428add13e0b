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

struct LocalRun {
  const SmoothProgram* program;
  const StopFlag* stop;
  nlopt_opt solver;
  int evaluations = 0;
};

DesignVector copied(const double* x, unsigned n) { return Eigen::Map<const Eigen::VectorXd>(x, n); }

double objective_callback(unsigned n, const double* x, double* gradient, void* data) {
  auto& run = *static_cast<LocalRun*>(data);
  ++run.evaluations;
  if ((*run.stop)()) nlopt_force_stop(run.solver);
  DesignVector derivative(n);
  const double value = run.program->objective(copied(x, n), gradient ? &derivative : nullptr);
  if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, n) = derivative;
  return value;
}

/// NLopt's constraints are <= 0.
void constraint_callback(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                         void* data) {
  const auto& run = *static_cast<const LocalRun*>(data);
  ConstraintValues values(m);
  ConstraintGradients gradients(m, n);
  run.program->constraints(copied(x, n), values, gradient ? &gradients : nullptr);
  Eigen::Map<Eigen::VectorXd>(result, m) = -values;
  if (gradient) Eigen::Map<ConstraintGradients>(gradient, m, n) = -gradients;
}

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
  const int n = program.size();
  const Solver solver = make_solver(NLOPT_LD_SLSQP, n);
  LocalRun run{&program, &stop, solver.get()};
  nlopt_set_lower_bounds(solver.get(), program.lower.data());
  nlopt_set_upper_bounds(solver.get(), program.upper.data());
  nlopt_set_min_objective(solver.get(), objective_callback, &run);
  const std::vector<double> tolerance(static_cast<std::size_t>(program.constraint_count),
                                      slack::solver_constraint);
  if (program.constraint_count > 0)
    nlopt_add_inequality_mconstraint(solver.get(), static_cast<unsigned>(program.constraint_count),
                                     constraint_callback, &run, tolerance.data());
  nlopt_set_xtol_rel(solver.get(), slack::solver_variables);
  nlopt_set_ftol_rel(solver.get(), slack::solver_cost);
  nlopt_set_maxeval(solver.get(), most_evaluations);
  LocalResult result{.x = start.cwiseMax(program.lower).cwiseMin(program.upper)};
  double value = 0;
  const nlopt_result status = nlopt_optimize(solver.get(), result.x.data(), &value);
  result.usable = (status > 0 || status == NLOPT_ROUNDOFF_LIMITED) && result.x.allFinite();
  result.evaluations = run.evaluations;
  return result;
}

}  // namespace kempe
