// The strategy for every goal that a formula gives: lengths and pole by each choice's own search, pruned by what the choice can
// be at best without contact.

#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/strategies/strategy.hpp"

namespace kempe {
namespace {

std::vector<Prospect> relax_lengths(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                                    Incumbent& best) {
  std::vector<Prospect> order = relax_without_load(task, known);
  for (const Prospect& prospect : order) best.evaluations += prospect.relaxed.evaluations;
  return order;
}

ChoiceResult search_lengths(const SearchTask& task, const Prospect& prospect, const ChoiceResult& best) {
  if (!may_beat(prospect, best)) return no_result();
  const bool has_obstacles = !task.space().obstacles().empty();
  const bool pole_is_free = task.space().layout().pole_is_free;
  const ChoiceBudgets& budgets = task.budgets().choice;
  ChoiceOptions options =
      choice_options(task, task.limits.load_error && best.feasible
                               ? budgets.beside_a_stiff_design(pole_is_free, has_obstacles)
                               : budgets.with_contact(pole_is_free, has_obstacles));
  if (prospect.relaxed.feasible) {
    options.hints = {prospect.relaxed.point};
    options.bound = prospect.relaxed.cost;
  }
  options.hints.insert(options.hints.end(), prospect.known.begin(), prospect.known.end());
  return search_choice(*prospect.subproblem.problem, options);
}

void certify_lengths(const SearchTask& task, Prospect& prospect, const ChoiceResult& found, Incumbent& best) {
  const ChoiceResult result =
      better(found, best.result) ? certified(task, prospect.subproblem, found) : found;
  best.evaluations += result.evaluations;
  if (result.feasible && better(result, best.result))
    best.result = result, best.subproblem = &prospect.subproblem;
}

void finish_lengths(const SearchTask& task, Incumbent& best) {
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

}  // namespace

constinit const Strategy length_strategy{relax_lengths, search_lengths, certify_lengths, finish_lengths};

}  // namespace kempe
