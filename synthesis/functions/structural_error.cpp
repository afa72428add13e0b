#include "synthesis/functions/structural_error.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "geometry/point.hpp"
#include "synthesis/functions/precision_points.hpp"
#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {
namespace {

constexpr int most_iterations = 200;

/// Places of a task with their share of the range, so that sums over them are integrals.
struct Places {
  std::vector<double> x, weight;
  explicit Places(const StructuralErrorTask& task) {
    const int n = std::max(task.places, 8);
    const double middle = 0.5 * (task.lower + task.upper), half = 0.5 * (task.upper - task.lower);
    for (int i = 0; i < n; ++i)
      x.push_back(i == 0 ? task.lower : i == n - 1 ? task.upper : middle - half * std::cos(pi * i / (n - 1)));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double left = i == 0 ? x[i] : x[i - 1], right = i + 1 == x.size() ? x[i] : x[i + 1];
      weight.push_back(0.5 * (right - left) / (task.upper - task.lower));
    }
  }
};

/// Residuals and gradients at some places, a row each.
struct Rows {
  Eigen::VectorXd value;
  Eigen::MatrixXd gradient;
};

std::optional<Rows> rows_at(const StructuralErrorTask& task, const std::vector<double>& x,
                            const Eigen::VectorXd& p) {
  const auto count = static_cast<Eigen::Index>(x.size());
  Rows rows{Eigen::VectorXd(count), Eigen::MatrixXd(count, p.size())};
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(p.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto value = task.residual(x[static_cast<std::size_t>(i)], p, &gradient);
    if (!value || !std::isfinite(*value) || !gradient.allFinite()) return std::nullopt;
    rows.value[i] = *value;
    rows.gradient.row(i) = gradient;
  }
  return rows;
}

