// Refinement of function generators with NLopt.
//
// Unknowns u = (ln a, ln b, ln c, phi0, psi0), a start only where it is free. With the loop's closure
//   F = a^2 - b^2 + c^2 + d^2 + 2 d c cos psi - 2 a d cos phi - 2 a c cos(phi - psi) = 0
// the output angle's derivatives are d psi/d w = -F_w / F_psi, and
//   F_a = 2a - 2d cos phi - 2c cos(phi-psi)      F_b = -2b      F_c = 2c + 2d cos psi - 2a cos(phi-psi)
//   F_phi = 2ad sin phi + 2ac sin(phi-psi)       F_psi = -2dc sin psi - 2ac sin(phi-psi)
// Structural error e = psi - psi0 - turn(x). Minimax: minimise t with -t <= e_j <= t; least squares: minimise sum e^2.
// Transmission: cos mu = (b^2 + c^2 - a^2 - d^2 + 2 a d cos phi) / (2 b c), kept within +-cos(limit).

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/function_refinement.hpp"
#include "synthesis/structural_error.hpp"

namespace kempe {
namespace {

constexpr int fitted_places = 61;
constexpr double penalty = 10;  // rad: worse than any structural error

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

/// A design as the vector of unknowns, and back.
struct Layout {
  const FunctionTask& task;
  const FunctionDesign& start;
  bool free_input, free_output;

  std::vector<double> vector() const {
    std::vector<double> u{std::log(start.linkage.input), std::log(start.linkage.coupler), std::log(start.linkage.output)};
    if (free_input) u.push_back(start.input_start);
    if (free_output) u.push_back(start.output_start);
    return u;
  }

  FunctionDesign design(const double* u) const {
    FunctionDesign d = start;
    d.linkage.input = std::exp(u[0]);
    d.linkage.coupler = std::exp(u[1]);
    d.linkage.output = std::exp(u[2]);
    int next = 3;
    if (free_input) d.input_start = u[next++];
    if (free_output) d.output_start = u[next];
    return d;
  }

