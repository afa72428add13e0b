#include "synthesis/search/steps/local_search.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "synthesis/search/steps/slack.hpp"
#include "synthesis/solvers/newton_polish.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {

double merit_of(const DesignProblem& problem, const Assessment& seen) {
  return seen.cost / problem.goal_scale() + slack::missing_weight * seen.violation +
         (seen.feasible ? 0 : slack::infeasible_weight);
}

double merit_at(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local) {
  return merit_of(problem, problem.assess(point, local.openings));
}

ChoiceResult no_result() {
  return {.cost = std::numeric_limits<double>::infinity(),
          .violation = std::numeric_limits<double>::infinity()};
}

bool better(const ChoiceResult& a, const ChoiceResult& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.cost < b.cost : a.violation < b.violation;
}

ChoiceResult judged(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local) {
  const Assessment seen = problem.assess(point, local.final_openings);
  return {.feasible = seen.feasible,
          .cost = seen.cost,
          .violation = seen.violation,
          .point = point,
          .evaluations = 1};
}

namespace {

/// Rounded to a decimal place so far below the task's size that it costs nothing: the last digits of a solver then do not
/// matter, and numbers are short in print.
DesignPoint rounded(const DesignProblem& problem, const DesignPoint& point) {
  const double scale = std::pow(10.0, 11 - std::floor(std::log10(problem.layout().unit)));
  const auto to_place = [&](double value) { return std::round(value * scale) / scale; };
  DesignPoint result{
      {std::log(to_place(std::exp(point.lengths.u))), std::log(to_place(std::exp(point.lengths.v)))},
      point.pole};
  if (problem.layout().pole_is_free) result.pole = {to_place(point.pole.x()), to_place(point.pole.y())};
  return result;
}

using LocalSolver = std::function<LocalResult(const SmoothProgram&, const DesignVector&)>;

/// The exchange method: solve, add the rows that the solution violates, solve again; then the last digits.
ChoiceResult exchange(const DesignProblem& shared, const DesignPoint& start, const LocalSolver& solve,
                      const LocalBudget& local, const StopFlag& stop) {
  DesignProblem problem = shared;
  problem.set_room(start.pole);
  DesignVector x = problem.vector_of(start);
  std::vector<Row> rows = problem.rows_at(x);
  std::uint64_t evaluations = 0;
  for (int i = 0; i < local.exchanges && !stop(); ++i) {
    const LocalResult solved = solve(problem.program(rows), x);
    evaluations += static_cast<std::uint64_t>(solved.evaluations);
    if (!solved.usable) break;
    x = solved.x;
    if (!problem.add_violated(rows, x, slack::violated_row)) break;
  }
  const DesignVector polished = stop() ? x : newton_polish(problem.program(rows), x);
  ChoiceResult best = judged(problem, problem.point_of(x), local);
  for (const DesignPoint& point :
       {problem.point_of(polished), rounded(problem, problem.point_of(polished))}) {
    const ChoiceResult here = judged(problem, point, local);
    if (here.feasible || better(here, best)) best = here;
  }
  best.evaluations += evaluations;
  return best;
}

}  // namespace

ChoiceResult refine(const DesignProblem& problem, const DesignPoint& start, const LocalBudget& local,
                    const StopFlag& stop) {
  const LocalSolver sqp = [&](const SmoothProgram& program, const DesignVector& x) {
    return minimize_by_sqp(program, x, local.evaluations, stop);
  };
  return exchange(problem, start, sqp, local, stop);
}

ChoiceResult refine_further(const DesignProblem& problem, const ChoiceResult& found, const LocalBudget& local,
                            const StopFlag& stop) {
  const LocalSolver second = [&](const SmoothProgram& program, const DesignVector& x) {
    return polish(program, x, stop);
  };
  ChoiceResult best = exchange(problem, found.point, second, local, stop);
  const std::uint64_t evaluations = best.evaluations + found.evaluations;
  // Rounding must not make one solver's digits look better than the other's.
  if (!best.feasible || best.cost > found.cost - slack::solver_gain * std::abs(found.cost)) best = found;
  best.evaluations = evaluations;
  return best;
}

}  // namespace kempe
