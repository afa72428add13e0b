#include "synthesis/search/steps/prove.hpp"

#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/steps/local_search.hpp"
#include "synthesis/search/steps/relax.hpp"

namespace kempe {
namespace {

/// A little more than the least usable angle, so that a start keeps it after rounding.
constexpr double usable_start = 1.001 * least_usable_angle;

/// The first design that local searches from what is known without contact lead to.
std::optional<FoundDesign> first_design(const SearchTask& task, const std::vector<RelaxedDesign>& known) {
  const StopFlag enough = task.control.after_share(task.budgets().time.first_design);
  for (Prospect& prospect : relax(task.with(task.goal == Goal::footprint ? Goal::size : task.goal), known)) {
    if (prospect.relaxed.feasible) prospect.known.push_back(prospect.relaxed.point);
    for (const DesignPoint& start : prospect.known) {
      if (enough()) return std::nullopt;
      Subproblem& sub = prospect.subproblem;
      const ChoiceResult found =
          certified(task, sub, refine(*sub.problem, start, task.budgets().local, enough));
      if (!found.feasible) continue;
      if (auto design = design_of(task, sub, found)) return design;
    }
  }
  return std::nullopt;
}

/// `options`: of the tree, whose goal and limits are the task's.
bool none_keeps_loads(const SearchTask& task, const Spec& spec, BoundOptions options) {
  if (!task.limits.load_error || task.goal == Goal::pole_margin || task.limits.pole_margin > 0) return false;
  options.tolerance = 1;  // the first design ends it
  options.load_limit = true;
  options.shortest = task.limits.shortest;
  options.stop = task.stop();
  const auto proof = proven_bound(spec, Objective::size, options);
  return proof && proof->no_design;
}

}  // namespace

Spec spec_for_tree(const SearchTask& task) { return with_limits(task.space().spec(), task.limits); }

std::optional<ProvenBound> prove(const SearchTask& task, const StopFlag& stop) {
  const Requirements& limits = task.limits;
  if (task.goal == Goal::pole_margin || limits.pole_margin > 0) return std::nullopt;
  const Objective objective = task.goal == Goal::transmission ? Objective::transmission : Objective::size;
  const BoundOptions options{.boxes = task.budgets().proof.boxes,
                             .shortest = limits.shortest,
                             .stop = stop,
                             .progress = task.control.progress_of("looking whether a design can exist")};
  Spec moved = spec_for_tree(task);
  auto bound = proven_bound(moved, objective, options);
  if (!bound || bound->no_design || limits.transmission > least_usable_angle) return bound;
  // The bound holds without the least angle that designs keep; places to start from are those that keep it.
  moved.limits.transmission = usable_start;
  const auto kept = proven_bound(moved, objective, options);
  bound->design = kept ? kept->design : std::nullopt;
  bound->promising = kept ? kept->promising : std::vector<RelaxedDesign>{};
  return bound;
}

bool none_keeps_loads(const SearchTask& task, std::size_t boxes) {
  return none_keeps_loads(task, spec_for_tree(task), {.boxes = boxes});
}

bool is_too_soft_anywhere(const SearchTask& task, const Spec& locked) {
  return none_keeps_loads(task, with_limits(locked, task.limits),
                          {.boxes = task.budgets().proof.boxes_of_locked_lengths, .self_contact = false});
}

FirstLook first_look(const SearchTask& task) {
  if (!task.control.has_time_limit() || has_stock_lengths(task.spec())) return {};
  FirstLook look;
  const StopFlag enough = task.control.after_share(task.budgets().time.proof);
  look.proof = prove(task, enough);
  look.proof_is_whole = !enough();
  if (!look.proof || !look.proof->no_design) look.design = first_design(task, starts_of(look.proof));
  return look;
}

std::vector<RelaxedDesign> starts_of(const std::optional<ProvenBound>& proof) {
  return proof ? starts_of(*proof) : std::vector<RelaxedDesign>{};
}

}  // namespace kempe
