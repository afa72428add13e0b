#include "synthesis/search.hpp"

#include "synthesis/diagnosis.hpp"
#include "synthesis/lower_bound.hpp"
#include "synthesis/search_run.hpp"

namespace kempe {
namespace {

/// A design further than this from the proven bound is searched around once more.
constexpr double unproven_share = 0.004;
constexpr int hops = 24;

bool has_workshop_lengths(const Spec& spec) {
  return spec.links.workshop.grid || !spec.links.workshop.stock.empty();
}

/// The proven bound, and the design improved where the bound's tree met a better one.
SearchResult with_bound(const SearchRun& run, SearchResult result, Goal goal) {
  const Spec& spec = run.spec();
  if (std::abs(result.design->linkage.k() - spec.copy.k) > 1e-12 * std::abs(spec.copy.k))
    return result;  // the bound is one of designs with the exact ratio
  const auto bound = lower_bound(spec, {.incumbent = result.design->value});
  if (!bound || bound->no_design) return result;
  if (!has_workshop_lengths(spec) && !run.stop()()) {
    const bool complete = result.design->complete;
    for (const RelaxedDesign& start : starts_of(*bound))
      result = run.best_from(start, requirements_of(spec), goal, std::move(result));
    if (std::abs(result.design->value - bound->value) > unproven_share * std::abs(bound->value))
      result = run.best_around(requirements_of(spec), goal, std::move(result), hops);
    result.design->evaluations = result.evaluations;
    result.design->complete = complete;
  }
  result.design->lower_bound = bound->value;
  return result;
}

}  // namespace

SearchOutcome synthesize(const Spec& spec, const SearchOptions& options) {
  if (auto none = plainly_impossible(spec)) return *std::move(none);
  const SearchRun run(spec, options);
  const Goal goal = goal_of(spec.objective.objective);
  SearchResult result = run.best(requirements_of(spec), goal);
  if (result.design) return *with_bound(run, std::move(result), goal).design;
  if (result.stopped) return Stopped{result.evaluations};
  return diagnose(run, result);
}

}  // namespace kempe
