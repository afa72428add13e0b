// Local search of path generators: a program for each aim, given to one of the local solvers; then Gauss-Newton with the shortest step,
// which meets points exactly where they can be met.
//
//   mean square        minimise sum |e_i|^2 / n
//   largest distance   minimise t within |e_i|^2 <= t
//   transmission       minimise t within |cos mu| - cos(limit) <= t and e_i = 0
//
// Errors are counted in those of the start, so that the solvers see numbers near 1.

#include <cmath>

#include "geometry/decompositions.hpp"
#include "synthesis/paths/path_program.hpp"
#include "synthesis/paths/slack.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using LocalSolver = std::function<LongResult(const LongProgram& program, const VectorXd& start)>;

/// What one evaluation fills.
struct PathValues {
  VectorXd value;
  MatrixXd slope;
};

VectorXd with_last(const VectorXd& values, double last) {
  VectorXd all(values.size() + 1);
  all << values, last;
  return all;
}

/// Minimises the last unknown.
double last_unknown(const VectorXd& u, VectorXd* gradient) {
  if (gradient) *gradient = VectorXd::Unit(u.size(), u.size() - 1);
  return u[u.size() - 1];
}

/// The path's limits, in the first rows; the slopes along what lies behind its unknowns are zero.
void keep_limits(const PathProgram& path, const VectorXd& x, PathValues& scratch, ConstraintValues& values,
                 ConstraintGradients* gradients) {
  path.limits(x, scratch.value, gradients ? &scratch.slope : nullptr);
  values.head(scratch.value.size()) = -scratch.value;
  if (!gradients) return;
  gradients->setZero();
  gradients->topLeftCorner(scratch.slope.rows(), path.size()) = -scratch.slope;
}

LongProgram mean_square_program(const PathProgram& path, double unit, PathValues& scratch) {
  LongProgram program{
      .lower = path.lowest(), .upper = path.highest(), .constraint_count = path.limit_count()};
  const double weight = 1 / (path.count() * unit * unit);
  program.objective = [&path, &scratch, weight](const VectorXd& x, VectorXd* gradient) {
    path.errors(x, scratch.value, gradient ? &scratch.slope : nullptr);
    if (gradient) *gradient = 2 * weight * scratch.slope.transpose() * scratch.value;
    return weight * scratch.value.squaredNorm();
  };
  program.constraints = [&path, &scratch](const VectorXd& x, ConstraintValues& values,
                                          ConstraintGradients* gradients) {
    keep_limits(path, x, scratch, values, gradients);
  };
  return program;
}

LongProgram largest_distance_program(const PathProgram& path, double unit, PathValues& scratch) {
  constexpr double most = 10;  // times the start's
  LongProgram program{.lower = with_last(path.lowest(), 0),
                      .upper = with_last(path.highest(), most),
                      .constraint_count = path.limit_count() + path.count(),
                      .objective = last_unknown};
  const double weight = 1 / (unit * unit);
  program.constraints = [&path, &scratch, weight](const VectorXd& u, ConstraintValues& values,
                                                  ConstraintGradients* gradients) {
    const Eigen::Index unknowns = path.size();
    const VectorXd x = u.head(unknowns);
    keep_limits(path, x, scratch, values, gradients);
    const Eigen::Index own = scratch.value.size();
    path.errors(x, scratch.value, gradients ? &scratch.slope : nullptr);
    for (int i = 0; i < path.count(); ++i) {
      values[own + i] = u[unknowns] - weight * scratch.value.segment<2>(2 * i).squaredNorm();
      if (!gradients) continue;
      gradients->row(own + i).head(unknowns) =
          -2 * weight * scratch.value.segment<2>(2 * i).transpose() * scratch.slope.middleRows<2>(2 * i);
      (*gradients)(own + i, unknowns) = 1;
    }
  };
  return program;
}

