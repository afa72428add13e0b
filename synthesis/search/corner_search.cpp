// For a limit of the first order, l, the search's best design has instruments with copy errors up to q(l) l, and q falls with l. So l is moved
// by a part of the way, in its logarithm, that a constant q would ask for, between the largest l known to keep the limit asked for and the
// smallest known not to.

#include "synthesis/search/corner_search.hpp"

#include <cmath>

#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/tolerance/corner_error.hpp"

namespace kempe {
namespace {

/// The copy error of the worst instrument found, mm, where the first order understates it; else nothing, as without a limit.
std::optional<double> understated_error(const SearchTask& task, const FoundDesign& design) {
  const Spec& spec = task.spec();
  if (!task.limits.copy_error || !spec.tolerance) return std::nullopt;
  const auto corner =
      corner_error_over(design.linkage, CopyTolerance::uniform(*spec.tolerance), RegionReach(spec.region));
  if (!corner || !first_order_understates(design.attained.copy_error, corner->worst)) return std::nullopt;
  return corner->worst;
}

std::optional<FoundDesign> found_with(const SearchTask& task, double copy_error, std::uint64_t& evaluations) {
  SearchTask lower = task.with(task.control.silent_part());
  lower.limits.copy_error = copy_error;
  SearchResult found = best_design(lower);
  if (found.design) found = improved(lower, std::move(found));
  evaluations += found.evaluations;
  return std::move(found.design);
}

}  // namespace

FoundDesign kept_at_corners(const SearchTask& task, const FoundDesign& found) {
  std::optional<double> error = understated_error(task, found);
  if (!error || *error <= *task.limits.copy_error) return found;
  const double limit = *task.limits.copy_error;
  const CornerBudget& budget = task.budgets().corner;
  std::optional<FoundDesign> best;
  std::uint64_t evaluations = found.evaluations;
  double keeps = 0, breaks = found.attained.copy_error, last = breaks, told = *error;
  for (int round = 0; round < budget.rounds && breaks - keeps > budget.near * limit && !task.stopped();
       ++round) {
    const double towards = last * std::pow((1 - 0.5 * budget.near) * limit / told, budget.step);
    const double lower = towards > keeps && towards < breaks ? towards : 0.5 * (keeps + breaks);
    const auto design = found_with(task, lower, evaluations);
    error = design ? understated_error(task, *design) : std::nullopt;
    const bool is_broken = error && *error > limit;
    (is_broken ? breaks : keeps) = lower;
    if (!design) continue;  // too low a limit
    last = lower;
    told = error.value_or(design->attained.copy_error);
    if (is_broken) continue;
    keep_better(task.goal, *design, best);
    if (told >= (1 - budget.near) * limit) break;
  }
  FoundDesign kept = best.value_or(found);
  kept.proven_bound = found.proven_bound;
  kept.evaluations = evaluations;
  kept.seed = found.seed;
  kept.complete = found.complete && !task.stopped();
  return kept;
}

}  // namespace kempe
