#include "synthesis/search/steps/certify.hpp"

#include <cmath>

#include "synthesis/problem/slack.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/local_search.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"
#include "workspace/footprint.hpp"

namespace kempe {
namespace {

/// A length from its logarithm: the decimal number next to it, 120 and not 119.99999999999999.
double length_from(double logarithm) {
  const double length = std::exp(logarithm);
  const double scale = std::pow(10.0, 13 - std::floor(std::log10(length)));
  return std::round(length * scale) / scale;
}

std::optional<CopyingLinkage> linkage_of(const Spec& spec, const Choice& choice, const DesignPoint& point) {
  const auto made = CopyingLinkage::make(spec.copy.k(), choice.grounding, length_from(point.lengths.u),
                                         length_from(point.lengths.v), choice.assembly_mode, point.pole);
  if (!made) return std::nullopt;
  return *made;
}

ChoiceResult solved_again(const SearchTask& task, const Subproblem& sub, const ChoiceResult& found) {
  ChoiceResult again = refine(*sub.problem, found.point, task.budgets().local, task.stop());
  again.evaluations += found.evaluations;
  return again;
}

/// By how much the broken limit is missed; 0 for limits that only rounding can miss.
double shortfall(const Requirements& limits, const DesignCheck& check) {
  switch (*check.broken) {
    case Goal::clearance: return limits.clearance - check.attained.clearance;
    case Goal::transmission: return limits.transmission - check.attained.transmission;
    case Goal::copy_gap: return *limits.copy_gap - check.attained.copy_gap;
    case Goal::load_error: return check.attained.load_error - *limits.load_error;
    case Goal::sag: return check.attained.sag - *limits.sag;
    default: return 0;
  }
}

/// By how much the limit on the links' load error is to fall for the pen to keep its limit in all, from what the links of a design have. What
/// pins and layers add falls with it: at first as if in proportion, which is nearly enough; then as if it stayed, which is enough.
double links_shortfall(const DesignProblem& problem, const Requirements& limits, const DesignCheck& check,
                       int repairs) {
  constexpr int in_proportion = 4;
  constexpr double a_little_more = 1.01;
  const double in_all = check.attained.load_error, limit = *limits.load_error,
               links = check.load_error_of_links;
  const double less = repairs < in_proportion ? links * (1 - limit / in_all) * a_little_more : in_all - limit;
  return (*problem.limits().load_error - (links - less)) / slack::tightening_factor;
}

/// The broken limit demanded more strictly from now on; false if that one cannot be. `repairs`: so far.
bool demand_more(Subproblem& sub, const Requirements& limits, const DesignCheck& check, int repairs) {
  if (!check.broken || check.needed.empty()) return false;
  const double missing = *check.broken == Goal::load_error && limits.load_error_in_all
                             ? links_shortfall(*sub.problem, limits, check, repairs)
                             : shortfall(limits, check);
  return sub.problem->tighten(*check.broken, std::max(0.0, missing));
}

ObstacleCheck checked_obstacles(const SearchTask& task, const Subproblem& sub, const CopyingLinkage& linkage,
                                const OpeningInterval& certified_opening) {
  return check_obstacles(
      task.space().spec(), task.limits, linkage, sub.choice->choice.layers, certified_opening, task.stop(),
      task.control.options().measure_gaps || task.goal == Goal::clearance ? SmallestGap::measured
                                                                          : SmallestGap::as_limit);
}

/// The subproblem with what the finished design misses; false if it misses nothing, or nothing that can be added. Tells in
/// `found` which of the two it is. `repairs`: so far.
bool learn(const SearchTask& task, Subproblem& sub, ChoiceResult& found, int repairs) {
  const bool may_solve_again = repairs < task.budgets().certify.repairs;
  const Choice& choice = sub.choice->choice;
  const auto linkage = linkage_of(task.spec(), choice, found.point);
  const DesignCheck check =
      linkage ? check_design(task.spec(), task.limits, *linkage, choice.layers) : DesignCheck{};
  found.feasible = check.feasible;
  if (!check.feasible)
    return may_solve_again && !task.stopped() && demand_more(sub, task.limits, check, repairs);
  if (task.space().obstacles().empty()) return false;
  const ObstacleCheck obstacles = checked_obstacles(task, sub, *linkage, check.opening);
  found.feasible = obstacles.clear;
  found.obstacle_clearance = obstacles.clearance;
  if (obstacles.clear || !obstacles.witness || !may_solve_again || task.stopped()) return false;
  sub.problem->add_place(*obstacles.witness);
  return true;
}

}  // namespace

ChoiceResult certified(const SearchTask& task, Subproblem& subproblem, ChoiceResult candidate,
                       double too_much) {
  for (int repairs = 0; candidate.feasible; ++repairs) {
    if (!learn(task, subproblem, candidate, repairs)) break;
    candidate = solved_again(task, subproblem, candidate);
    if (candidate.cost >= too_much) candidate.feasible = false;
  }
  return candidate;
}

std::optional<FoundDesign> design_of(const SearchTask& task, const Subproblem& subproblem,
                                     const ChoiceResult& found) {
  const Choice& choice = subproblem.choice->choice;
  const auto linkage = linkage_of(task.spec(), choice, found.point);
  if (!linkage) return std::nullopt;
  const DesignCheck check = check_design(task.spec(), task.limits, *linkage, choice.layers);
  if (!check.feasible) return std::nullopt;
  FoundDesign design{.linkage = *linkage, .layers = choice.layers, .goal = task.goal};
  design.attained = check.attained;
  if (task.goal == Goal::footprint || task.limits.footprint)
    design.attained.footprint = footprint(*linkage, task.spec().links.style, task.spec().region).area;
  if (!task.space().obstacles().empty()) {
    const double gap = found.obstacle_clearance
                           ? *found.obstacle_clearance
                           : checked_obstacles(task, subproblem, *linkage, check.opening).clearance;
    design.attained.clearance = std::min(design.attained.clearance, gap);
  }
  design.value = design.attained.of(task.goal);
  design.opening = check.opening;
  design.seed = task.control.options().seed;
  design.solvers = {nlopt_name() + " DIRECT-L", nlopt_name() + " CRS2", nlopt_name() + " SLSQP",
                    polish_solver()};
  return design;
}

}  // namespace kempe