  unsigned count() const { return 3U + (free_input ? 1U : 0U) + (free_output ? 1U : 0U); }
};

struct ErrorAt {
  double error = penalty;
  double cosine = 1;  // of the transmission angle
  std::array<double, 5> error_slope{}, cosine_slope{};
};

ErrorAt error_at(const Layout& layout, const WantedAngles& wanted, const double* u, double x) {
  const FunctionDesign design = layout.design(u);
  const double a = design.linkage.input, b = design.linkage.coupler, c = design.linkage.output, d = design.linkage.ground;
  const double phi = design.input_start + wanted.input_turn(x);
  ErrorAt at;
  at.cosine = (b * b + c * c - a * a - d * d + 2 * a * d * std::cos(phi)) / (2 * b * c);
  at.cosine_slope[0] = (-a * a + a * d * std::cos(phi)) / (b * c);
  at.cosine_slope[1] = b / c - at.cosine;
  at.cosine_slope[2] = c / b - at.cosine;
  std::size_t next = 3;
  if (layout.free_input) at.cosine_slope[next++] = -a * d * std::sin(phi) / (b * c);
  const auto output = design.linkage.output_angle(phi);
  if (!output) return at;
  const double psi = *output;
  at.error = wrapped(psi - design.output_start - wanted.output_turn(x));
  const double cos_both = std::cos(phi - psi), sin_both = std::sin(phi - psi);
  const double slope_psi = -2 * d * c * std::sin(psi) - 2 * a * c * sin_both;
  if (slope_psi == 0) return at;
  at.error_slope[0] = -a * (2 * a - 2 * d * std::cos(phi) - 2 * c * cos_both) / slope_psi;
  at.error_slope[1] = 2 * b * b / slope_psi;
  at.error_slope[2] = -c * (2 * c + 2 * d * std::cos(psi) - 2 * a * cos_both) / slope_psi;
  next = 3;
  if (layout.free_input) at.error_slope[next++] = -(2 * a * d * std::sin(phi) + 2 * a * c * sin_both) / slope_psi;
  if (layout.free_output) at.error_slope[next] = -1;
  return at;
}

struct Problem {
  Layout layout;
  const WantedAngles& wanted;
  std::vector<double> places;
  bool minimax;
  double unit;  // rad: errors and t are counted in it, so that the solver sees numbers near 1
};

/// Objective: the slack t (the last unknown) or the mean square error.
double objective(unsigned n, const double* u, double* gradient, void* data) {
  const auto& problem = *static_cast<const Problem*>(data);
  if (gradient) std::fill(gradient, gradient + n, 0.0);
  if (problem.minimax) {
    if (gradient) gradient[n - 1] = 1;
    return u[n - 1];
  }
  double sum = 0;
  for (const double x : problem.places) {
    const ErrorAt at = error_at(problem.layout, problem.wanted, u, x);
    sum += at.error * at.error;
    for (unsigned i = 0; gradient && i < n; ++i) gradient[i] += 2 * at.error * at.error_slope[i];
  }
  const double count = static_cast<double>(problem.places.size()) * problem.unit * problem.unit;
  for (unsigned i = 0; gradient && i < n; ++i) gradient[i] /= count;
  return sum / count;
}

/// Per place: e - t, -e - t (minimax only), then cos mu - cos limit, -cos mu - cos limit.
void constraints(unsigned m, double* result, unsigned n, const double* u, double* gradient, void* data) {
  const auto& problem = *static_cast<const Problem*>(data);
  const unsigned variables = problem.layout.count();
  const double limit = std::cos(problem.layout.task.transmission);
  if (gradient) std::fill(gradient, gradient + static_cast<std::size_t>(m) * n, 0.0);
  unsigned row = 0;
  const auto put = [&](double value, double factor, const std::array<double, 5>& slope, bool slack) {
    result[row] = value;
    if (gradient) {
      for (unsigned i = 0; i < variables; ++i) gradient[row * n + i] = factor * slope[i];
      if (slack) gradient[row * n + n - 1] = -1;
    }
    ++row;
  };
  for (const double x : problem.places) {
    const ErrorAt at = error_at(problem.layout, problem.wanted, u, x);
    if (problem.minimax) {
      put(at.error / problem.unit - u[n - 1], 1 / problem.unit, at.error_slope, true);
      put(-at.error / problem.unit - u[n - 1], -1 / problem.unit, at.error_slope, true);
    }
    put(at.cosine - limit, 1, at.cosine_slope, false);
    put(-at.cosine - limit, -1, at.cosine_slope, false);
  }
}

FunctionDesign fitted(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& start, bool minimax) {
  Problem problem{{task, start, !task.input_start, !task.output_start}, wanted, {},
                  minimax, std::max(start.error_largest, 1e-12)};
  for (int i = 0; i < fitted_places; ++i)  // denser towards the ends, where the error's ripples are narrow
    problem.places.push_back(0.5 * (task.x_lower + task.x_upper) -
                             0.5 * (task.x_upper - task.x_lower) * std::cos(pi * i / (fitted_places - 1)));
  std::vector<double> u = problem.layout.vector();
  if (problem.minimax) u.push_back(start.error_largest / problem.unit);
  const unsigned n = static_cast<unsigned>(u.size());
  const unsigned rows = (problem.minimax ? 4U : 2U) * fitted_places;
  nlopt_opt solver = nlopt_create(NLOPT_LD_SLSQP, n);
  nlopt_set_min_objective(solver, objective, &problem);
  const std::vector<double> slack(rows, 1e-12);
  nlopt_add_inequality_mconstraint(solver, rows, constraints, &problem, slack.data());
  // Within reach of the start: links half to twice as long, starts within 30 degrees.
  std::vector<double> lower(n), upper(n);
  for (unsigned i = 0; i < n; ++i) {
    const double step = i < 3 ? std::log(2.0) : radians(30);
    lower[i] = u[i] - step;
    upper[i] = u[i] + step;
  }
  if (problem.minimax) lower[n - 1] = 0;
  nlopt_set_lower_bounds(solver, lower.data());
  nlopt_set_upper_bounds(solver, upper.data());
  nlopt_set_xtol_rel(solver, 1e-13);
  nlopt_set_maxeval(solver, 500);
  double value = 0;
  nlopt_optimize(solver, u.data(), &value);  // its verdict is not used: the design is judged anew
  nlopt_destroy(solver);
  FunctionDesign design = problem.layout.design(u.data());
  return trace_curve(task, wanted, design) == FunctionDefect::none ? design : start;
}

/// Minimax by exchange, which the transmission limit does not enter: nothing if it comes out broken.
std::optional<FunctionDesign> with_equal_ripples(const FunctionTask& task, const WantedAngles& wanted,
                                                 const FunctionDesign& start) {
  const Layout layout{task, start, !task.input_start, !task.output_start};
  const std::vector<double> u = layout.vector();
  StructuralErrorTask fit;
  fit.lower = task.x_lower;
  fit.upper = task.x_upper;
  fit.start = Eigen::Map<const Eigen::VectorXd>(u.data(), static_cast<Eigen::Index>(u.size()));
  fit.residual = [&](double x, const Eigen::VectorXd& p, Eigen::VectorXd* gradient) -> std::optional<double> {
    const ErrorAt at = error_at(layout, wanted, p.data(), x);
    if (at.error >= penalty) return std::nullopt;
    if (gradient != nullptr)
      for (Eigen::Index i = 0; i < p.size(); ++i) (*gradient)[i] = at.error_slope[static_cast<std::size_t>(i)];
    return at.error;
  };
  const auto found = fit_minimax(fit);
  if (!found) return std::nullopt;
  FunctionDesign design = layout.design(found->parameters.data());
  if (trace_curve(task, wanted, design) != FunctionDefect::none) return std::nullopt;
  return design;
}

struct StartSearch {
  const FunctionTask& task;
  const WantedAngles& wanted;
  Starts starts_of(const double* u) const {
    int next = 0;
    Starts starts{};
    starts.input = task.input_start ? *task.input_start : u[next++];
    starts.output = task.output_start ? *task.output_start : u[next];
    return starts;
  }
};

double largest_error(unsigned, const double* u, double*, void* data) {
  const auto& search = *static_cast<const StartSearch*>(data);
  const Starts starts = search.starts_of(u);
  std::vector<double> phi, psi;
  for (const double x : search.wanted.precision_points()) {
    phi.push_back(starts.input + search.wanted.input_turn(x));
    psi.push_back(starts.output + search.wanted.output_turn(x));
  }
  const auto coefficients = freudenstein_three_points(phi, psi);
  if (!coefficients) return penalty;
  const FunctionCandidate candidate = judged(search.task, search.wanted, starts, *coefficients);
  return candidate.defect == FunctionDefect::none ? candidate.design.error_largest : penalty;
}

/// Three precision points with free starts: the starts that make the largest error smallest.
FunctionDesign with_best_starts(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& start) {
  StartSearch search{task, wanted};
  std::vector<double> u;
  if (!task.input_start) u.push_back(start.input_start);
  if (!task.output_start) u.push_back(start.output_start);
  nlopt_opt solver = nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(u.size()));
  nlopt_set_min_objective(solver, largest_error, &search);
  nlopt_set_initial_step1(solver, 0.05);
  nlopt_set_xtol_rel(solver, 1e-9);
  nlopt_set_maxeval(solver, 400);
  double value = penalty;
  nlopt_optimize(solver, u.data(), &value);
  nlopt_destroy(solver);
  const Starts starts = search.starts_of(u.data());
  std::vector<double> phi, psi;
  for (const double x : wanted.precision_points()) {
    phi.push_back(starts.input + wanted.input_turn(x));
    psi.push_back(starts.output + wanted.output_turn(x));
  }
  const auto coefficients = freudenstein_three_points(phi, psi);
  if (!coefficients) return start;
  const FunctionCandidate best = judged(task, wanted, starts, *coefficients);
  return best.defect == FunctionDefect::none && best.design.error_largest < start.error_largest ? best.design : start;
}

}  // namespace

