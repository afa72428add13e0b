#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

SearchTask pose(const Spec& spec, SearchControl control) {
  return {std::make_shared<const SearchProblem>(spec), std::move(control), requirements_of(spec),
          goal_of(spec.objective.objective)};
}

SearchTask posed_for_its_limits(const SearchTask& task) {
  if (task.problem->covers(task.limits)) return task;
  return {std::make_shared<const SearchProblem>(task.spec(), task.limits), task.control.part(), task.limits,
          task.goal};
}

std::optional<SearchTask> without_load_limit(const SearchTask& task) {
  if (!task.limits.load_error || task.goal == Goal::load_error) return std::nullopt;
  Requirements limits = task.limits;
  limits.load_error.reset();
  return task.with(limits, task.goal);
}

bool has_stock_lengths(const Spec& spec) {
  return spec.links.stock_lengths.grid || !spec.links.stock_lengths.stock.empty();
}

ChoiceOptions choice_options(const SearchTask& task, const ChoiceBudget& budget) {
  return {.budget = budget,
          .local = task.budgets().local,
          .fruitless_under_load = task.budgets().choice.under_load.fruitless,
          .seed = task.control.options().seed,
          .stop = task.stop()};
}

}  // namespace kempe
