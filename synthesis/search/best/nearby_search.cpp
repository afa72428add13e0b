#include "synthesis/search/best/nearby_search.hpp"

#include <cmath>

#include "geometry/chance.hpp"
#include "kinematics/parallel.hpp"
#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

/// Those of one grounding and assembly mode.
std::vector<Subproblem> subproblems_of(const SearchTask& task, Grounding grounding, int assembly_mode) {
  std::vector<Subproblem> kept;
  for (Subproblem& sub : task.subproblems())
    if (sub.choice->choice.grounding == grounding && sub.choice->choice.assembly_mode == assembly_mode)
      kept.push_back(std::move(sub));
  return kept;
}

/// A place around a point, the nearer the smaller `reach` (in shares of the lengths and of the task's size).
DesignPoint hop(const DesignPoint& from, double reach, const DesignLayout& layout, Chance& chance) {
  DesignPoint to = from;
  to.lengths.u += chance.symmetric(reach);
  to.lengths.v += chance.symmetric(reach);
  // North is drawn first: designs depend on the order.
  const double north = chance.symmetric(0.5 * reach * layout.unit);
  const double east = chance.symmetric(0.5 * reach * layout.unit);
  if (layout.pole_is_free) to.pole += Point(east, north);
  return to;
}

/// A place to start from, in one of the subproblems.
struct Hop {
  Subproblem* subproblem;
  DesignPoint start;
};

/// The hops of one round around a linkage.
std::vector<Hop> hops_around(const CopyingLinkage& best, const SearchTask& task, int round,
                             std::vector<Subproblem>& subproblems, Chance& chance) {
  const ImproveBudget& budget = task.budgets().improve;
  const DesignPoint centre{{std::log(best.VA()), std::log(best.VB())}, best.pole()};
  std::vector<Hop> hops;
  for (int i = 0; i < budget.hops_at_once; ++i) {
    const double reach = budget.first_reach * std::pow(budget.nearer, i / 2 + round);
    hops.push_back({&subproblems[static_cast<std::size_t>(i) % subproblems.size()],
                    hop(centre, reach, task.space().layout(), chance)});
  }
  return hops;
}

/// A hop's result, certified and kept if it is better by more than rounding.
void keep_hop(const SearchTask& task, Subproblem& sub, const ChoiceResult& result, SearchResult& found) {
  found.evaluations += result.evaluations;
  const double now = is_maximized(task.goal) ? -found.design->value : found.design->value;
  if (!result.feasible || result.cost > now - slack::hop_gain * std::abs(now)) return;
  if (const ChoiceResult kept = certified(task, sub, result); kept.feasible)
    keep_better(task.goal, design_of(task, sub, kept), found.design);
}

}  // namespace

SearchResult best_from(const RelaxedDesign& start, const SearchTask& asked, SearchResult found) {
  const SearchTask task = posed_for_its_limits(asked);
  const DesignPoint point{{std::log(start.VA), std::log(start.VB)}, start.pole};
  for (Subproblem& sub : subproblems_of(task, start.grounding, start.assembly_mode)) {
    if (task.stopped()) break;
    const ChoiceResult local = refine(*sub.problem, point, task.budgets().local, task.stop());
    found.evaluations += local.evaluations;
    if (const ChoiceResult kept = certified(task, sub, local); kept.feasible)
      keep_better(task.goal, design_of(task, sub, kept), found.design);
  }
  return found;
}

SearchResult basin_hopping(const SearchTask& task, SearchResult found, bool while_better) {
  const CopyingLinkage& known = found.design->linkage;
  std::vector<Subproblem> subproblems = subproblems_of(task, known.grounding(), known.assembly_mode().number);
  Chance chance(task.control.options().seed);
  const ImproveBudget& budget = task.budgets().improve;
  const int rounds = (budget.hops + budget.hops_at_once - 1) / budget.hops_at_once;
  for (int round = 0; round < rounds && !subproblems.empty() && !task.stopped(); ++round) {
    const std::vector<Hop> hops = hops_around(found.design->linkage, task, round, subproblems, chance);
    std::vector<ChoiceResult> results(hops.size());
    run_parallel(hops.size(), task.control.options().threads, [&](std::size_t i) {
      results[i] = refine(*hops[i].subproblem->problem, hops[i].start, task.budgets().local, task.stop());
    });
    const double before = found.design->value;
    for (std::size_t i = 0; i < hops.size(); ++i) keep_hop(task, *hops[i].subproblem, results[i], found);
    if (while_better && found.design->value == before) break;
  }
  return found;
}

}  // namespace kempe
