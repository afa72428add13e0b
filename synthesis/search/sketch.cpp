#include "synthesis/search/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/problem/local_frame.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"
#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"
#include "synthesis/tolerance/robust.hpp"

namespace kempe {
namespace {

/// True of what a local solution cannot keep or choose: stock lengths, one of several sections, and limits for every instrument within the tolerances.
bool only_searched(const Spec& spec) {
  return has_stock_lengths(spec) || asks_for_robust(spec) || spec.links.sections.size() > 1;
}

DesignPoint point_of(const CopyingLinkage& linkage) {
  return {{std::log(linkage.VA()), std::log(linkage.VB())}, linkage.pole()};
}

/// The design that one choice has near a point; nothing if its local solution is no better than `known`.
std::optional<FoundDesign> design_near(const SearchTask& task, Subproblem& sub, const DesignPoint& point,
                                       const std::optional<FoundDesign>& known = {}) {
  const ChoiceResult local = refine(*sub.problem, point, task.budgets().local, task.stop());
  const double too_much = !known                    ? std::numeric_limits<double>::infinity()
                          : is_maximized(task.goal) ? -known->value
                                                    : known->value;
  if (local.cost >= too_much) return std::nullopt;
  const ChoiceResult kept = certified(task, sub, local, too_much);
  if (!kept.feasible) return std::nullopt;
  return design_of(task, sub, kept);
}

/// The same, from anywhere.
std::optional<FoundDesign> looked_for(const SearchTask& task, Subproblem& sub, const ChoiceBudget& budget) {
  const ChoiceResult kept = certified(task, sub, search_choice(*sub.problem, choice_options(task, budget)));
  if (!kept.feasible) return std::nullopt;
  return design_of(task, sub, kept);
}

bool is_of(const Subproblem& sub, const CopyingLinkage& linkage) {
  const Choice& choice = sub.choice->choice;
  return choice.grounding == linkage.grounding() && choice.assembly_mode == linkage.assembly_mode().number;
}

bool is_choice(const Subproblem& sub, const FoundDesign& design) {
  return is_of(sub, design.linkage) && sub.choice->choice.layers == design.layers;
}

/// The choices with the last design's first: that itself, then those that differ in their layers, then the others.
std::vector<Subproblem> in_order(const SearchTask& task, const FoundDesign& last) {
  std::vector<Subproblem> all = task.subproblems();
  const auto strangeness = [&](const Subproblem& sub) {
    return is_choice(sub, last) ? 0 : is_of(sub, last.linkage) ? 1 : 2;
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Subproblem& a, const Subproblem& b) { return strangeness(a) < strangeness(b); });
  return all;
}

/// What a sketch does beside following the last design. Among obstacles a solution takes milliseconds, and little changes from
/// one sketch to the next: there these take turns.
struct Turn {
  bool other_layers = true;              ///< where the last choice has no design any more
  bool promising = true, others = true;  ///< of the choices at the bound's starts, where they are many
  bool looks = true;                     ///< at another choice from anywhere
  bool follows = true;    ///< instead of that, with a design at hand: a known one of another choice
  std::size_t round = 0;  ///< how often it was this turn
};

Turn turn_of(std::size_t count, bool are_many, bool has_obstacles) {
  if (are_many) {
    const std::size_t phase = count % 4;
    return {phase == 0, phase == 1, phase == 3, phase == 2, phase == 2 && count / 4 % 2 == 1, count / 4};
  }
  if (has_obstacles) {
    const bool starts = count % 2 == 0;
    return {true, starts, starts, !starts, count % 4 == 3, count / 2};
  }
  return {true, true, true, true, count % 2 == 1, count};
}

/// Of choices that differ in their layers alone those that a sketch solves near a point: the ones that promise most there, and
/// some in turn.
std::vector<Subproblem*> chosen_of(const SearchTask& task, const std::vector<Subproblem*>& alike,
                                   const DesignPoint& point, const Turn& turn, const SketchBudget& budget) {
  if (alike.size() <= budget.promising + budget.in_turn) return alike;
  std::vector<std::pair<double, Subproblem*>> ranked;
  SmallestGaps shared = alike.front()->problem->gaps_at(point);
  for (Subproblem* sub : alike)
    ranked.emplace_back(merit_at(*sub->problem, point, task.budgets().local, &shared), sub);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Subproblem*> chosen;
  const std::size_t others = ranked.size() - budget.promising;
  if (turn.other_layers || turn.promising)
    for (std::size_t i = 0; i < budget.promising; ++i) chosen.push_back(ranked[i].second);
  if (turn.other_layers || turn.others)
    for (std::size_t i = 0; i < budget.in_turn; ++i)
      chosen.push_back(ranked[budget.promising + (turn.round * budget.in_turn + i) % others].second);
  return chosen;
}

/// Leaves out the choices in which an obstacle or a body stands where the copy itself needs room, whatever the lengths are.
void leave_out_hopeless(std::vector<Subproblem>& choices, const LogLengths& any) {
  std::map<Grounding, SmallestGaps> shared;  // tracer and pen are at the same places in every assembly mode
  std::vector<bool> hopeless;
  for (const Subproblem& sub : choices) {
    const DesignProblem& problem = *sub.problem;
    auto at = shared.find(sub.choice->choice.grounding);
    if (at == shared.end())
      at =
          shared.emplace(sub.choice->choice.grounding, problem.gaps_at({any, problem.layout().origin})).first;
    hopeless.push_back(problem.is_in_the_way_of_the_copy(at->second));
  }
  std::vector<Subproblem> left;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (!hopeless[i]) left.push_back(std::move(choices[i]));
  choices = std::move(left);
}

/// How far every design is from the best of all, as far as few boxes tell. Obstacles would take many.
std::optional<ProvenBound> compared(const SearchTask& task, const std::optional<FoundDesign>& found,
                                    const SketchBudget& budget) {
  Spec free = task.spec();
  free.obstacles.clear();
  BoundOptions options{
      .tolerance = budget.near, .boxes = budget.boxes, .self_contact = false, .stop = task.stop()};
  if (found) options.incumbent = found->value;
  return proven_bound(free, options);
}

/// The choices of which the bound does not say that they are no better than what was found.
std::vector<Subproblem*> worth_a_look(std::vector<Subproblem>& choices, Goal goal,
                                      const std::optional<ProvenBound>& bound,
                                      const std::optional<FoundDesign>& found) {
  std::vector<Subproblem*> open;
  for (Subproblem& sub : choices) {
    if (!bound) {
      open.push_back(&sub);
      continue;
    }
    const auto best = bound->by_grounding[static_cast<std::size_t>(sub.choice->choice.grounding)];
    if (best && (!found || (is_maximized(goal) ? *best > found->value : *best < found->value)))
      open.push_back(&sub);
  }
  return open;
}

/// The better of a sketch's design and another one leads; the other stays among the designs of other choices.
void remember(std::optional<FoundDesign> other, Goal goal, SketchedDesign& result) {
  if (!other) return;
  if (!result.design || is_better(goal, *other, *result.design)) std::swap(other, result.design);
  if (!other) return;
  const auto same_choice = [](const FoundDesign& a, const FoundDesign& b) {
    return a.linkage.grounding() == b.linkage.grounding() &&
           a.linkage.assembly_mode() == b.linkage.assembly_mode() && a.layers == b.layers;
  };
  std::erase_if(result.others, [&](const FoundDesign& one) {
    return same_choice(one, *other) || same_choice(one, *result.design);
  });
  if (!same_choice(*other, *result.design)) result.others.push_back(*std::move(other));
}

/// What a choice other than the sketch's has: one whose design is known is followed, or another one is looked at.
std::optional<FoundDesign> of_another_choice(const SearchTask& task, std::vector<Subproblem>& choices,
                                             const std::vector<Subproblem*>& open,
                                             const SketchedDesign& result, const Turn& turn,
                                             const ChoiceBudget& look) {
  if (!turn.looks) return std::nullopt;
  if (result.design && turn.follows && !result.others.empty()) {
    const FoundDesign& known = result.others[turn.round / 2 % result.others.size()];
    for (Subproblem& sub : choices)
      if (is_choice(sub, known)) return design_near(task, sub, point_of(known.linkage));
    return std::nullopt;
  }
  if (open.empty()) return std::nullopt;
  return looked_for(task, *open[(result.design ? turn.round / 2 : turn.round) % open.size()], look);
}

/// `result` comes with the other choices' last designs.
SketchedDesign sketch_here(const SearchTask& task, const FoundDesign& last, SketchedDesign result,
                           std::size_t count, const SketchBudget& budget) {
  std::vector<Subproblem> choices = in_order(task, last);
  const bool any_possible = !choices.empty();
  const bool has_obstacles = any_possible && choices.front().problem->has_obstacles();
  if (has_obstacles) leave_out_hopeless(choices, point_of(last.linkage).lengths);
  if (any_possible && choices.empty()) return result;  // no proof: these gaps are doubles
  const DesignPoint from = point_of(last.linkage);
  const bool are_many = choices.size() > budget.choices;
  const Turn turn = turn_of(count, are_many, has_obstacles);
  const auto solved_of = [&](const std::vector<Subproblem*>& alike, const DesignPoint& point) {
    return are_many ? chosen_of(task, alike, point, turn, budget) : alike;
  };
  std::vector<Subproblem*> other_layers;
  for (Subproblem& sub : choices) {
    if (is_choice(sub, last) && !result.design)
      result.design = design_near(task, sub, from);
    else if (is_of(sub, last.linkage))
      other_layers.push_back(&sub);
  }
  if (!result.design && turn.other_layers)
    for (Subproblem* sub : solved_of(other_layers, from))
      if (!result.design && !task.stopped()) result.design = design_near(task, *sub, from);
  const auto bound = compared(task, result.design, budget);
  if (bound && bound->no_design) {
    result.proven_none = true;
    return result;
  }
  if (bound) result.bound = bound->value;
  const auto is_near = [&] {
    return result.design && bound &&
           std::abs(result.design->value - bound->value) <= budget.near * std::abs(bound->value);
  };
  // Places without contact that are better.
  std::vector<RelaxedDesign> starts;
  if (bound && (turn.promising || turn.others)) starts = starts_of(*bound);
  for (const RelaxedDesign& start : starts) {
    if (is_near() || task.stopped()) break;
    std::vector<Subproblem*> alike;
    for (Subproblem& sub : choices) {
      const Choice& choice = sub.choice->choice;
      if (choice.grounding == start.grounding && choice.assembly_mode == start.assembly_mode)
        alike.push_back(&sub);
    }
    const DesignPoint there{{std::log(start.VA), std::log(start.VB)}, start.pole};
    for (Subproblem* sub : solved_of(alike, there))
      keep_better(task.goal, design_near(task, *sub, there, result.design), result.design);
  }
  if (is_near() || task.stopped()) return result;
  const std::vector<Subproblem*> open = worth_a_look(choices, task.goal, bound, result.design);
  remember(of_another_choice(task, choices, open, result, turn,
                             has_obstacles || are_many ? budget.brief_look : budget.look),
           task.goal, result);
  return result;
}

}  // namespace

