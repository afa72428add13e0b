#include "synthesis/search/choice_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/search/tolerances.hpp"
#include "synthesis/solvers/newton_polish.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {
namespace {

double merit_of(const DesignProblem& problem, const Assessment& seen) {
  return seen.cost / problem.goal_scale() + tolerance::missing_weight * seen.violation +
         (seen.feasible ? 0 : tolerance::infeasible_weight);
}

/// A place to start from: in the unit square of lengths, seen from a pole.
struct Start {
  std::array<double, 2> z;
  Point pole;
  double merit;
};

/// The lattice points of the unit square of lengths, seen from one pole, that are no worse than their
/// neighbours.
void add_lattice_minima(const DesignProblem& problem, const Point& pole, int lattice,
                        const ChoiceOptions& options, std::vector<Start>& starts) {
  std::vector<Start> seen;
  const double last = std::max(1, lattice - 1);
  for (int i = 0; i < lattice; ++i)
    for (int j = 0; j < lattice; ++j) {
      if (options.stop()) return;
      const DesignPoint point{problem.unit_lengths(pole, i / last, j / last), pole};
      seen.push_back({{i / last, j / last}, pole, merit_at(problem, point, options.local)});
    }
  const auto at = [&](int i, int j) -> const Start& {
    const auto within = [&](int index) {
      return static_cast<std::size_t>(std::clamp(index, 0, lattice - 1));
    };
    return seen[within(i) * static_cast<std::size_t>(lattice) + within(j)];
  };
  for (int i = 0; i < lattice; ++i)
    for (int j = 0; j < lattice; ++j) {
      bool least = true;
      for (int a = -1; a <= 1; ++a)
        for (int b = -1; b <= 1; ++b) least = least && at(i, j).merit <= at(i + a, j + b).merit;
      if (least) starts.push_back(at(i, j));
    }
}

/// Local solutions move the pole further than from one end of the square to the other, where the lengths are
/// those of another local optimum.
bool are_close(const DesignProblem& problem, const LocalBudget& local, const Start& a, const Start& b) {
  const double poles_apart = problem.lengths_are_locked() ? local.locked_poles_apart : local.poles_apart;
  return std::abs(a.z[0] - b.z[0]) < local.lengths_apart && std::abs(a.z[1] - b.z[1]) < local.lengths_apart &&
         (a.pole - b.pole).norm() < poles_apart * problem.layout().unit;
}

/// The best that are not close to each other.
std::vector<Start> best_starts(const DesignProblem& problem, const ChoiceOptions& options,
                               std::vector<Start> starts) {
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.merit < b.merit; });
  std::vector<Start> picked;
  for (const Start& start : starts) {
    if (static_cast<int>(picked.size()) == options.budget.starts_if_none) break;
    const auto close = [&](const Start& other) { return are_close(problem, options.local, start, other); };
    if (std::none_of(picked.begin(), picked.end(), close)) picked.push_back(start);
  }
  return picked;
}

ChoiceResult judged(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local) {
  const Assessment seen = problem.assess(point, local.final_openings);
  return {.feasible = seen.feasible,
          .cost = seen.cost,
          .violation = seen.violation,
          .point = point,
          .evaluations = 1};
}

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

}  // namespace

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

namespace {

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
    if (!problem.add_violated(rows, x, tolerance::violated_row)) break;
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
  if (!best.feasible || best.cost > found.cost - tolerance::solver_gain * std::abs(found.cost)) best = found;
  best.evaluations = evaluations;
  return best;
}

std::vector<Point> promising_poles(const DesignProblem& problem, const PoleBudget& budget,
                                   const LocalBudget& local, const StopFlag& stop) {
  if (!problem.layout().pole_is_free || !problem.possible()) return {};
  const auto merit = [&](std::span<const double> z) {
    const Point pole = problem.unit_pole(z[0], z[1]);
    double best = std::numeric_limits<double>::infinity();
    for (const double of_lambda : budget.lambda_shares)
      for (const double of_m : budget.m_shares) {
        const DesignPoint point{problem.unit_lengths(pole, of_lambda, of_m), pole};
        best = std::min(best, merit_of(problem, problem.assess(point, 1)));
      }
    return best;
  };
  std::vector<Explored> seen = explore({2, budget.evaluations, 1, merit, stop});
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Explored& a, const Explored& b) { return a.merit < b.merit; });
  std::vector<Point> poles;
  for (const Explored& place : seen) {
    const Point pole = problem.unit_pole(place.z[0], place.z[1]);
    const auto close = [&](const Point& other) {
      return (pole - other).norm() < local.locked_poles_apart * problem.layout().unit;
    };
    if (std::none_of(poles.begin(), poles.end(), close)) poles.push_back(pole);
    if (static_cast<int>(poles.size()) == budget.promising) break;
  }
  return poles;
}

namespace {

/// The best places of the lattices and of the global search, more than enough of them.
std::vector<Start> starts_of(const DesignProblem& problem, const ChoiceOptions& options,
                             std::uint64_t& evaluations) {
  std::vector<Start> starts;
  const bool locked = problem.lengths_are_locked();
  const int lattice = locked ? 1 : options.budget.lattice;
  const std::vector<Point> poles = problem.start_poles(options.budget.poles);
  for (const Point& pole : poles) add_lattice_minima(problem, pole, lattice, options, starts);
  evaluations += poles.size() * static_cast<std::size_t>(lattice * lattice);
  const auto merit = [&](std::span<const double> z) {
    return merit_at(problem, problem.unit_point(z), options.local);
  };
  const std::vector<Explored> seen =
      explore({problem.cube_dimensions(), options.budget.evaluations, options.seed, merit, options.stop});
  evaluations += seen.size();
  for (const Explored& place : seen)
    starts.push_back({locked ? std::array{0.0, 0.0} : std::array{place.z[0], place.z[1]},
                      problem.unit_point(place.z).pole, place.merit});
  return best_starts(problem, options, std::move(starts));
}

/// Nothing better can be hoped for.
bool is_done(const ChoiceResult& best, const ChoiceOptions& options) {
  return best.feasible && best.cost <= options.bound + tolerance::at_bound * std::abs(options.bound);
}

}  // namespace

ChoiceResult search_choice(const DesignProblem& problem, const ChoiceOptions& options) {
  ChoiceResult best = no_result();
  if (!problem.possible()) return best;
  if (problem.cube_dimensions() == 0)  // nothing is free
    return judged(problem, problem.unit_point({}), options.local);
  std::uint64_t evaluations = 0;
  const auto try_from = [&](const DesignPoint& point) {
    const ChoiceResult found = refine(problem, point, options.local, options.stop);
    evaluations += found.evaluations;
    if (better(found, best)) best = found;
  };
  for (const DesignPoint& hint : options.hints) {
    if (options.stop()) break;
    try_from(hint);
  }
  if (!is_done(best, options) && !options.stop()) {
    int tried = 0;
    for (const Start& start : starts_of(problem, options, evaluations)) {
      if (options.stop() || (best.feasible && (tried >= options.budget.starts || is_done(best, options))))
        break;
      try_from({problem.unit_lengths(start.pole, start.z[0], start.z[1]), start.pole});
      ++tried;
    }
  }
  best.evaluations = evaluations;
  return best;
}

}  // namespace kempe
