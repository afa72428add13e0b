// The conditions that hold a minimax function generator, made exact by Newton's method and judged.
//
// At a minimum of E = max |e(x; u)| within limits h_j(u) <= 0 there are multipliers, none negative, with
//   sum_i lambda_i s_i grad e(x_i) + sum_j mu_j grad h_j = 0,   sum_i lambda_i = 1
// over the ripples (s_i e(x_i) = E) and the limits at work (h_j = 0).
//   - n + 1 conditions for n unknowns, all multipliers positive, slopes of full rank: no direction lowers E to first
//     order, a strict local minimum with as many equal ripples as Chebyshev's theorem asks for (a limit takes
//     the place of a ripple each).
//   - Fewer conditions: along the directions that change none of them the second derivative of
//     sum lambda_i s_i e(x_i) + sum mu_j h_j must be positive. Then, too, the minimum is strict and local:
//     the family of four-bars does not obey Haar's condition, and fewer ripples can be the best.

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "synthesis/functions/conditions.hpp"
#include "synthesis/functions/slack.hpp"

namespace kempe {
namespace {

/// Which conditions are taken to hold.
struct ActiveSet {
  std::vector<ErrorRipple> ripples;  ///< places follow the unknowns
  std::vector<std::size_t> limits;   ///< numbers in limits_of
  Eigen::Index size() const { return static_cast<Eigen::Index>(ripples.size() + limits.size()); }
};

/// The ripples and limits within a tolerance of being at work.
ActiveSet near_at(const GeneratorError& error, const GeneratorVector& u, double tolerance) {
  ActiveSet active;
  const auto ripples = ripples_of(error, u);
  for (const ErrorRipple& ripple : ripples)
    if (ripple.height >= (1 - tolerance) * ripples.front().height) active.ripples.push_back(ripple);
  const auto limits = limits_of(error, u);
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (limits[i].excess.value > -slack::holding_limit) active.limits.push_back(i);
  return active;
}

/// Values and slopes of the active conditions at u; ripples move to their tops. Nothing if a ripple is gone.
struct Conditions {
  Eigen::VectorXd values;  ///< heights, then excesses
  Eigen::MatrixXd slopes;
};

std::optional<Conditions> conditions_at(const GeneratorError& error, const GeneratorVector& u,
                                        const ActiveSet& active) {
  const auto ripples = ripples_of(error, u);
  const double near = 0.05 * (error.task().x_upper - error.task().x_lower);
  Conditions result{Eigen::VectorXd(active.size()), Eigen::MatrixXd(active.size(), u.size())};
  Eigen::Index row = 0;
  for (const ErrorRipple& was : active.ripples) {
    const auto now = std::min_element(ripples.begin(), ripples.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.x - was.x) < std::abs(b.x - was.x);
    });
    if (std::abs(now->x - was.x) > near || now->sign != was.sign) return std::nullopt;
    result.values[row] = now->height;
    result.slopes.row(row++) = now->sign * error.at(u, now->x).slope;
  }
  const auto limits = limits_of(error, u);
  for (const std::size_t number : active.limits) {
    result.values[row] = limits[number].excess.value;
    result.slopes.row(row++) = limits[number].excess.slope;
  }
  return result;
}

/// sum of multipliers times slopes: the gradient of the Lagrangian.
std::optional<Eigen::VectorXd> pull_at(const GeneratorError& error, const GeneratorVector& u,
                                       const ActiveSet& active, const Eigen::VectorXd& multipliers) {
  const auto conditions = conditions_at(error, u, active);
  if (!conditions) return std::nullopt;
  return Eigen::VectorXd(conditions->slopes.transpose() * multipliers);
}

/// Derivative of the pull: the Hessian of the Lagrangian, by central differences of exact slopes.
std::optional<Eigen::MatrixXd> curvature_at(const GeneratorError& error, const GeneratorVector& u,
                                            const ActiveSet& active, const Eigen::VectorXd& multipliers) {
  constexpr double h = slack::curvature_step;
  Eigen::MatrixXd hessian(u.size(), u.size());
  for (Eigen::Index j = 0; j < u.size(); ++j) {
    GeneratorVector up = u, down = u;
    up[j] += h;
    down[j] -= h;
    const auto above = pull_at(error, up, active, multipliers),
               below = pull_at(error, down, active, multipliers);
    if (!above || !below) return std::nullopt;
    hessian.col(j) = (*above - *below) / (2 * h);
  }
  return Eigen::MatrixXd(0.5 * (hessian + hessian.transpose()));
}

/// Multipliers that come nearest to balance, by least squares, with the ripples' sum 1.
Eigen::VectorXd balanced_multipliers(const Conditions& conditions, Eigen::Index ripples) {
  const Eigen::Index m = conditions.slopes.rows(), n = conditions.slopes.cols();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, m);
  system.topRows(n) = conditions.slopes.transpose();
  system.row(n).head(ripples).setOnes();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  right[n] = 1;
  return solution_of(Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(system), right);
}

struct Balanced {
  GeneratorVector u;
  ActiveSet active;
  Eigen::VectorXd multipliers;
};

