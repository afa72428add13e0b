// NLopt on path generators: SLSQP within the limits; then Gauss-Newton with the shortest step, which meets points exactly where
// they can be met.
//
//   mean square        minimise sum |e_i|^2 / n
//   largest distance   minimise t within |e_i|^2 <= t
//   transmission       minimise t within |cos mu| - cos(limit) <= t and e_i = 0

#include <nlopt.h>

#include <Eigen/QR>
#include <cmath>
#include <memory>

#include "synthesis/paths/path_program.hpp"
#include "synthesis/paths/slack.hpp"

namespace kempe {
namespace {

using RowMajorSlopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct PathRun {
  const PathProgram& program;
  bool largest;
  std::size_t evaluations = 0;
  double scale = 1;  // errors are counted in it, so that the solver sees numbers near 1
  Eigen::VectorXd value;
  Eigen::MatrixXd slope;

  Eigen::VectorXd unknowns(const double* u) const {
    return Eigen::Map<const Eigen::VectorXd>(u, program.size());
  }
};

double path_cost(unsigned n, const double* u, double* gradient, void* data) {
  auto& run = *static_cast<PathRun*>(data);
  ++run.evaluations;
  if (run.largest) {
    if (gradient) {
      std::fill(gradient, gradient + n, 0.0);
      gradient[n - 1] = 1;
    }
    return u[n - 1];
  }
  run.program.errors(run.unknowns(u), run.value, gradient ? &run.slope : nullptr);
  const double weight = 1 / (run.program.count() * run.scale * run.scale);
  if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, n) = 2 * weight * run.slope.transpose() * run.value;
  return weight * run.value.squaredNorm();
}

void path_limits(unsigned m, double* result, unsigned n, const double* u, double* gradient, void* data) {
  auto& run = *static_cast<PathRun*>(data);
  const Eigen::VectorXd x = run.unknowns(u);
  Eigen::VectorXd value;
  Eigen::MatrixXd slope;
  run.program.limits(x, value, gradient ? &slope : nullptr);
  const Eigen::Index own = value.size(), width = run.program.size();
  Eigen::Map<Eigen::VectorXd>(result, own) = value;
  if (gradient) {
    Eigen::Map<RowMajorSlopes> all(gradient, m, n);
    all.setZero();
    all.topLeftCorner(own, width) = slope;
  }
  if (!run.largest) return;
  run.program.errors(x, run.value, gradient ? &run.slope : nullptr);
  const double weight = 1 / (run.scale * run.scale);
  for (int i = 0; i < run.program.count(); ++i) {
    const Eigen::Index row = own + i;
    result[row] = weight * run.value.segment<2>(2 * i).squaredNorm() - u[n - 1];
    if (!gradient) continue;
    Eigen::Map<RowMajorSlopes> all(gradient, m, n);
    all.row(row).head(width) =
        2 * weight * run.value.segment<2>(2 * i).transpose() * run.slope.middleRows<2>(2 * i);
    all(row, n - 1) = -1;
  }
}

/// The unknowns with t behind them: the slope of t.
double last_unknown(unsigned n, const double* u, double* gradient, void* data) {
  ++static_cast<PathRun*>(data)->evaluations;
  if (gradient) {
    std::fill(gradient, gradient + n, 0.0);
    gradient[n - 1] = 1;
  }
  return u[n - 1];
}

/// The limits, those of the transmission angle less t.
void transmission_limits(unsigned m, double* result, unsigned n, const double* u, double* gradient,
                         void* data) {
  auto& run = *static_cast<PathRun*>(data);
  Eigen::VectorXd value;
  Eigen::MatrixXd slope;
  run.program.limits(run.unknowns(u), value, gradient ? &slope : nullptr);
  const int first = run.program.transmission_rows();
  value.head(first).array() -= u[n - 1];
  Eigen::Map<Eigen::VectorXd>(result, m) = value;
  if (!gradient) return;
  Eigen::Map<RowMajorSlopes> all(gradient, m, n);
  all.setZero();
  all.leftCols(run.program.size()) = slope;
  all.topRightCorner(first, 1).setConstant(-1);
}

/// The errors, to be nil.
void nil_errors(unsigned m, double* result, unsigned n, const double* u, double* gradient, void* data) {
  auto& run = *static_cast<PathRun*>(data);
  run.program.errors(run.unknowns(u), run.value, gradient ? &run.slope : nullptr);
  Eigen::Map<Eigen::VectorXd>(result, m) = run.value;
  if (!gradient) return;
  Eigen::Map<RowMajorSlopes> all(gradient, m, n);
  all.setZero();
  all.leftCols(run.program.size()) = run.slope;
}

double largest_square(const Eigen::VectorXd& errors) {
  double most = 0;
  for (Eigen::Index i = 0; i + 1 < errors.size(); i += 2)
    most = std::max(most, errors.segment<2>(i).squaredNorm());
  return most;
}

/// One run of SLSQP; x becomes its end where that is finite.
void run_slsqp(PathRun& run, int most_evaluations, Eigen::VectorXd& x) {
  const PathProgram& program = run.program;
  program.errors(x, run.value, nullptr);
  const double square = run.largest ? largest_square(run.value) : run.value.squaredNorm() / program.count();
  run.scale = std::max(std::sqrt(square), 1e-12);
  std::vector<double> all(x.data(), x.data() + x.size());
  Eigen::VectorXd low = program.lowest(), high = program.highest();
  std::vector<double> lowest(low.data(), low.data() + low.size()),
      highest(high.data(), high.data() + high.size());
  if (run.largest) {
    all.push_back(1);
    lowest.push_back(0);
    highest.push_back(10);
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::clamp(all[i], lowest[i], highest[i]);
  const auto n = static_cast<unsigned>(all.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> solver(nlopt_create(NLOPT_LD_SLSQP, n),
                                                                      &nlopt_destroy);
  nlopt_set_lower_bounds(solver.get(), lowest.data());
  nlopt_set_upper_bounds(solver.get(), highest.data());
  nlopt_set_min_objective(solver.get(), path_cost, &run);
  const int rows = program.limit_count() + (run.largest ? program.count() : 0);
  const std::vector<double> slack(static_cast<std::size_t>(rows), 1e-12);
  nlopt_add_inequality_mconstraint(solver.get(), static_cast<unsigned>(rows), path_limits, &run,
                                   slack.data());
  nlopt_set_xtol_rel(solver.get(), slack::path_at_rest);
  nlopt_set_maxeval(solver.get(), most_evaluations);
  double cost = 0;
  nlopt_optimize(solver.get(), all.data(), &cost);
  const Eigen::VectorXd end = run.unknowns(all.data());
  if (end.allFinite()) x = end;
}

/// Newton's steps to no error at all, the shortest that lead there, kept while they lessen the error within the limits.
void meet_points(PathRun& run, Eigen::VectorXd& x) {
  const auto kept = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd value;
    run.program.limits(at, value, nullptr);
    return value.maxCoeff() <= 0;
  };
  const bool was_kept = kept(x);
  for (int round = 0; round < 8; ++round) {
    ++run.evaluations;
    if (!run.program.errors(x, run.value, &run.slope)) return;
    const double before = run.value.squaredNorm();
    const Eigen::VectorXd trial = x - run.slope.completeOrthogonalDecomposition().solve(run.value);
    if (!trial.allFinite() || !run.program.errors(trial, run.value, nullptr)) return;
    if (!(run.value.squaredNorm() < before) || (was_kept && !kept(trial))) return;
    x = trial;
  }
}

}  // namespace

void refine_path(const PathProgram& program, PathAim aim, int most_evaluations, Eigen::VectorXd& x,
                 std::size_t& evaluations) {
  PathRun run{program, aim == PathAim::largest_distance, 0, 1, {}, {}};
  run_slsqp(run, most_evaluations, x);
  if (program.errors(x, run.value, nullptr) && run.value.norm() < 1e-2) meet_points(run, x);
  evaluations += run.evaluations;
}

void raise_path_transmission(const PathProgram& program, double reach, int most_evaluations,
                             Eigen::VectorXd& x, std::size_t& evaluations) {
  PathRun run{program, false, 0, 1, {}, {}};
  Eigen::VectorXd kept;
  program.limits(x, kept, nullptr);
  std::vector<double> all(x.data(), x.data() + x.size());
  all.push_back(kept.head(program.transmission_rows()).maxCoeff());
  const Eigen::VectorXd most = reach * (1 + x.array().abs());
  const Eigen::VectorXd low = program.lowest().cwiseMax(x - most),
                        high = program.highest().cwiseMin(x + most);
  std::vector<double> lowest(low.data(), low.data() + low.size()),
      highest(high.data(), high.data() + high.size());
  lowest.push_back(-2);
  highest.push_back(1);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::clamp(all[i], lowest[i], highest[i]);
  const auto n = static_cast<unsigned>(all.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> solver(nlopt_create(NLOPT_LD_SLSQP, n),
                                                                      &nlopt_destroy);
  nlopt_set_lower_bounds(solver.get(), lowest.data());
  nlopt_set_upper_bounds(solver.get(), highest.data());
  nlopt_set_min_objective(solver.get(), last_unknown, &run);
  const auto rows = static_cast<unsigned>(program.limit_count()),
             errors = static_cast<unsigned>(2 * program.count());
  const std::vector<double> slack(rows + errors, 1e-12);
  nlopt_add_inequality_mconstraint(solver.get(), rows, transmission_limits, &run, slack.data());
  nlopt_add_equality_mconstraint(solver.get(), errors, nil_errors, &run, slack.data());
  nlopt_set_xtol_rel(solver.get(), slack::path_at_rest);
  nlopt_set_maxeval(solver.get(), most_evaluations);
  double cost = 0;
  nlopt_optimize(solver.get(), all.data(), &cost);
  Eigen::VectorXd end = run.unknowns(all.data());
  if (end.allFinite() && program.errors(end, run.value, nullptr) && run.value.norm() < 1e-2) {
    meet_points(run, end);
    x = end;
  }
  evaluations += run.evaluations;
}

}  // namespace kempe