FunctionDesign refined(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& start) {
  const bool free_starts = !task.input_start || !task.output_start;
  FunctionDesign best = free_starts && task.points == 3 ? with_best_starts(task, wanted, start) : start;
  if (task.method == FunctionMethod::precision_points) return best;
  // Least squares first, for both: from there the largest error has its ripples in place already. A solver that stops
  // on round-off goes on when it is started again with its new unit of error.
  const auto improve = [&](bool minimax) {
    const auto cost = [minimax](const FunctionDesign& d) { return minimax ? d.error_largest : d.error_rms; };
    for (int round = 0; round < 12; ++round) {
      const FunctionDesign next = fitted(task, wanted, best, minimax);
      if (!(cost(next) < 0.9999 * cost(best))) break;
      best = next;
    }
  };
  improve(false);
  if (task.method == FunctionMethod::minimax) {
    const auto even = with_equal_ripples(task, wanted, best);
    if (even && even->error_largest < best.error_largest) best = *even;
    improve(true);
  }
  best.precision_points.clear();
  for (std::size_t i = 1; i < best.curve.size(); ++i) {  // where the error vanishes: now a result, not a choice
    const auto &left = best.curve[i - 1], &right = best.curve[i];
    if ((left.error < 0) != (right.error < 0))
      best.precision_points.push_back(left.x + (right.x - left.x) * left.error / (left.error - right.error));
  }
  return best;
}

}  // namespace kempe
