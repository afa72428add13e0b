#pragma once
// The best design of one discrete choice: a global look at the unit cube, local solutions from its best
// places, and the last digits.

#include <cstdint>

#include "synthesis/problem/design_problem.hpp"
#include "synthesis/search/budgets.hpp"

namespace kempe {

struct ChoiceOptions {
  ChoiceBudget budget{};
  LocalBudget local{};
  std::uint64_t seed = 1;
  std::vector<DesignPoint> hints{};  ///< further starts, tried first
  double bound = -1e300;  ///< no cost below this is possible: a result that reaches it ends the search
  StopFlag stop{};
};

struct ChoiceResult {
  bool feasible = false;
  double cost = 0;       ///< of the goal, with a minus if it is to be large; meaningless unless feasible
  double violation = 0;  ///< what is missing at the nearest miss
  DesignPoint point{};
  std::uint64_t evaluations = 0;
};

/// Not run: infeasible, at infinite cost.
ChoiceResult no_result();

/// True if a is better than b: by feasibility, then cost (or violation).
bool better(const ChoiceResult& a, const ChoiceResult& b);

/// What a design promises, the less the better: the goal in shares of its scale, and ten times what is missing from the
/// limits, at `local.openings` openings.
double merit_at(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local);

ChoiceResult search_choice(const DesignProblem& problem, const ChoiceOptions& options);

/// The best poles by a global search over the pole alone, a few pairs of lengths tried at each; none if the
/// pole is fixed. Meant for problems without contact.
std::vector<Point> promising_poles(const DesignProblem& problem, const PoleBudget& budget,
                                   const LocalBudget& local, const StopFlag& stop);

/// A local solution from a start, the last digits included, judged anew.
ChoiceResult refine(const DesignProblem& problem, const DesignPoint& start, const LocalBudget& local,
                    const StopFlag& stop);

/// The same from a solution already found, by the second solver; the better of both.
ChoiceResult refine_further(const DesignProblem& problem, const ChoiceResult& found, const LocalBudget& local,
                            const StopFlag& stop);

}  // namespace kempe
