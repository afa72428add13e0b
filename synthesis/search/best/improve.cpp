#include "synthesis/search/best/improve.hpp"

#include <cmath>

#include "geometry/invariant.hpp"
#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/nearby_search.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

/// The bound is one of designs with the exact ratio.
bool has_exact_ratio(const FoundDesign& design, const Spec& spec) {
  return std::abs(design.linkage.k() - spec.copy.k()) <= slack::same_ratio * std::abs(spec.copy.k());
}

/// A stopped search's design with the better of the bounds that it came to.
SearchResult told_with(std::optional<double> bound, const std::optional<ProvenBound>& last, Goal goal,
                       SearchResult found) {
  if (last && !last->no_design) bound = tighter_bound(goal, bound, last->value);
  found.design->proven_bound = bound;
  return found;
}

/// True if a limit that the bound does not know of, or only in part, is met exactly: that, and no better design, may be what lies between
/// design and bound.
bool is_held_back(const SearchTask& task, const FoundDesign& design) {
  const auto is_met = [](const std::optional<double>& limit, double attained, double near) {
    return limit && attained > *limit * (1 - near);
  };
  const double near = task.limits.load_error_in_all ? 2 * task.budgets().lowered.near : slack::met_exactly;
  return is_met(task.limits.load_error, design.attained.load_error, near) ||
         is_met(task.limits.sag, design.attained.sag, slack::met_exactly);
}

/// What no design with the limit on the load error beats: a yardstick for the search, which is not told (proven_bound.hpp). No closer to
/// the design than the search asks for.
std::optional<ProvenBound> bound_under_load(const SearchTask& task, const FoundDesign& design) {
  if (!task.limits.load_error) return std::nullopt;
  const double near = task.budgets().improve.near;
  auto bound =
      proven_bound(task.space().spec(), {.incumbent = design.value,
                                         .tolerance = near / (1 + near),  // a share of the design's value
                                         .boxes = task.budgets().improve.boxes_under_load,
                                         .load_limit = true,
                                         .stop = task.stop()});
  if (bound && bound->no_design) bound.reset();
  return bound;
}

/// Searched from the bound's starts, then around the design, then all over from other random numbers.
SearchResult nearer_to(const ProvenBound& bound, const SearchTask& task, SearchResult found) {
  const auto is_near_to = [&](const ProvenBound& one) {
    return std::abs(found.design->value - one.value) <= task.budgets().improve.near * std::abs(one.value);
  };
  const auto under_load = is_near_to(bound) ? std::nullopt : bound_under_load(task, *found.design);
  const ProvenBound& yardstick = under_load ? *under_load : bound;
  for (const RelaxedDesign& start : starts_of(yardstick)) found = best_from(start, task, std::move(found));
  const bool held_back = is_held_back(task, *found.design);
  if (!is_near_to(yardstick)) found = basin_hopping(task, std::move(found), held_back);
  if (is_held_back(task, *found.design)) return found;
  return searched_again(task, std::move(found), [&](const SearchResult& one) {
    return std::abs(one.design->value - yardstick.value) <=
           task.budgets().improve.near * std::abs(yardstick.value);
  });
}

/// With stock lengths and a fixed pole each pair of lengths is one design, and the pairs are those about the best with any lengths: other
/// random numbers lead to no others.
bool leads_to_the_same(const SearchTask& task, const SearchResult& found) {
  return found.none_in_stock && !task.space().pole_is_free(task.limits) && task.goal != Goal::pole_margin;
}

}  // namespace

SearchResult searched_again(const SearchTask& task, SearchResult found,
                            const std::function<bool(const SearchResult&)>& is_enough) {
  const std::uint64_t seed = task.control.options().seed;
  const ImproveBudget& budget = task.budgets().improve;
  if (leads_to_the_same(task, found)) return found;
  const auto may_go_on = [&] { return !task.stopped() && found.evaluations < budget.evaluations; };
  for (int i = 1; i <= budget.searches && may_go_on() && !is_enough(found); ++i) {
    const SearchResult again =
        best_by_choices(task.with(task.control.part_with_seed(seed + static_cast<std::uint64_t>(i))));
    found.evaluations += again.evaluations;
    if (!again.design || (found.design && !is_better(task.goal, *again.design, *found.design))) continue;
    found.design = again.design;
    found.design->seed = seed;
  }
  found.stopped = task.stopped();
  return found;
}

SearchResult improved(const SearchTask& task, SearchResult found) {
  if (found.exhausted && (found.bound || !task.limits.load_error)) {
    found.design->proven_bound = found.bound;
    return found;
  }
  if (!has_exact_ratio(*found.design, task.spec())) return found;
  const auto bound =
      proven_bound(task.space().spec(), {.incumbent = found.design->value,
                                         .tolerance = slack::tree_bound,
                                         .share_of_gap = task.limits.load_error ? slack::gap_of_a_limit : 0,
                                         .stop = task.stop(),
                                         .progress = task.control.progress_of("proving a bound")});
  if (task.stopped()) {
    const std::optional<double> known = found.bound;
    return told_with(known, bound, task.goal, std::move(found));
  }
  if (!bound) return found;
  invariant(!bound->no_design, "no bound says that there is no design after one was found");
  if (!has_stock_lengths(task.spec()) && !found.exhausted && !task.stopped())
    found = nearer_to(*bound, task, std::move(found));
  found.design->proven_bound = bound->value;
  return found;
}

}  // namespace kempe