SketchedDesign sketch_of(const FoundDesign& design) {
  return {.design = design, .bound = design.proven_bound, .last = design};
}

SketchedDesign sketched(const Spec& spec, const SketchedDesign& previous, const SketchBudget& budget,
                        const StopFlag& stop) {
  SketchedDesign none{.last = previous.last, .others = previous.others, .count = previous.count + 1};
  if (!previous.last || only_searched(spec)) return none;
  if (plainly_impossible(spec)) {
    none.proven_none = !spec.links.hardware.differs();
    return none;
  }
  const Point origin = local_origin(spec);
  const Spec here = shifted(spec, -origin);
  SearchOptions options;
  options.stop = stop;
  options.measure_gaps = false;
  SketchedDesign start;
  for (const FoundDesign& other : previous.others) start.others.push_back(shifted(other, -origin));
  SketchedDesign result = sketch_here(pose(here, SearchControl(options)), shifted(*previous.last, -origin),
                                      std::move(start), previous.count, budget);
  for (FoundDesign& other : result.others) other = shifted(std::move(other), origin);
  result.count = previous.count + 1;
  if (spec.links.hardware.differs()) {  // see claim_no_more()
    result.bound.reset();
    result.proven_none = false;
  }
  if (result.design) {
    result.design->proven_bound = result.bound;
    result.design = shifted(*result.design, origin);
  }
  result.last = result.design ? result.design : previous.last;
  return result;
}

}  // namespace kempe
