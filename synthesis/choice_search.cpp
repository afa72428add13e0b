#include "synthesis/choice_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/newton_polish.hpp"
#include "synthesis/nlopt_backend.hpp"

namespace kempe {
namespace {

constexpr int global_openings = 9;
constexpr int final_openings = 129;
constexpr int most_exchanges = 10;
constexpr int most_local_evaluations = 120;
/// Rows may be missed by this much before they count as violated (shares of the task's size).
constexpr double row_tolerance = 1e-11;
/// Weight of what is missing against the goal, both in shares of the task's size.
constexpr double penalty = 10;
/// Starts are at least so far apart in the unit cube.
constexpr double apart = 0.08;

double merit_of(const DesignProblem& problem, const Assessment& seen) {
  const double unit = problem.layout().unit;
  const double scale = problem.goal() == Goal::transmission ? 1
                       : problem.goal() == Goal::footprint  ? unit * unit
                                                            : unit;
  return seen.cost / scale + penalty * seen.violation + (seen.feasible ? 0 : 1e-3);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The best places that are not close to each other.
std::vector<Explored> pick_starts(std::vector<Explored> seen, int count) {
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Explored& a, const Explored& b) { return a.merit < b.merit; });
  std::vector<Explored> picked;
  for (const Explored& place : seen) {
    if (static_cast<int>(picked.size()) == count) break;
    const auto close = [&](const Explored& other) { return distance(place.z, other.z) < apart; };
    if (std::none_of(picked.begin(), picked.end(), close)) picked.push_back(place);
  }
  return picked;
}

ChoiceResult judged(const DesignProblem& problem, const DesignPoint& point) {
  const Assessment seen = problem.assess(point, final_openings);
  return {.feasible = seen.feasible,
          .cost = seen.cost,
          .violation = seen.violation,
          .point = point,
          .evaluations = 1};
}

/// Rounded so that the last digits of a solver do not matter, and short in print.
double rounded(double value, double quantum) { return std::round(value / quantum) * quantum; }

DesignPoint rounded(const DesignProblem& problem, const DesignPoint& point) {
  const double quantum = std::pow(10.0, std::floor(std::log10(problem.layout().unit)) - 11);
  DesignPoint result{{std::log(rounded(std::exp(point.lengths.u), quantum)),
                      std::log(rounded(std::exp(point.lengths.v), quantum))},
                     point.pole};
  if (problem.layout().pole_is_free)
    result.pole = {rounded(point.pole.x(), quantum), rounded(point.pole.y(), quantum)};
  return result;
}

}  // namespace

ChoiceResult no_result() {
  return {.cost = std::numeric_limits<double>::infinity(),
          .violation = std::numeric_limits<double>::infinity()};
}

bool better(const ChoiceResult& a, const ChoiceResult& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.cost < b.cost : a.violation < b.violation;
}

ChoiceResult refine(const DesignProblem& shared, const DesignPoint& start, const StopFlag& stop) {
  DesignProblem problem = shared;
  problem.set_room(start.pole);
  DesignVector x = problem.vector_of(start);
  std::vector<Row> rows = problem.rows_at(x);
  std::uint64_t evaluations = 0;
  for (int i = 0; i < most_exchanges && !stop(); ++i) {
    const LocalResult local = minimize_by_sqp(problem.program(rows), x, most_local_evaluations, stop);
    evaluations += static_cast<std::uint64_t>(local.evaluations);
    if (!local.usable) break;
    x = local.x;
    if (!problem.add_violated(rows, x, row_tolerance)) break;
  }
  const DesignVector polished = newton_polish(problem.program(rows), x);
  ChoiceResult best = judged(problem, problem.point_of(x));
  for (const DesignPoint& point :
       {problem.point_of(polished), rounded(problem, problem.point_of(polished))}) {
    const ChoiceResult here = judged(problem, point);
    if (here.feasible || better(here, best)) best = here;
  }
  best.evaluations += evaluations;
  return best;
}

ChoiceResult search_choice(const DesignProblem& problem, const ChoiceOptions& options) {
  if (!problem.possible()) return no_result();
  const auto merit = [&](std::span<const double> z) {
    return merit_of(problem, problem.assess(problem.unit_point(z), global_openings));
  };
  const std::vector<Explored> seen =
      explore({problem.cube_dimensions(), options.evaluations, options.seed, merit, options.stop});
  std::vector<DesignPoint> starts = options.hints;
  for (const Explored& place : pick_starts(seen, options.starts))
    starts.push_back(problem.unit_point(place.z));
  ChoiceResult best = no_result();
  std::uint64_t evaluations = seen.size();
  for (const DesignPoint& start : starts) {
    const ChoiceResult found = refine(problem, start, options.stop);
    evaluations += found.evaluations;
    if (better(found, best)) best = found;
  }
  best.evaluations = evaluations;
  return best;
}

}  // namespace kempe
