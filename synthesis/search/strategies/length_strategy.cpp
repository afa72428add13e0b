#include "synthesis/search/strategies/length_strategy.hpp"

#include "synthesis/search/steps/certify.hpp"

namespace kempe {

std::vector<Prospect> LengthStrategy::relax(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                                            Incumbent& best) const {
  std::vector<Prospect> order = kempe::relax(task, known);
  for (const Prospect& prospect : order) best.evaluations += prospect.relaxed.evaluations;
  return order;
}

ChoiceResult LengthStrategy::search(const SearchTask& task, const Prospect& prospect,
                                    const ChoiceResult& best) const {
  if (best.feasible && !better(prospect.relaxed, best)) return no_result();
  const bool has_obstacles = !task.space().obstacles().empty();
  ChoiceOptions options = choice_options(
      task, task.budgets().choice.with_contact(task.space().layout().pole_is_free, has_obstacles));
  if (prospect.relaxed.feasible) {
    options.hints = {prospect.relaxed.point};
    options.bound = prospect.relaxed.cost;
  }
  options.hints.insert(options.hints.end(), prospect.known.begin(), prospect.known.end());
  return search_choice(*prospect.subproblem.problem, options);
}

void LengthStrategy::certify(const SearchTask& task, Prospect& prospect, const ChoiceResult& found,
                             Incumbent& best) const {
  const ChoiceResult result =
      better(found, best.result) ? certified(task, prospect.subproblem, found) : found;
  best.evaluations += result.evaluations;
  if (result.feasible && better(result, best.result))
    best.result = result, best.subproblem = &prospect.subproblem;
}

void LengthStrategy::finish(const SearchTask& task, Incumbent& best) const {
  if (!best.subproblem) return;
  Subproblem& sub = *best.subproblem;
  const ChoiceResult first = best.result;
  const ChoiceResult further =
      task.stopped() ? first : refine_further(*sub.problem, first, task.budgets().local, task.stop());
  best.result = certified(task, sub, further);
  if (!best.result.feasible) best.result = first;
  best.evaluations += best.result.evaluations - first.evaluations;
  best.design = design_of(task, sub, best.result);
}

}  // namespace kempe
