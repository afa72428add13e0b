// NLopt on path generators: SLSQP within the limits; then Gauss-Newton with the shortest step, which meets points exactly where
// they can be met.
//
//   mean square        minimise sum |e_i|^2 / n
//   largest distance   minimise t within |e_i|^2 <= t
//   transmission       minimise t within |cos mu| - cos(limit) <= t and e_i = 0

#include <nlopt.h>

#include <Eigen/QR>
#include <algorithm>
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

/// SLSQP on a path's unknowns and, where a largest value is made small, that value behind them.
class Slsqp {
 public:
  Slsqp(PathRun& run, nlopt_func cost, const Eigen::VectorXd& start, const Eigen::VectorXd& lowest,
        const Eigen::VectorXd& highest)
      : run_(run), all_(start.data(), start.data() + start.size()), lowest_(lowest), highest_(highest) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      all_[i] = std::clamp(all_[i], lowest_[at], highest_[at]);
    }
    solver_.reset(nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(all_.size())));
    nlopt_set_lower_bounds(solver_.get(), lowest_.data());
    nlopt_set_upper_bounds(solver_.get(), highest_.data());
    nlopt_set_min_objective(solver_.get(), cost, &run);
    nlopt_set_xtol_rel(solver_.get(), slack::path_at_rest);
  }

  /// So many values that are to be at most nil, or nil.
  void limit(nlopt_mfunc values, int rows) {
    const std::vector<double> slack(static_cast<std::size_t>(rows), at_nil);
    nlopt_add_inequality_mconstraint(solver_.get(), static_cast<unsigned>(rows), values, &run_, slack.data());
  }
  void equate(nlopt_mfunc values, int rows) {
    const std::vector<double> slack(static_cast<std::size_t>(rows), at_nil);
    nlopt_add_equality_mconstraint(solver_.get(), static_cast<unsigned>(rows), values, &run_, slack.data());
  }

  /// The path's unknowns where it ends.
  Eigen::VectorXd end(int most_evaluations) {
    nlopt_set_maxeval(solver_.get(), most_evaluations);
    double cost = 0;
    nlopt_optimize(solver_.get(), all_.data(), &cost);
    return run_.unknowns(all_.data());
  }

 private:
  static constexpr double at_nil = 1e-12;
  PathRun& run_;
  std::vector<double> all_;
  Eigen::VectorXd lowest_, highest_;
  std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> solver_{nullptr, &nlopt_destroy};
};

Eigen::VectorXd with_last(const Eigen::VectorXd& values, double last) {
  Eigen::VectorXd all(values.size() + 1);
  all << values, last;
  return all;
}

/// One run of SLSQP; x becomes its end where that is finite.
void run_slsqp(PathRun& run, int most_evaluations, Eigen::VectorXd& x) {
  const PathProgram& program = run.program;
  program.errors(x, run.value, nullptr);
  const double square = run.largest ? largest_square(run.value) : run.value.squaredNorm() / program.count();
  run.scale = std::max(std::sqrt(square), 1e-12);
  const Eigen::VectorXd low = program.lowest(), high = program.highest();
  Slsqp solver(run, path_cost, run.largest ? with_last(x, 1) : x, run.largest ? with_last(low, 0) : low,
               run.largest ? with_last(high, 10) : high);
  solver.limit(path_limits, program.limit_count() + (run.largest ? program.count() : 0));
  const Eigen::VectorXd end = solver.end(most_evaluations);
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
  const Eigen::VectorXd most = reach * (1 + x.array().abs());
  const Eigen::VectorXd low = program.lowest().cwiseMax(x - most),
                        high = program.highest().cwiseMin(x + most);
  Slsqp solver(run, last_unknown, with_last(x, kept.head(program.transmission_rows()).maxCoeff()),
               with_last(low, -2), with_last(high, 1));
  solver.limit(transmission_limits, program.limit_count());
  solver.equate(nil_errors, 2 * program.count());
  Eigen::VectorXd end = solver.end(most_evaluations);
  if (end.allFinite() && program.errors(end, run.value, nullptr) && run.value.norm() < 1e-2) {
    meet_points(run, end);
    x = end;
  }
  evaluations += run.evaluations;
}

}  // namespace kempe