/// Within lowest <= x <= highest.
LongProgram transmission_program(const PathProgram& path, const VectorXd& lowest, const VectorXd& highest,
                                 PathValues& scratch) {
  LongProgram program{.lower = with_last(lowest, -2),
                      .upper = with_last(highest, 1),
                      .constraint_count = path.limit_count(),
                      .objective = last_unknown};
  program.constraints = [&path, &scratch](const VectorXd& u, ConstraintValues& values,
                                          ConstraintGradients* gradients) {
    const Eigen::Index unknowns = path.size(), rows = path.transmission_rows();
    keep_limits(path, u.head(unknowns), scratch, values, gradients);
    values.head(rows).array() += u[unknowns];
    if (gradients) gradients->topRightCorner(rows, 1).setConstant(1);
  };
  program.equality_count = 2 * path.count();
  program.equalities = [&path, &scratch](const VectorXd& u, ConstraintValues& values,
                                         ConstraintGradients* gradients) {
    path.errors(u.head(path.size()), scratch.value, gradients ? &scratch.slope : nullptr);
    values = scratch.value;
    if (!gradients) return;
    gradients->setZero();
    gradients->leftCols(path.size()) = scratch.slope;
  };
  return program;
}

double largest_square(const VectorXd& errors) {
  double most = 0;
  for (Eigen::Index i = 0; i + 1 < errors.size(); i += 2)
    most = std::max(most, errors.segment<2>(i).squaredNorm());
  return most;
}

/// Newton's steps to no error at all, the shortest that lead there, kept while they lessen the error within the limits. The number of
/// evaluations.
std::size_t meet_points(const PathProgram& path, VectorXd& x) {
  PathValues here, there;
  const auto kept = [&](const VectorXd& at) {
    path.limits(at, there.value, nullptr);
    return there.value.maxCoeff() <= 0;
  };
  const bool was_kept = kept(x);
  constexpr std::size_t most_rounds = 8;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    if (!path.errors(x, here.value, &here.slope)) return round + 1;
    const VectorXd trial =
        x - solution_of(Eigen::CompleteOrthogonalDecomposition<MatrixXd>(here.slope), here.value);
    if (!trial.allFinite() || !path.errors(trial, there.value, nullptr)) return round + 1;
    if (!(there.value.squaredNorm() < here.value.squaredNorm()) || (was_kept && !kept(trial)))
      return round + 1;
    x = trial;
  }
  return most_rounds;
}

/// The path's unknowns where a solver ended, x where that is not finite, brought to meet the points where they nearly do.
VectorXd ended(const PathProgram& path, const LongResult& result, const VectorXd& x,
               std::size_t& evaluations) {
  evaluations += static_cast<std::size_t>(result.evaluations);
  VectorXd end = result.x.allFinite() ? VectorXd(result.x.head(path.size())) : x, errors;
  if (path.errors(end, errors, nullptr) && errors.norm() < slack::path_nearly_met)
    evaluations += meet_points(path, end);
  return end;
}

VectorXd refined_by(const LocalSolver& solve, const PathProgram& path, PathAim aim, const VectorXd& x,
                    std::size_t& evaluations) {
  PathValues scratch;
  path.errors(x, scratch.value, nullptr);
  const bool largest = aim == PathAim::largest_distance;
  const double square = largest ? largest_square(scratch.value) : scratch.value.squaredNorm() / path.count();
  const double unit = std::max(std::sqrt(square), slack::path_least_unit);
  const LongResult result = largest ? solve(largest_distance_program(path, unit, scratch), with_last(x, 1))
                                    : solve(mean_square_program(path, unit, scratch), x);
  return ended(path, result, x, evaluations);
}

}  // namespace

VectorXd refined_path(const PathProgram& program, PathAim aim, int most_evaluations, const VectorXd& x,
                      std::size_t& evaluations) {
  const LocalSolver sqp = [&](const LongProgram& task, const VectorXd& start) {
    return minimize_by_sqp(task, start, most_evaluations);
  };
  return refined_by(sqp, program, aim, x, evaluations);
}

VectorXd polished_path(const PathProgram& program, PathAim aim, const VectorXd& x, std::size_t& evaluations) {
  const LocalSolver second = [](const LongProgram& task, const VectorXd& start) {
    return polish(task, start);
  };
  return refined_by(second, program, aim, x, evaluations);
}

VectorXd led_to_larger_transmission(const PathProgram& program, double reach, int most_evaluations,
                                    const VectorXd& x, std::size_t& evaluations) {
  PathValues scratch;
  VectorXd kept;
  program.limits(x, kept, nullptr);
  const VectorXd most = reach * (1 + x.array().abs());
  const LongProgram task = transmission_program(program, program.lowest().cwiseMax(x - most),
                                                program.highest().cwiseMin(x + most), scratch);
  const VectorXd start = with_last(x, kept.head(program.transmission_rows()).maxCoeff());
  return ended(program, minimize_by_sqp(task, start, most_evaluations), x, evaluations);
}

}  // namespace kempe
