#include "synthesis/search/steps/local_search.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "synthesis/search/steps/rank.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "synthesis/solvers/newton_polish.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {

double merit_of(const DesignProblem& problem, const Assessment& seen) {
  return seen.cost / problem.goal_scale() + slack::missing_weight * seen.violation +
         (seen.feasible ? 0 : slack::infeasible_weight);
}

double merit_at(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local,
                SmallestGaps* shared) {
  return merit_of(problem, problem.assess(point, local.openings, DesignProblem::LoadLimit::counted, shared));
}

ChoiceResult no_result() {
  return {.cost = std::numeric_limits<double>::infinity(),
          .violation = std::numeric_limits<double>::infinity()};
}

bool better(const ChoiceResult& a, const ChoiceResult& b) {
  if (a.feasible != b.feasible) return a.feasible;
  if (!a.feasible) return rank(a.violation) < rank(b.violation);
  const double here = rank(a.cost), there = rank(b.cost);
  return here < there || (here == there && rank(a.size) < rank(b.size));
}

namespace {

double size_at(const DesignProblem& problem, const DesignPoint& point) {
  const Reach::LengthFactors& factors = problem.reach().factors();
  return factors.size_per_VA * std::exp(point.lengths.u) + factors.size_per_VB * std::exp(point.lengths.v);
}

}  // namespace

ChoiceResult judged(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local) {
  const Assessment seen = problem.assess(point, local.final_openings);
  return {.feasible = seen.feasible,
          .cost = seen.cost,
          .violation = seen.violation,
          .point = point,
          .evaluations = 1,
          .size = size_at(problem, point)};
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

/// Of the way between two points the part `share` from the first.
DesignPoint point_between(const DesignPoint& from, const DesignPoint& to, double share) {
  return {{std::lerp(from.lengths.u, to.lengths.u, share), std::lerp(from.lengths.v, to.lengths.v, share)},
          from.pole + share * (to.pole - from.pole)};
}

/// The last feasible point on the way from a feasible start to an infeasible solution. By halving.
ChoiceResult last_feasible(const DesignProblem& problem, const ChoiceResult& start,
                           const DesignPoint& solution, const LocalBudget& local) {
  ChoiceResult best = start;
  double kept = 0, broken = 1;
  for (int i = 0; i < local.halvings; ++i) {
    const double share = 0.5 * (kept + broken);
    const ChoiceResult here = judged(problem, point_between(start.point, solution, share), local);
    (here.feasible ? kept : broken) = share;
    if (better(here, best)) best = here;
  }
  best.evaluations = start.evaluations + static_cast<std::uint64_t>(local.halvings);
  return best;
}

/// A solution may break limits that its start keeps: one that jumps; or, among obstacles, the load error's, which bends so much that the solver
/// ends among infeasible designs.
bool may_leave_what_is_feasible(const DesignProblem& problem) {
  return problem.has_limit_that_jumps() || (problem.has_load_limit() && problem.has_obstacles());
}

/// What a solution becomes that breaks a limit: a point that keeps all of them, if its start does.
ChoiceResult kept_where_feasible(const DesignProblem& problem, const DesignPoint& start, ChoiceResult solved,
                                 const LocalBudget& local) {
  if (solved.feasible) return solved;
  ChoiceResult best = judged(problem, start, local);
  if (best.feasible) best = last_feasible(problem, best, solved.point, local);
  const std::uint64_t evaluations = best.evaluations + solved.evaluations;
  if (!better(best, solved)) best = solved;
  best.evaluations = evaluations;
  return best;
}

/// True if a solution, of which rows may be missing, is no better than the design known. More rows make a local solution worse; that they lead to
/// another, better one is rare.
bool is_no_better(const DesignProblem& problem, const SmoothProgram& program, const DesignVector& x,
                  const ChoiceResult& known) {
  const double cost = program.objective(x, nullptr) * problem.goal_scale();
  const double gain = slack::at_bound * std::abs(known.cost);
  if (cost < known.cost - gain) return false;
  return cost > known.cost + gain ||
         size_at(problem, problem.point_of(x)) > known.size * (1 - slack::at_bound);
}

/// The exchange method: solve, add the rows that the solution violates, solve again; then the last digits. Given up once a
/// solution is no better than `known` (null: nothing is).
ChoiceResult exchange(const DesignProblem& shared, const DesignPoint& start, const LocalSolver& solve,
                      const LocalBudget& local, const StopFlag& stop, const ChoiceResult* known = nullptr) {
  DesignProblem problem = shared;
  problem.set_room(start.pole);
  DesignVector x = problem.vector_of(start);
  std::vector<Row> rows = problem.rows_at(x);
  std::uint64_t evaluations = 0;
  for (int i = 0; i < local.exchanges && !stop(); ++i) {
    const SmoothProgram program = problem.program(rows);
    const LocalResult solved = solve(program, x);
    evaluations += static_cast<std::uint64_t>(solved.evaluations);
    if (!solved.usable) break;
    x = solved.x;
    if (known != nullptr && known->feasible && is_no_better(problem, program, x, *known)) {
      ChoiceResult at_start = judged(problem, start, local);
      at_start.evaluations += evaluations;
      return at_start;
    }
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
  return may_leave_what_is_feasible(problem) ? kept_where_feasible(problem, start, best, local) : best;
}

}  // namespace

ChoiceResult refine(const DesignProblem& problem, const DesignPoint& start, const LocalBudget& local,
                    const StopFlag& stop, const ChoiceResult* known) {
  const LocalSolver sqp = [&](const SmoothProgram& program, const DesignVector& x) {
    return minimize_by_sqp(program, x, local.evaluations, stop);
  };
  return exchange(problem, start, sqp, local, stop, known);
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
