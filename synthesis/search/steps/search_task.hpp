#pragma once
// What a search is asked, and how it is to work: the one argument that all steps and strategies share.

#include <optional>

#include "synthesis/search/steps/choice_search.hpp"
#include "synthesis/search/steps/search_control.hpp"
#include "synthesis/search/steps/search_problem.hpp"

namespace kempe {

/// The best design for `goal` that keeps `limits`: a value, cheap to copy and to change.
struct SearchTask {
  std::shared_ptr<const SearchProblem> problem;
  SearchControl control;
  Requirements limits;  ///< those of the spec, or with one of them moved
  Goal goal;

  const Spec& spec() const { return problem->spec(); }
  const SearchSpace& space() const { return problem->space(); }
  const SearchBudgets& budgets() const { return control.budgets(); }
  const StopFlag& stop() const { return control.stop(); }
  bool stopped() const { return control.stop()(); }
  std::vector<Subproblem> subproblems() const { return problem->subproblems(limits, goal); }

  SearchTask with(Goal other) const { return {problem, control, limits, other}; }
  SearchTask with(const Requirements& other, Goal other_goal) const {
    return {problem, control, other, other_goal};
  }
  SearchTask with(SearchControl other) const { return {problem, std::move(other), limits, goal}; }
};

/// The spec's own limits and objective. The spec, and what the control's options refer to, must outlive the task.
SearchTask pose(const Spec& spec, SearchControl control);

/// The same task; where its limits reach farther than its problem was posed for, with a problem posed for them.
SearchTask posed_for_its_limits(const SearchTask& task);

/// The same task without its limit on the load error; nothing if it has none, or if that error is its goal.
std::optional<SearchTask> without_load_limit(const SearchTask& task);

/// True if lengths come from a grid or a stock.
bool has_stock_lengths(const Spec& spec);

/// What a search of one of its choices may spend.
ChoiceOptions choice_options(const SearchTask& task, const ChoiceBudget& budget);

}  // namespace kempe