/// Newton's method on heights = E, excesses = 0, pull = 0, sum of ripples' multipliers = 1.
std::optional<Balanced> balanced(const GeneratorError& error, GeneratorVector u, const ActiveSet& active) {
  const Eigen::Index n = u.size(), m = active.size(), k = static_cast<Eigen::Index>(active.ripples.size());
  auto conditions = conditions_at(error, u, active);
  if (!conditions || k == 0 || m > n + 1) return std::nullopt;
  Eigen::VectorXd multipliers = balanced_multipliers(*conditions, k);
  double E = conditions->values.head(k).mean();
  for (int iteration = 0; iteration < 25 && !error.task().stop(); ++iteration) {
    const auto hessian = curvature_at(error, u, active, multipliers);
    if (!hessian) return std::nullopt;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m + 1, n + m + 1);  // unknowns: u, multipliers, E
    Eigen::VectorXd right(n + m + 1);
    system.topLeftCorner(n, n) = *hessian;
    system.block(0, n, n, m) = conditions->slopes.transpose();
    right.head(n) = -conditions->slopes.transpose() * multipliers;
    system.block(n, 0, m, n) = conditions->slopes;
    system.block(n, n + m, k, 1).setConstant(-1);
    right.segment(n, m) = -conditions->values;
    right.segment(n, k).array() += E;
    system.block(n + m, n, 1, k).setOnes();
    right[n + m] = 1 - multipliers.head(k).sum();
    const Eigen::VectorXd step = solution_of(system.fullPivLu(), right);
    if (!step.allFinite() || step.head(n).cwiseAbs().maxCoeff() > 0.5) return std::nullopt;
    u += step.head(n);
    multipliers += step.segment(n, m);
    E += step[n + m];
    conditions = conditions_at(error, u, active);
    if (!conditions) return std::nullopt;
    const double uneven = (conditions->values.head(k).array() - E).abs().maxCoeff();
    const double pull = (conditions->slopes.transpose() * multipliers).cwiseAbs().maxCoeff();
    if (uneven <= slack::level * E && pull <= slack::no_pull &&
        step.head(n).cwiseAbs().maxCoeff() < slack::no_pull)
      return Balanced{u, active, multipliers};
  }
  return std::nullopt;
}

/// The second-order condition on the directions that change no active condition.
bool curves_up(const GeneratorError& error, const Balanced& at) {
  const auto conditions = conditions_at(error, at.u, at.active);
  const auto hessian = curvature_at(error, at.u, at.active, at.multipliers);
  if (!conditions || !hessian) return false;
  const auto k = static_cast<Eigen::Index>(at.active.ripples.size());
  Eigen::MatrixXd rows =
      conditions->slopes;  // heights may only change together: with dE as a further unknown
  rows.conservativeResize(rows.rows(), rows.cols() + 1);
  rows.col(rows.cols() - 1).setZero();
  rows.col(rows.cols() - 1).head(k).setConstant(-1);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const double largest = svd.singularValues()[0];
  const auto rank = (svd.singularValues().array() > slack::rank_of_conditions * largest).count();
  if (rank < rows.rows() - 1) return false;
  const Eigen::MatrixXd free = svd.matrixV().rightCols(rows.cols() - rank).topRows(at.u.size());
  if (free.cols() == 0) return true;
  const Eigen::MatrixXd bend = free.transpose() * *hessian * free;
  return is_definite(bend);
}

std::vector<std::string> names_of(const GeneratorError& error, const GeneratorVector& u,
                                  const std::vector<std::size_t>& numbers) {
  const auto limits = limits_of(error, u);
  std::vector<std::string> names;
  for (const std::size_t number : numbers)
    if (std::find(names.begin(), names.end(), limits[number].name) == names.end())
      names.push_back(limits[number].name);
  return names;
}

/// The conditions at work near u: those with negative multipliers are let go one by one.
std::optional<Balanced> held(const GeneratorError& error, const GeneratorVector& u, ActiveSet active) {
  while (active.size() > 1 && !error.task().stop()) {
    auto found = balanced(error, u, active);
    if (!found) return std::nullopt;
    Eigen::Index weakest = 0;
    if (found->multipliers.minCoeff(&weakest) > 0) return found;
    const auto k = static_cast<Eigen::Index>(active.ripples.size());
    if (weakest < k)
      active.ripples.erase(active.ripples.begin() + weakest);
    else
      active.limits.erase(active.limits.begin() + (weakest - k));
  }
  return std::nullopt;
}

}  // namespace

void settle_optimum(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design) {
  const GeneratorError error(task, wanted, design.linkage.branch);
  const GeneratorVector u = error.unknowns_of(design);
  MinimaxOptimum optimum;
  optimum.limits = names_of(error, u, near_at(error, u, slack::told_ripples).limits);
  for (const double share : slack::holding_ripples) {
    const auto found = held(error, u, near_at(error, u, share));
    if (!found) continue;
    FunctionDesign level = with_unknowns(error, design, found->u);
    if (measure_design(task, wanted, level) != FunctionDefect::none) continue;
    if (level.error_largest >
        (1 + slack::no_worse) * std::min(design.error_largest, ripples_of(error, u).front().height))
      continue;
    design = level;
    optimum.limits = names_of(error, found->u, found->active.limits);
    optimum.proven = curves_up(error, *found);
    break;
  }
  const auto ripples = ripples_of(error, error.unknowns_of(design));
  optimum.unknowns = static_cast<int>(error.size());
  optimum.ripples =
      static_cast<int>(std::count_if(ripples.begin(), ripples.end(), [&](const ErrorRipple& ripple) {
        return ripple.height > (1 - slack::told_ripples) * ripples.front().height;
      }));
  design.optimum = optimum;
}

}  // namespace kempe
