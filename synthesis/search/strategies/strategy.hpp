#pragma once
// One way to look for the best design over all choices. The driver (best_design.cpp) calls the steps in the order in which they
// stand here.

#include "synthesis/search/steps/relax.hpp"
#include "synthesis/search/steps/search_result.hpp"

namespace kempe {

/// The best found so far.
struct Incumbent {
  ChoiceResult result = no_result();  ///< certified; what later groups are pruned by
  Subproblem* subproblem = nullptr;   ///< of the result
  std::optional<FoundDesign> design{};
  std::uint64_t evaluations = 0;
};

/// The steps, none of which may be absent.
struct Strategy {
  /// The choices worth searching, the most promising first; their evaluations are added to `best`.
  std::vector<Prospect> (*relax)(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                                 Incumbent& best);
  /// The best of one choice; not run where it cannot beat `best`. Called in parallel: writes nothing.
  ChoiceResult (*search)(const SearchTask& task, const Prospect& prospect, const ChoiceResult& best);
  /// Certifies what was found, and keeps it if it is the best.
  void (*certify)(const SearchTask& task, Prospect& prospect, const ChoiceResult& found, Incumbent& best);
  /// The last digits, and the finished design.
  void (*finish)(const SearchTask& task, Incumbent& best);
};

/// For every goal that a formula gives (length_strategy.cpp).
extern const Strategy length_strategy;
/// For the least footprint (footprint_strategy.cpp).
extern const Strategy footprint_strategy;

inline const Strategy& strategy_for(Goal goal) {
  return goal == Goal::footprint ? footprint_strategy : length_strategy;
}

}  // namespace kempe
