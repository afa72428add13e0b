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

#include "synthesis/functions/conditions.hpp"
#include "synthesis/functions/slack.hpp"

namespace kempe {
namespace {

using Solver = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

struct Program {
  GeneratorError error;
  std::vector<WantedPlace> places;
  double unit;                  // rad: errors are counted in it, so that the solver sees numbers near 1
  nlopt_opt at_work = nullptr;  // the solver that asks

  GeneratorVector vector(const double* u) const { return Eigen::Map<const Eigen::VectorXd>(u, error.size()); }
};

double objective(unsigned n, const double* u, double* gradient, void* data) {
  const auto& program = *static_cast<const Program*>(data);
  if (program.at_work != nullptr && program.error.task().stop()) nlopt_force_stop(program.at_work);
  if (gradient) std::fill(gradient, gradient + n, 0.0);
  const GeneratorVector at = program.vector(u);
  const double scale = 1 / (program.unit * program.unit);
  double sum = 0;
  for (std::size_t j = 0; j < program.places.size(); ++j) {
    const Sloped error = program.error.at(at, program.places[j]);
    const double weight = program.places[j].weight * scale;
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

/// Runs SLSQP from u; its verdict is not used, the design is judged anew.
void run(Program& program, GeneratorVector& u) {
  std::vector<double> all(u.data(), u.data() + u.size());
  const auto n = static_cast<unsigned>(all.size());
  const Solver solver(nlopt_create(NLOPT_LD_SLSQP, n), &nlopt_destroy);
  nlopt_set_min_objective(solver.get(), objective, &program);
  const std::vector<double> slack(limits_of(program.error, u).size(), slack::solver_slack);
  nlopt_add_inequality_mconstraint(solver.get(), static_cast<unsigned>(slack.size()), constraints, &program,
                                   slack.data());
  nlopt_set_xtol_rel(solver.get(), slack::variables_at_rest);
  nlopt_set_maxeval(solver.get(), 300);
  double value = 0;
  program.at_work = solver.get();
  nlopt_optimize(solver.get(), all.data(), &value);
  program.at_work = nullptr;
  if (std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v) && std::abs(v) < 50; }))
    u = program.vector(all.data());
}

struct StartSearch {
  const FunctionTask& task;
  const WantedAngles& wanted;
  nlopt_opt at_work = nullptr;  // the solver that asks

  Starts starts(const double* u) const {
    int next = 0;
    Starts starts{};
    starts.input = task.input_start ? *task.input_start : u[next++];
    starts.output = task.output_start ? *task.output_start : u[next];
    return starts;
  }
};

double cost_of_starts(unsigned, const double* u, double*, void* data) {
  const auto& search = *static_cast<const StartSearch*>(data);
  if (search.task.stop()) nlopt_force_stop(search.at_work);
  constexpr double far_beyond = 1e6;  // the solver wants finite figures
  return std::min(far_beyond, judged(search.task, search.wanted, search.starts(u)).cost());
}

}  // namespace

double kept_transmission(const FunctionTask& task) {
  return std::max(task.transmission + slack::above_rounding, slack::away_from_dead_points);
}

Starts refined_starts(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts,
                      double step) {
  StartSearch search{task, wanted};
  std::vector<double> u;
  if (!task.input_start) u.push_back(starts.input);
  if (!task.output_start) u.push_back(starts.output);
  for (const double first_step :
       {step, 0.1 * step, 0.01 * step}) {  // a corner of limits stops it: go on anew
    const Solver solver(nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(u.size())), &nlopt_destroy);
    nlopt_set_min_objective(solver.get(), cost_of_starts, &search);
    nlopt_set_initial_step1(solver.get(), first_step);
    nlopt_set_xtol_rel(solver.get(), slack::starts_at_rest);
    nlopt_set_maxeval(solver.get(), 200);
    double value = 0;
    search.at_work = solver.get();
    nlopt_optimize(solver.get(), u.data(), &value);
  }
  return search.starts(u.data());
}

std::optional<FunctionDesign> least_squares_fit(const FunctionTask& task, const WantedAngles& wanted,
                                                const FunctionDesign& start, SquareWeights weights,
                                                int places) {
  Program program{GeneratorError(task, wanted, start.linkage.branch),
                  places == all_places ? wanted.places() : wanted.some_places(places), 0};
  if (weights == SquareWeights::even_in_places)
    for (WantedPlace& place : program.places) place.weight = 1 / static_cast<double>(program.places.size());
  const auto root_mean_square = [&](const GeneratorVector& u) {
    program.unit = 1;
    return std::sqrt(objective(0, u.data(), nullptr, &program));
  };
  GeneratorVector u = program.error.unknowns_of(start);
  std::optional<FunctionDesign> best;
  double least = 0;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds && !task.stop(); ++round) {
    double unit = slack::least_unit;
    for (const WantedPlace& place : program.places)
      unit = std::max(unit, std::abs(program.error.at(u, place).value));
    program.unit = unit;
    run(program, u);
    FunctionDesign now = with_unknowns(program.error, start, u);
    // A solver that stops on rounding goes on when it is started again with its new unit of error.
    if (measure_design(task, wanted, now) != FunctionDefect::none) {
      if (best || round > 1) break;
      continue;
    }
    const double reached = root_mean_square(u);
    const bool settled = best && !(reached < 0.9999 * least);
    if (!best || reached < least) {
      best = now;
      least = reached;
    }
    if (settled) break;
  }
  return best;
}

}  // namespace kempe
