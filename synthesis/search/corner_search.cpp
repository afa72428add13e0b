#include "synthesis/search/corner_search.hpp"

#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/search/best/lowered_limit.hpp"
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
  const std::optional<double> error = understated_error(task, found);
  if (!error || *error <= *task.limits.copy_error) return found;
  std::uint64_t evaluations = found.evaluations;
  const auto best = best_of_lowered(
      task, *task.limits.copy_error, found.attained.copy_error, *error,
      [&](double lower) { return found_with(task, lower, evaluations); },
      [&](const FoundDesign& design) {
        return understated_error(task, design).value_or(design.attained.copy_error);
      });
  FoundDesign kept = best.value_or(found);
  kept.proven_bound = found.proven_bound;
  kept.evaluations = evaluations;
  kept.seed = found.seed;
  kept.complete = found.complete && !task.stopped();
  return kept;
}

}  // namespace kempe
