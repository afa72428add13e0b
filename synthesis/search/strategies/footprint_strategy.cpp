#include "synthesis/search/strategies/footprint_strategy.hpp"

#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/strategies/length_strategy.hpp"
#include "synthesis/solvers/parallel.hpp"

namespace kempe {
namespace {

/// The smallest designs of every choice, in the order of the choices; `prospects` are those of the size.
std::vector<ChoiceResult> small_designs(const SearchTask& size, const std::vector<Prospect>& prospects) {
  std::vector<ChoiceResult> small(prospects.size(), no_result());
  const LengthStrategy lengths;
  run_parallel(prospects.size(), size.control.options().threads, [&](std::size_t i) {
    if (!size.stopped()) small[i] = lengths.search(size, prospects[i], no_result());
  });
  return small;
}

void consider(const SearchTask& task, Subproblem& sub, const ChoiceResult& candidate, Incumbent& best) {
  const ChoiceResult result = certified(task, sub, candidate);
  if (result.feasible) keep_better(task.goal, design_of(task, sub, result), best.design);
}

}  // namespace

std::vector<Prospect> FootprintStrategy::relax(const SearchTask& task,
                                               const std::vector<RelaxedDesign>& known,
                                               Incumbent& best) const {
  const SearchTask size = task.with(Goal::size);
  const std::vector<Prospect> small =
      prospects_of(size, task.problem->subproblems_with_mirror_images(task.limits, Goal::size), known);
  const std::vector<ChoiceResult> found = small_designs(size, small);
  std::vector<Prospect> order;
  for (Subproblem& sub : task.subproblems()) order.push_back({std::move(sub)});  // of the same choices
  for (std::size_t i = 0; i < order.size() && !task.stopped(); ++i) {
    order[i].relaxed = found[i];
    order[i].relaxed.cost = order[i].subproblem.problem->assess(found[i].point, 1).cost;
    best.evaluations += small[i].relaxed.evaluations + found[i].evaluations;
  }
  sort_by_promise(order);
  if (order.size() > task.budgets().group)
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(task.budgets().group), order.end());
  return order;
}

ChoiceResult FootprintStrategy::search(const SearchTask& task, const Prospect& prospect,
                                       const ChoiceResult& /*best*/) const {
  if (!prospect.relaxed.feasible) return no_result();
  ChoiceOptions options = choice_options(task, task.budgets().choice.footprint);
  options.hints = {prospect.relaxed.point};
  return search_choice(*prospect.subproblem.problem, options);
}

void FootprintStrategy::certify(const SearchTask& task, Prospect& prospect, const ChoiceResult& found,
                                Incumbent& best) const {
  if (task.stopped()) return;
  best.evaluations += found.evaluations;
  consider(task, prospect.subproblem, found, best);
  consider(task, prospect.subproblem, prospect.relaxed, best);
}

void FootprintStrategy::finish(const SearchTask& /*task*/, Incumbent& /*best*/) const {}

}  // namespace kempe
