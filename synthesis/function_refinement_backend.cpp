// NLopt on function generators: SLSQP on the least squares program, Subplex on the free starts of precision
// points.
//
// Least squares: minimise sum w_j e_j^2 within
//   -cos(limit) <= cos mu <= cos(limit)          at its two extremes over the range
//   |ln(link/link)| <= ln(longest_ratio)         every two links

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "synthesis/function_conditions.hpp"

namespace kempe {
namespace {

constexpr int own_places = 41;
constexpr double no_design_cost = 10;  // rad: worse than any structural error
using Solver = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

struct Program {
  GeneratorError error;
  std::vector<double> places, weights;
  double unit;  // rad: errors are counted in it, so that the solver sees numbers near 1

  GeneratorVector vector(const double* u) const { return Eigen::Map<const Eigen::VectorXd>(u, error.size()); }
};

double objective(unsigned n, const double* u, double* gradient, void* data) {
  const auto& program = *static_cast<const Program*>(data);
  if (gradient) std::fill(gradient, gradient + n, 0.0);
  const GeneratorVector at = program.vector(u);
  const double scale = 1 / (program.unit * program.unit);
  double sum = 0;
  for (std::size_t j = 0; j < program.places.size(); ++j) {
    const Sloped error = program.error.at(at, program.places[j]);
    const double weight = program.weights[j] * scale;
    sum += weight * error.value * error.value;
    for (unsigned i = 0; gradient && i < n; ++i) gradient[i] += 2 * weight * error.value * error.slope[i];
  }
  return sum;
}

void constraints(unsigned m, double* result, unsigned n, const double* u, double* gradient, void* data) {
  const auto& program = *static_cast<const Program*>(data);
  const auto limits = limits_of(program.error, program.vector(u));
  for (unsigned row = 0; row < m; ++row) {
    result[row] = limits[row].excess.value;
    for (unsigned i = 0; gradient && i < n; ++i) gradient[row * n + i] = limits[row].excess.slope[i];
  }
}

/// Chebyshev's spacing, denser towards the ends where the error's ripples are narrow; weights that make sums
/// means over the range.
void lay_out_places(Program& program) {
  const FunctionTask& task = program.error.task();
  std::vector<double>& x = program.places;
  const double middle = 0.5 * (task.x_lower + task.x_upper), half = 0.5 * (task.x_upper - task.x_lower);
  for (int i = 0; i < own_places; ++i)
    x.push_back(std::clamp(middle - half * std::cos(pi * i / (own_places - 1)), task.x_lower, task.x_upper));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double left = i == 0 ? x[i] : x[i - 1], right = i + 1 == x.size() ? x[i] : x[i + 1];
    program.weights.push_back((right - left) / (4 * half));
  }
}

/// Runs SLSQP from u; its verdict is not used, the design is judged anew.
void run(Program& program, GeneratorVector& u) {
  std::vector<double> all(u.data(), u.data() + u.size());
  const auto n = static_cast<unsigned>(all.size());
  const Solver solver(nlopt_create(NLOPT_LD_SLSQP, n), &nlopt_destroy);
  nlopt_set_min_objective(solver.get(), objective, &program);
  const std::vector<double> slack(limits_of(program.error, u).size(), 1e-12);
  nlopt_add_inequality_mconstraint(solver.get(), static_cast<unsigned>(slack.size()), constraints, &program,
                                   slack.data());
  nlopt_set_xtol_rel(solver.get(), 1e-12);
  nlopt_set_maxeval(solver.get(), 300);
  double value = 0;
  nlopt_optimize(solver.get(), all.data(), &value);
  if (std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v) && std::abs(v) < 50; }))
    u = program.vector(all.data());
}

struct StartSearch {
  const FunctionTask& task;
  const WantedAngles& wanted;

  std::vector<double> unknowns_of(const FunctionDesign& design) const {
    std::vector<double> u;
    if (!task.input_start) u.push_back(design.input_start);
    if (!task.output_start) u.push_back(design.output_start);
    return u;
  }
  FunctionCandidate candidate(const double* u) const {
    int next = 0;
    Starts starts{};
    starts.input = task.input_start ? *task.input_start : u[next++];
    starts.output = task.output_start ? *task.output_start : u[next];
    const auto coefficients = coefficients_through_first_three(wanted, starts);
    return coefficients ? judged(task, wanted, starts, *coefficients) : FunctionCandidate{};
  }
};

double largest_error(unsigned, const double* u, double*, void* data) {
  const FunctionCandidate candidate = static_cast<const StartSearch*>(data)->candidate(u);
  return candidate.defect == FunctionDefect::none ? candidate.design.error_largest : no_design_cost;
}

}  // namespace

double kept_transmission(const FunctionTask& task) {
  constexpr double away_from_dead_points = 1e-3, above_rounding = 1e-10;
  return std::max(task.transmission + above_rounding, away_from_dead_points);
}

FunctionDesign with_best_starts(const FunctionTask& task, const WantedAngles& wanted,
                                const FunctionDesign& design) {
  StartSearch search{task, wanted};
  std::vector<double> u = search.unknowns_of(design);
  const Solver solver(nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(u.size())), &nlopt_destroy);
  nlopt_set_min_objective(solver.get(), largest_error, &search);
  nlopt_set_initial_step1(solver.get(), 0.05);
  nlopt_set_xtol_rel(solver.get(), 1e-9);
  nlopt_set_maxeval(solver.get(), 400);
  double value = no_design_cost;
  nlopt_optimize(solver.get(), u.data(), &value);
  const FunctionCandidate best = search.candidate(u.data());
  const bool better = best.defect == FunctionDefect::none && best.design.error_largest < design.error_largest;
  return better ? best.design : design;
}

std::optional<FunctionDesign> least_squares_fit(const FunctionTask& task, const WantedAngles& wanted,
                                                const FunctionDesign& start) {
  Program program{GeneratorError(task, wanted, start.linkage.branch), {}, {}, 0};
  lay_out_places(program);
  GeneratorVector u = program.error.unknowns_of(start);
  std::optional<FunctionDesign> best;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    program.unit = 1e-12;
    for (const double x : program.places)
      program.unit = std::max(program.unit, std::abs(program.error.at(u, x).value));
    run(program, u);
    FunctionDesign now = with_unknowns(program.error, start, u);
    // A solver that stops on rounding goes on when it is started again with its new unit of error.
    if (trace_curve(task, wanted, now) != FunctionDefect::none) {
      if (best || round > 1) break;
      continue;
    }
    const bool settled = best && !(now.error_rms < 0.9999 * best->error_rms);
    if (!best || now.error_rms < best->error_rms) best = now;
    if (settled) break;
  }
  return best;
}

}  // namespace kempe
