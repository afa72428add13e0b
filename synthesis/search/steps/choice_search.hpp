#pragma once
// The best design of one discrete choice: a global look at the unit cube, and local solutions from its best places.

#include "synthesis/search/steps/local_search.hpp"

namespace kempe {

struct ChoiceOptions {
  ChoiceBudget budget{};
  LocalBudget local{};
  int fruitless_under_load = LoadBudget{}.fruitless;  ///< LoadBudget::fruitless
  std::uint64_t seed = 1;
  std::vector<DesignPoint> hints{};  ///< further starts, tried first
  /// No cost below this is possible: a result that reaches it ends the search.
  std::optional<double> bound{};
  StopFlag stop{};
};

ChoiceResult search_choice(const DesignProblem& problem, const ChoiceOptions& options);

}  // namespace kempe
