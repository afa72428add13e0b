#include "synthesis/search/search.hpp"

#include "geometry/invariant.hpp"
#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/problem/local_frame.hpp"
#include "synthesis/search/diagnosis.hpp"
#include "synthesis/search/search_run.hpp"
#include "synthesis/search/tolerances.hpp"

namespace kempe {
namespace {

bool has_workshop_lengths(const Spec& spec) {
  return spec.links.workshop.grid || !spec.links.workshop.stock.empty();
}

/// The best of a search and of others from further random numbers, told as the first one's.
template <typename Enough>
SearchResult searched_again(const SearchRun& run, SearchResult found, Goal goal, const Enough& is_enough) {
  for (int i = 1; i <= run.options().budgets.improve.searches && !run.stop()() && !is_enough(found); ++i) {
    SearchOptions options = run.options_of_part();
    options.seed += static_cast<std::uint64_t>(i);
    const SearchResult again = SearchRun(run.spec(), options).best(requirements_of(run.spec()), goal);
    found.evaluations += again.evaluations;
    if (!again.design || (found.design && !is_better(goal, *again.design, *found.design))) continue;
    found.design = again.design;
    found.design->seed = run.options().seed;
  }
  found.stopped = run.stop()();
  return found;
}

/// A stopped search's design with the better of the bounds that it came to.
SearchResult told_with(std::optional<double> bound, const std::optional<ProvenBound>& last, Goal goal,
                       SearchResult result) {
  if (last && !last->no_design) bound = tighter_bound(goal, bound, last->value);
  result.design->proven_bound = bound;
  return result;
}

/// The proven bound, and the design improved where the bound's tree met a better one or the bound is far away.
SearchResult with_bound(const SearchRun& run, SearchResult result, Goal goal) {
  const Spec& spec = run.spec();
  if (std::abs(result.design->linkage.k() - spec.copy.k) > tolerance::same_ratio * std::abs(spec.copy.k))
    return result;  // the bound is one of designs with the exact ratio
  const auto bound =
      proven_bound(run.space().spec(), {.incumbent = result.design->value, .stop = run.stop()});
  if (run.stop()()) {
    const std::optional<double> known = result.bound;
    return told_with(known, bound, goal, std::move(result));
  }
  if (!bound) return result;
  invariant(!bound->no_design, "no bound says that there is no design after one was found");
  const auto is_near = [&](const SearchResult& found) {
    return std::abs(found.design->value - bound->value) <=
           run.options().budgets.improve.near * std::abs(bound->value);
  };
  if (!has_workshop_lengths(spec) && !run.stop()()) {
    for (const RelaxedDesign& start : starts_of(*bound))
      result = run.best_from(start, requirements_of(spec), goal, std::move(result));
    if (!is_near(result)) result = run.basin_hopping(requirements_of(spec), goal, std::move(result));
    result = searched_again(run, std::move(result), goal, is_near);
  }
  result.design->proven_bound = bound->value;
  return result;
}

SearchOutcome synthesize_here(const Spec& spec, const SearchOptions& options) {
  const SearchRun run(spec, options);
  const Goal goal = goal_of(spec.objective.objective);
  SearchResult result = run.best(requirements_of(spec), goal);
  const std::optional<double> bound = has_workshop_lengths(spec) ? std::nullopt : result.bound;
  if (!result.design && !result.proven_none)
    result = searched_again(run, std::move(result), goal,
                            [](const SearchResult& found) { return found.design.has_value(); });
  if (result.design) {
    const bool complete = result.design->complete;
    result = with_bound(run, std::move(result), goal);
    result.design->evaluations = result.evaluations;
    result.design->complete = complete && !run.stop()();
    return *std::move(result.design);
  }
  if (result.stopped && !result.proven_none) return Stopped{result.evaluations, bound};
  return diagnose(run, result);
}

SearchOutcome back_to_the_table(SearchOutcome outcome, const Point& origin) {
  if (auto* found = std::get_if<FoundDesign>(&outcome)) return shifted(std::move(*found), origin);
  if (auto* none = std::get_if<NoDesign>(&outcome)) return shifted(std::move(*none), origin);
  return outcome;
}

}  // namespace

SearchOutcome synthesize(const Spec& spec, const SearchOptions& options) {
  if (auto none = plainly_impossible(spec)) return *std::move(none);
  const Point origin = local_origin(spec);
  if (origin.isZero(0)) return synthesize_here(spec, options);
  return back_to_the_table(synthesize_here(shifted(spec, -origin), options), origin);
}

}  // namespace kempe
