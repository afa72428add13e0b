#pragma once
// The best design of one discrete choice: a global look at the unit cube, local solutions from its best
// places, and the last digits.

#include <cstdint>

#include "synthesis/design_problem.hpp"

namespace kempe {

struct ChoiceOptions {
  int evaluations = 300;  ///< of the global part
  int starts = 4;         ///< local solutions
  std::uint64_t seed = 1;
  std::vector<DesignPoint> hints{};  ///< further starts, tried first
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

ChoiceResult search_choice(const DesignProblem& problem, const ChoiceOptions& options);

/// A local solution from a start, the last digits included, judged anew.
ChoiceResult refine(const DesignProblem& problem, const DesignPoint& start, const StopFlag& stop);

}  // namespace kempe