std::optional<double> error_at(const StructuralErrorTask& task, const Eigen::VectorXd& p, double x) {
  const auto value = task.residual(x, p, nullptr);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::vector<double>> errors_at(const StructuralErrorTask& task, const std::vector<double>& x,
                                             const Eigen::VectorXd& p) {
  std::vector<double> errors;
  for (const double place : x) {
    const auto error = error_at(task, p, place);
    if (!error) return std::nullopt;
    errors.push_back(*error);
  }
  return errors;
}

double largest_of(const std::vector<double>& errors) {
  double largest = 0;
  for (const double error : errors) largest = std::max(largest, std::abs(error));
  return largest;
}

/// The extreme of the residual near a place of the grid: golden section between its neighbours.
Ripple refined(const StructuralErrorTask& task, const Eigen::VectorXd& p, const Places& places, std::size_t i,
               double error) {
  if (i == 0 || i + 1 == places.x.size()) return {places.x[i], error};
  const double sign = error < 0 ? -1 : 1;
  const auto height = [&](double x) { return sign * error_at(task, p, x).value_or(0); };
  const double x = top_by_golden_section(height, places.x[i - 1], places.x[i + 1], 45), best = height(x);
  return best > sign * error ? Ripple{x, sign * best} : Ripple{places.x[i], error};
}

double zero_between(const StructuralErrorTask& task, const Eigen::VectorXd& p, double lower, double upper,
                    bool rises) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lower + upper);
    ((error_at(task, p, middle).value_or(0) < 0) == rises ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// The fit that parameters make: its ripples, zeros and figures.
tl::expected<StructuralFit, NoFit> described(const StructuralErrorTask& task, const Places& places,
                                             const Eigen::VectorXd& p, FitVerdict verdict, int iterations) {
  const auto errors = errors_at(task, places.x, p);
  if (!errors) return tl::unexpected(NoFit::not_defined);
  StructuralFit fit;
  fit.parameters = p;
  fit.verdict = verdict;
  fit.iterations = iterations;
  double square = 0;
  std::optional<std::size_t> top;  // highest place since the last change of sign
  for (std::size_t i = 0; i < errors->size(); ++i) {
    square += places.weight[i] * (*errors)[i] * (*errors)[i];
    if (top && ((*errors)[i] < 0) != ((*errors)[*top] < 0)) {
      fit.ripples.push_back(refined(task, p, places, *top, (*errors)[*top]));
      fit.zeros.push_back(zero_between(task, p, places.x[i - 1], places.x[i], (*errors)[i - 1] < 0));
      top.reset();
    }
    if (!top || std::abs((*errors)[i]) > std::abs((*errors)[*top])) top = i;
  }
  fit.ripples.push_back(refined(task, p, places, *top, (*errors)[*top]));
  fit.rms = std::sqrt(square);
  for (const Ripple& ripple : fit.ripples) fit.largest = std::max(fit.largest, std::abs(ripple.error));
  return fit;
}

double sum_of_squares(const Places& places, const Eigen::VectorXd& value) {
  double sum = 0;
  for (Eigen::Index i = 0; i < value.size(); ++i)
    sum += places.weight[static_cast<std::size_t>(i)] * value[i] * value[i];
  return sum;
}

/// n + 1 neighbouring ripples: of more, the lower one at an end goes first.
std::vector<Ripple> alternation(std::vector<Ripple> ripples, std::size_t count) {
  while (ripples.size() > count) {
    const bool first_is_lower = std::abs(ripples.front().error) < std::abs(ripples.back().error);
    ripples.erase(first_is_lower ? ripples.begin() : ripples.end() - 1);
  }
  return ripples;
}

double spread(const std::vector<Ripple>& ripples) {
  double least = std::abs(ripples.front().error), most = least;
  for (const Ripple& ripple : ripples) {
    least = std::min(least, std::abs(ripple.error));
    most = std::max(most, std::abs(ripple.error));
  }
  return most > 0 ? 1 - least / most : 0;
}

/// The step that levels the ripples, to first order: e_i + g_i . step = +-E with E unknown.
std::optional<Eigen::VectorXd> levelling_step(const StructuralErrorTask& task,
                                              const std::vector<Ripple>& ripples, const Eigen::VectorXd& p) {
  std::vector<double> x;
  for (const Ripple& ripple : ripples) x.push_back(ripple.x);
  const auto rows = rows_at(task, x, p);
  if (!rows) return std::nullopt;
  Eigen::MatrixXd system(rows->gradient.rows(), p.size() + 1);
  system.leftCols(p.size()) = rows->gradient;
  for (Eigen::Index i = 0; i < system.rows(); ++i) system(i, p.size()) = i % 2 == 0 ? -1 : 1;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(system);
  if (qr.rank() < system.cols()) return std::nullopt;
  const Eigen::VectorXd solution = solution_of(qr, -rows->value);
  return Eigen::VectorXd(solution.head(p.size()));
}

}  // namespace

std::string_view name(FitVerdict verdict) {
  switch (verdict) {
    case FitVerdict::exact_at_points: return "exact at the precision points";
    case FitVerdict::least_squares: return "least squares";
    case FitVerdict::equal_ripples: return "equal ripples";
    case FitVerdict::fewer_ripples: break;
  }
  return "fewer ripples than Chebyshev's theorem requires";
}

std::string_view name(NoFit why) {
  switch (why) {
    case NoFit::not_defined: return "not defined over the whole range";
    case NoFit::dependent: return "the parameters depend on each other";
    case NoFit::not_converged: break;
  }
  return "the iteration does not converge";
}

double StructuralFit::evenness() const { return ripples.empty() || largest == 0 ? 0 : 1 - spread(ripples); }

tl::expected<StructuralFit, NoFit> fit_through_points(const StructuralErrorTask& task,
                                                      const std::vector<double>& points) {
  const Places places(task);
  Eigen::VectorXd p = task.start;
  if (points.size() != static_cast<std::size_t>(p.size())) return tl::unexpected(NoFit::dependent);
  const auto start_errors = errors_at(task, places.x, p);
  const double scale = start_errors ? largest_of(*start_errors) : 1;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    const auto rows = rows_at(task, points, p);
    if (!rows) return tl::unexpected(NoFit::not_defined);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows->gradient);
    if (qr.rank() < p.size()) return tl::unexpected(NoFit::dependent);
    const Eigen::VectorXd step = solution_of(qr, -rows->value);
    const double before = rows->value.norm();
    double share = 1;
    std::optional<Rows> next;
    for (; share > slack::least_newton_share; share *= 0.5) {
      next = rows_at(task, points, p + share * step);
      if (next && next->value.norm() <= before) break;
    }
    if (!next || !(next->value.norm() < before) || before <= slack::residual_rounding * scale) {
      if (before > slack::residual_converged * scale) return tl::unexpected(NoFit::not_converged);
      return described(task, places, p, FitVerdict::exact_at_points, iteration);
    }
    p += share * step;
  }
  return tl::unexpected(NoFit::not_converged);
}

