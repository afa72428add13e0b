#include "synthesis/search/steps/promising_poles.hpp"

#include <algorithm>
#include <limits>

#include "synthesis/solvers/nlopt_backend.hpp"

namespace kempe {
namespace {

/// A point's merit, seen at one opening; or, without a look at its load error, a figure that is no less than `best` because the merit is not.
double merit_below(const DesignProblem& problem, const DesignPoint& point, double best) {
  if (!problem.has_load_limit()) return merit_of(problem, problem.assess(point, 1));
  const Assessment seen = problem.assess(point, 1, DesignProblem::LoadLimit::left_out);
  const double at_least = merit_of(problem, seen);
  return at_least >= best ? at_least : merit_of(problem, problem.count_load_error(seen, point));
}

}  // namespace

std::vector<Point> promising_poles(const DesignProblem& problem, const PoleBudget& budget,
                                   const LocalBudget& local, const StopFlag& stop) {
  if (!problem.layout().pole_is_free || !problem.possible()) return {};
  const auto merit = [&](std::span<const double> z) {
    const Point pole = problem.unit_pole(z[0], z[1]);
    double best = std::numeric_limits<double>::infinity();
    for (const double of_lambda : budget.lambda_shares)
      for (const double of_m : budget.m_shares) {
        const DesignPoint point{problem.unit_lengths(pole, of_lambda, of_m), pole};
        best = std::min(best, merit_below(problem, point, best));
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

}  // namespace kempe
