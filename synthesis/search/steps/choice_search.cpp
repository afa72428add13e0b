#include "synthesis/search/steps/choice_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/search/steps/slack.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"

namespace kempe {
namespace {

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
  return best.feasible && options.bound &&
         best.cost <= *options.bound + slack::at_bound * std::abs(*options.bound);
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
  int hints_tried = 0;
  for (const DesignPoint& hint : options.hints) {
    if (options.stop() || (!best.feasible && hints_tried == options.budget.known_starts_if_none)) break;
    try_from(hint);
    ++hints_tried;
  }
  if (!is_done(best, options) && !options.stop()) {
    int tried = 0, fruitless = 0;
    const int most_fruitless = problem.has_load_limit() && !problem.has_obstacles()
                                   ? options.fruitless_under_load
                                   : options.budget.starts;
    for (const Start& start : starts_of(problem, options, evaluations)) {
      if (options.stop() || (best.feasible && (tried >= options.budget.starts ||
                                               fruitless >= most_fruitless || is_done(best, options))))
        break;
      const ChoiceResult before = best;
      try_from({problem.unit_lengths(start.pole, start.z[0], start.z[1]), start.pole});
      ++tried;
      if (before.feasible && !better(best, before)) ++fruitless;
    }
  }
  best.evaluations = evaluations;
  return best;
}

}  // namespace kempe