tl::expected<StructuralFit, NoFit> fit_through_chebyshev_points(const StructuralErrorTask& task) {
  return fit_through_points(task,
                            chebyshev_points(task.lower, task.upper, static_cast<int>(task.start.size())));
}

tl::expected<StructuralFit, NoFit> fit_least_squares(const StructuralErrorTask& task) {
  const Places places(task);
  Eigen::VectorXd root_weight(static_cast<Eigen::Index>(places.x.size()));
  for (Eigen::Index i = 0; i < root_weight.size(); ++i)
    root_weight[i] = std::sqrt(places.weight[static_cast<std::size_t>(i)]);
  Eigen::VectorXd p = task.start;
  auto rows = rows_at(task, places.x, p);
  if (!rows) return tl::unexpected(NoFit::not_defined);
  double damping = 0, cost = sum_of_squares(places, rows->value);
  int iteration = 0;
  while (++iteration <= most_iterations) {
    const Eigen::MatrixXd weighted = root_weight.asDiagonal() * rows->gradient;
    Eigen::MatrixXd system(weighted.rows() + p.size(), p.size());
    system << weighted, (std::sqrt(damping) * weighted.colwise().norm()).asDiagonal().toDenseMatrix();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
    right.head(weighted.rows()) = -root_weight.cwiseProduct(rows->value);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(system);
    if (qr.rank() < p.size()) return tl::unexpected(NoFit::dependent);
    const Eigen::VectorXd step = solution_of(qr, right);
    const auto next = rows_at(task, places.x, p + step);
    const double next_cost = next ? sum_of_squares(places, next->value) : 0;
    if (next && next_cost < cost) {
      const bool at_rest = cost - next_cost <= slack::cost_at_rest * cost;
      p += step, rows = next, cost = next_cost, damping *= 0.1;
      if (damping < slack::damping_none) damping = 0;
      if (at_rest) break;
    } else {
      if (damping > slack::damping_most || step.norm() <= slack::cost_at_rest * (1 + p.norm())) break;
      damping = std::max(10 * damping, slack::damping_first);
    }
  }
  return described(task, places, p, FitVerdict::least_squares, std::min(iteration, most_iterations));
}

tl::expected<StructuralFit, NoFit> fit_minimax(const StructuralErrorTask& task) {
  const Places places(task);
  auto best = fit_least_squares(task);
  if (!best) return best;
  best->verdict = FitVerdict::fewer_ripples;
  const auto wanted = static_cast<std::size_t>(task.start.size()) + 1;
  for (int iteration = best->iterations + 1; iteration <= most_iterations; ++iteration) {
    if (best->ripples.size() < wanted) return best;
    const std::vector<Ripple> chosen = alternation(best->ripples, wanted);
    if (spread(chosen) < slack::equal_ripples) {
      best->verdict = FitVerdict::equal_ripples;
      return best;
    }
    const auto step = levelling_step(task, chosen, best->parameters);
    if (!step) return best;
    // Far from the solution of a nonlinear family a whole step may overshoot.
    tl::expected<StructuralFit, NoFit> next = tl::unexpected(NoFit::not_defined);
    for (double share = 1; share > slack::least_levelling_share; share *= 0.5) {
      next = described(task, places, best->parameters + share * *step, FitVerdict::fewer_ripples, iteration);
      if (next && next->largest < best->largest) break;
    }
    if (!next || !(next->largest < best->largest)) {  // round-off ends it: equal up to that, or not at all
      if (spread(chosen) < slack::equal_after_rounding) best->verdict = FitVerdict::equal_ripples;
      return best;
    }
    best = std::move(next);
  }
  return best;
}

}  // namespace kempe
