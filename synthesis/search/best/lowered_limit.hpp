#pragma once
// Where a search keeps a limit in one figure and another one counts: the search's limit lowered until that one keeps it.
//
// For a limit l of the search, its best design has a figure up to q(l) l, and q falls with l. So l is moved by a part of the way, in its
// logarithm, that a constant q would ask for, between the largest l known to keep the limit asked for and the smallest known not to.

#include <cmath>
#include <optional>

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The best design found whose figure is at most `limit`; nothing if none was. `breaks`: a limit of the search whose best design has the figure
/// `told`, above `limit`. `found_with(lower)`: the best design with a lower one, if any; `figure_of(design)`: the figure that counts.
template <typename FoundWith, typename FigureOf>
std::optional<FoundDesign> best_of_lowered(const SearchTask& task, double limit, double breaks, double told,
                                           const FoundWith& found_with, const FigureOf& figure_of) {
  const LoweredLimitBudget& budget = task.budgets().lowered;
  std::optional<FoundDesign> best;
  double keeps = 0, last = breaks;
  for (int round = 0; round < budget.rounds && breaks - keeps > budget.near * limit && !task.stopped();
       ++round) {
    const double towards = last * std::pow((1 - 0.5 * budget.near) * limit / told, budget.step);
    const double lower = towards > keeps && towards < breaks ? towards : 0.5 * (keeps + breaks);
    const std::optional<FoundDesign> design = found_with(lower);
    const double figure = design ? figure_of(*design) : 0;
    const bool is_broken = figure > limit;
    (is_broken ? breaks : keeps) = lower;
    if (!design) continue;  // too low a limit
    last = lower;
    told = figure;
    if (is_broken) continue;
    keep_better(task.goal, *design, best);
    if (told >= (1 - budget.near) * limit) break;
  }
  return best;
}

}  // namespace kempe
