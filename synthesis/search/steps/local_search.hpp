#pragma once
// One local solution of one choice: the exchange method, the last digits, and the figures of the point judged anew.

#include <cstdint>
#include <optional>

#include "synthesis/problem/design_problem.hpp"
#include "synthesis/search/steps/budgets.hpp"

namespace kempe {

/// A point that a search came to: a candidate, until it is certified (certify.hpp).
struct ChoiceResult {
  bool feasible = false;
  double cost = 0;       ///< of the goal, with a minus if it is to be large; meaningless unless feasible
  double violation = 0;  ///< what is missing at the nearest miss
  DesignPoint point{};
  std::uint64_t evaluations = 0;
  /// mm; of what is certified among obstacles: the smallest gap to them.
  std::optional<double> obstacle_clearance{};
  double size = 0;  ///< mm, of the linkage: of two at one cost the smaller is better
};

/// Not run: infeasible, at infinite cost.
ChoiceResult no_result();

/// True if a is better than b: by feasibility, then cost (or violation), then size; by more than rounding.
bool better(const ChoiceResult& a, const ChoiceResult& b);

/// What an assessment promises, the less the better: the goal in shares of its scale, and what is missing from the limits
/// (slack::missing_weight).
double merit_of(const DesignProblem& problem, const Assessment& seen);
/// The same of a point, seen at `local.openings` openings.
double merit_at(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local,
                SmallestGaps* shared = nullptr);

/// A point's figures, seen at `local.final_openings` openings.
ChoiceResult judged(const DesignProblem& problem, const DesignPoint& point, const LocalBudget& local);

/// A local solution from a start, the last digits included, judged anew. With `known`, of this or another choice, it is given up where a
/// solution that keeps only some of the limits is no better than that: what comes back then keeps them only if the start does.
ChoiceResult refine(const DesignProblem& problem, const DesignPoint& start, const LocalBudget& local,
                    const StopFlag& stop, const ChoiceResult* known = nullptr);

/// The same from a solution already found, by the second solver; the better of both.
ChoiceResult refine_further(const DesignProblem& problem, const ChoiceResult& found, const LocalBudget& local,
                            const StopFlag& stop);

}  // namespace kempe
