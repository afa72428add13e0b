#include "synthesis/search/search_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/chance.hpp"
#include "synthesis/problem/obstacle_reach.hpp"
#include "synthesis/search/design_check.hpp"
#include "synthesis/search/obstacle_check.hpp"
#include "synthesis/search/stock_lengths.hpp"
#include "synthesis/search/tolerances.hpp"
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/parallel.hpp"
#include "synthesis/solvers/polish.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/footprint.hpp"

namespace kempe {
namespace {

/// The openings at which transmission and copy error keep their limits: one interval, or several.
std::vector<OpeningInterval> allowed_openings(const Spec& spec, const Choice& choice,
                                              const Requirements& limits) {
  const Reach reach(spec.copy.k, choice.grounding, choice.assembly_mode);
  const OpeningInterval usable = openings_with_transmission(reach, limits.transmission);
  if (!limits.copy_error || !spec.tolerance || usable.empty()) return {usable};
  const CopyErrorProfile profile(spec.copy.k, choice.grounding, CopyTolerance::uniform(*spec.tolerance));
  std::vector<OpeningInterval> allowed;
  for (const OpeningInterval& within : profile.openings_within(*limits.copy_error, usable))
    if (const OpeningInterval inside = shrink(within, tolerance::inward_opening); !inside.empty())
      allowed.push_back(inside);
  return allowed;
}

Spec with_limits(Spec moved, const Requirements& limits) {
  moved.limits.transmission = limits.transmission;
  moved.limits.clearance = limits.clearance;
  moved.limits.sheets_gap = limits.sheets_gap;
  moved.limits.copy_error = limits.copy_error;
  moved.links.longest = limits.longest;
  return moved;
}

void remember(std::vector<SearchTask>& tasks, const std::vector<RelaxedDesign>& known) {
  for (SearchTask& task : tasks)
    for (const RelaxedDesign& one : known)
      if (task.choice->choice.grounding == one.grounding &&
          task.choice->choice.assembly_mode == one.assembly_mode)
        task.known.push_back({{std::log(one.VA), std::log(one.VB)}, one.pole});
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A length from its logarithm: the decimal number next to it, 120 and not 119.99999999999999.
double length_from(double logarithm) {
  const double length = std::exp(logarithm);
  const double scale = std::pow(10.0, 13 - std::floor(std::log10(length)));
  return std::round(length * scale) / scale;
}

std::optional<CopyingLinkage> linkage_of(const Spec& spec, const SearchTask& task) {
  const Choice& choice = task.choice->choice;
  const auto [u, v] = task.result.point.lengths;
  const auto made = CopyingLinkage::make(spec.copy.k, choice.grounding, length_from(u), length_from(v),
                                         choice.assembly_mode, task.result.point.pole);
  if (!made) return std::nullopt;
  return *made;
}

}  // namespace

bool is_better(Goal goal, const FoundDesign& a, const FoundDesign& b) {
  return is_maximized(goal) ? a.value > b.value : a.value < b.value;
}

double tighter_bound(Goal goal, const std::optional<double>& one, double other) {
  if (!one) return other;
  return is_maximized(goal) ? std::min(*one, other) : std::max(*one, other);
}

namespace {

/// `best` becomes `other` if that is better, or all there is.
void keep_better(Goal goal, const std::optional<FoundDesign>& other, std::optional<FoundDesign>& best) {
  if (other && (!best || is_better(goal, *other, *best))) best = other;
}

}  // namespace

SearchRun::SearchRun(const Spec& spec, SearchOptions options)
    : SearchRun(spec, std::move(options), requirements_of(spec)) {}

SearchRun::SearchRun(const Spec& spec, SearchOptions options, const Requirements& widest)
    : start_(std::chrono::steady_clock::now()), options_(std::move(options)), stop_(after_share(1)),
      spec_(spec), widest_(widest), space_(with_obstacles_in_reach(spec, widest)),
      choices_(choices_of(space_.spec())) {}

bool SearchRun::has_time_limit() const { return std::isfinite(options_.time_limit); }

/// Set by request, or when that share of the time limit is over.
StopFlag SearchRun::after_share(double share) const {
  if (!has_time_limit()) return options_.stop;
  return [this, share] { return options_.stop() || seconds_since(start_) > share * options_.time_limit; };
}

bool SearchRun::reaches_farther(const Requirements& limits) const {
  return space_.spec().obstacles.size() < spec_.obstacles.size() &&
         (limits.longest > widest_.longest || limits.clearance > widest_.clearance ||
          limits.pole_margin > widest_.pole_margin);
}

SearchOptions SearchRun::options_of_part() const {
  SearchOptions options = options_;
  options.stop = stop_;
  options.time_limit = std::numeric_limits<double>::infinity();
  return options;
}

SearchOptions SearchRun::part_of_time(double share) const {
  SearchOptions options = options_;
  options.time_limit = share * std::max(0.0, options_.time_limit - seconds_since(start_));
  return options;
}

std::vector<SearchTask> SearchRun::tasks_for(const Requirements& limits, Goal goal) const {
  return tasks_for(limits, goal, goal == Goal::footprint || limits.footprint);
}

std::vector<SearchTask> SearchRun::tasks_for(const Requirements& limits, Goal goal,
                                             bool mirror_images) const {
  std::vector<SearchTask> tasks;
  for (const ContactChoice& choice : choices_)
    for (const OpeningInterval& allowed : allowed_openings(spec(), choice.choice, limits)) {
      if (choice.is_mirror_image && !mirror_images) continue;
      auto problem =
          std::make_unique<DesignProblem>(space_, choice.choice, limits, goal, allowed, choice.terms);
      if (problem->possible()) tasks.push_back({std::move(problem), &choice, allowed});
    }
  return tasks;
}

ChoiceOptions SearchRun::options_for(bool relaxed) const {
  const ChoiceBudgets& budgets = options_.budgets.choice;
  const bool free = space_.layout().pole_is_free;
  const ChoiceBudget& budget = relaxed ? (free ? budgets.relaxed_free_pole : budgets.relaxed_fixed_pole)
                               : space_.obstacles().empty()
                                   ? (free ? budgets.free_pole : budgets.fixed_pole)
                                   : (free ? budgets.free_pole_obstacles : budgets.fixed_pole_obstacles);
  return {.budget = budget, .local = options_.budgets.local, .seed = options_.seed, .stop = stop_};
}

/// Groundings, assembly modes and allowed openings once each, without contact.
void SearchRun::relax(std::vector<SearchTask>& tasks, const Requirements& limits, Goal goal) const {
  using Key = std::tuple<Grounding, int, double>;
  struct Relaxed {
    const SearchTask* task;
    ChoiceResult result;
    std::vector<Point> poles;
  };
  const auto key = [](const SearchTask& task) {
    return Key{task.choice->choice.grounding, task.choice->choice.assembly_mode, task.allowed.lower};
  };
  std::map<Key, Relaxed> relaxed;
  for (const SearchTask& task : tasks) relaxed.emplace(key(task), Relaxed{&task, no_result(), {}});
  std::vector<Relaxed*> all;
  for (auto& one : relaxed) all.push_back(&one.second);
  run_parallel(all.size(), options_.threads, [&](std::size_t i) {
    Relaxed& here = *all[i];
    const DesignProblem problem(space_, here.task->choice->choice, limits, goal, here.task->allowed, {});
    here.poles = promising_poles(problem, options_.budgets.pole, options_.budgets.local, stop_);
    ChoiceOptions options = options_for(true);
    for (const Point& pole : here.poles)
      for (const double of_lambda : {0.0, 1.0})
        options.hints.push_back({problem.unit_lengths(pole, of_lambda, 0), pole});
    options.hints.insert(options.hints.end(), here.task->known.begin(), here.task->known.end());
    here.result = search_choice(problem, options);
  });
  for (SearchTask& task : tasks) {
    task.relaxed = relaxed.at(key(task)).result;
    task.poles = relaxed.at(key(task)).poles;
  }
}

bool SearchRun::demand_more(SearchTask& task, const DesignCheck& check, const Requirements& limits) const {
  if (!check.broken || check.needed.empty()) return false;
  const double shortfall =
      *check.broken == Goal::clearance      ? limits.clearance - check.attained.clearance
      : *check.broken == Goal::transmission ? limits.transmission - check.attained.transmission
      : *check.broken == Goal::sheets_gap   ? *limits.sheets_gap - check.attained.sheets_gap
                                            : 0;
  if (!task.problem->tighten(*check.broken, std::max(0.0, shortfall))) return false;
  const std::uint64_t before = task.result.evaluations;
  task.result = refine(*task.problem, task.result.point, options_.budgets.local, stop_);
  task.result.evaluations += before;
  return task.result.feasible;
}

bool SearchRun::certify(SearchTask& task, const Requirements& limits) const {
  for (int repairs = 0; task.result.feasible; ++repairs) {
    const auto linkage = linkage_of(spec(), task);
    const LayerAssignment& layers = task.choice->choice.layers;
    const DesignCheck check = linkage ? check_design(spec(), limits, *linkage, layers) : DesignCheck{};
    task.result.feasible = check.feasible;
    if (!check.feasible) {
      if (repairs == options_.budgets.certify.repairs || stop_() || !demand_more(task, check, limits)) break;
      continue;
    }
    if (space_.obstacles().empty()) break;
    const ObstacleCheck obstacles =
        check_obstacles(space_.spec(), limits, *linkage, layers, check.opening, stop_);
    if (obstacles.clear) break;
    if (!obstacles.witness || repairs == options_.budgets.certify.repairs || stop_()) {
      task.result.feasible = false;
      break;
    }
    task.problem->add_place(*obstacles.witness);
    const std::uint64_t before = task.result.evaluations;
    task.result = refine(*task.problem, task.result.point, options_.budgets.local, stop_);
    task.result.evaluations += before;
  }
  return task.result.feasible;
}

std::optional<FoundDesign> SearchRun::design_of(const SearchTask& task, const Requirements& limits,
                                                Goal goal) const {
  const auto linkage = linkage_of(spec(), task);
  if (!linkage) return std::nullopt;
  const LayerAssignment& layers = task.choice->choice.layers;
  const DesignCheck check = check_design(spec(), limits, *linkage, layers);
  if (!check.feasible) return std::nullopt;
  FoundDesign design{.linkage = *linkage, .layers = layers, .goal = goal};
  design.attained = check.attained;
  if (goal == Goal::footprint || limits.footprint)
    design.attained.footprint = footprint(*linkage, spec().links.style, spec().region).area;
  if (!space_.obstacles().empty())
    design.attained.clearance =
        std::min(design.attained.clearance,
                 check_obstacles(space_.spec(), limits, *linkage, layers, check.opening, stop_).clearance);
  design.value = design.attained.of(goal);
  design.opening = check.opening;
  design.seed = options_.seed;
  design.solvers = {nlopt_name() + " DIRECT-L", nlopt_name() + " CRS2", nlopt_name() + " SLSQP",
                    polish_solver()};
  return design;
}

void SearchRun::report(double share, std::string_view what) const {
  if (options_.progress) options_.progress(share, what);
}

/// The tree for these limits: a proof that no design keeps them, or a design to start from. Nothing where the pole may leave
/// its area, which the tree does not know.
std::optional<ProvenBound> SearchRun::proven_bound(const Requirements& limits, Goal goal,
                                                   const StopFlag& stop) const {
  if (goal == Goal::pole_margin || limits.pole_margin > 0) return std::nullopt;
  const Objective objective = goal == Goal::transmission ? Objective::transmission : Objective::size;
  const BoundOptions options{
      .boxes = options_.budgets.proof.boxes, .shortest = limits.shortest, .stop = stop};
  Spec moved = with_limits(space_.spec(), limits);
  auto bound = kempe::proven_bound(moved, objective, options);
  if (!bound || bound->no_design || limits.transmission > least_usable_angle) return bound;
  // The bound holds without the least angle that designs keep; places to start from are those that keep it.
  moved.limits.transmission = 1.001 * least_usable_angle;
  const auto kept = kempe::proven_bound(moved, objective, options);
  bound->design = kept ? kept->design : std::nullopt;
  bound->promising = kept ? kept->promising : std::vector<RelaxedDesign>{};
  return bound;
}

/// The first design that local searches from what is known without contact lead to.
std::optional<FoundDesign> SearchRun::first_design(const Requirements& limits, Goal goal,
                                                   const std::vector<RelaxedDesign>& known) const {
  const StopFlag enough = after_share(options_.budgets.time.first_design);
  std::vector<SearchTask> tasks = relaxed_tasks(limits, goal == Goal::footprint ? Goal::size : goal, known);
  for (SearchTask& task : tasks) {
    if (task.relaxed.feasible) task.known.push_back(task.relaxed.point);
    for (const DesignPoint& start : task.known) {
      if (enough()) return std::nullopt;
      task.result = refine(*task.problem, start, options_.budgets.local, enough);
      if (!certify(task, limits)) continue;
      if (auto design = design_of(task, limits, goal)) return design;
    }
  }
  return std::nullopt;
}

/// Within a share of the time limit, the proof as far as it comes and a first design.
SearchRun::FirstLook SearchRun::first_look(const Requirements& limits, Goal goal) const {
  FirstLook look;
  const StopFlag enough = after_share(options_.budgets.time.proof);
  look.proof = proven_bound(limits, goal, enough);
  look.proof_is_whole = !enough();
  if (look.proof && look.proof->no_design) return look;
  look.design =
      first_design(limits, goal, look.proof ? starts_of(*look.proof) : std::vector<RelaxedDesign>{});
  return look;
}

void SearchRun::search_group(std::vector<SearchTask>& tasks, std::size_t first, std::size_t count,
                             const ChoiceResult& best) const {
  run_parallel(count, options_.threads, [&](std::size_t i) {
    SearchTask& task = tasks[first + i];
    if (best.feasible && !better(task.relaxed, best)) return;
    ChoiceOptions options = options_for(false);
    if (task.relaxed.feasible) {
      options.hints = {task.relaxed.point};
      options.bound = task.relaxed.cost;
    }
    options.hints.insert(options.hints.end(), task.known.begin(), task.known.end());
    task.result = search_choice(*task.problem, options);
  });
}

/// The tasks in the order of what they can be at best, with what is known.
std::vector<SearchTask> SearchRun::relaxed_tasks(const Requirements& limits, Goal goal,
                                                 const std::vector<RelaxedDesign>& known) const {
  std::vector<SearchTask> tasks = tasks_for(limits, goal);
  remember(tasks, known);
  relax(tasks, limits, goal);
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const SearchTask& a, const SearchTask& b) { return better(a.relaxed, b.relaxed); });
  return tasks;
}

SearchResult SearchRun::best_of_any_lengths(const Requirements& limits, Goal goal,
                                            const std::vector<RelaxedDesign>& known) const {
  if (goal == Goal::footprint) return best_footprint(limits, known);
  SearchResult result;
  std::vector<SearchTask> tasks = relaxed_tasks(limits, goal, known);
  const std::size_t left_out = spec_.obstacles.size() - space_.obstacles().size();
  ChoiceResult best = no_result();
  SearchTask* chosen = nullptr;
  const std::size_t group_size = options_.budgets.group;
  for (std::size_t first = 0; first < tasks.size() && !stop_(); first += group_size) {
    const std::size_t count = std::min(group_size, tasks.size() - first);
    search_group(tasks, first, count, best);
    for (std::size_t i = first; i < first + count; ++i)
      if (better(tasks[i].result, best) && certify(tasks[i], limits) && better(tasks[i].result, best))
        best = tasks[i].result, chosen = &tasks[i];
    report(
        static_cast<double>(first + count) / static_cast<double>(tasks.size()),
        left_out == 0 ? "searching" : fmt::format("searching; {} obstacles out of reach left out", left_out));
  }
  if (chosen) {
    const ChoiceResult first = chosen->result;
    if (!stop_()) chosen->result = refine_further(*chosen->problem, first, options_.budgets.local, stop_);
    if (!certify(*chosen, limits)) chosen->result = first;
    result.design = design_of(*chosen, limits, goal);
  }
  for (const SearchTask& task : tasks)
    result.evaluations += task.relaxed.evaluations + task.result.evaluations;
  result.stopped = stop_();
  return result;
}

SearchResult SearchRun::best_footprint(const Requirements& limits,
                                       const std::vector<RelaxedDesign>& known) const {
  SearchResult result;
  std::vector<SearchTask> small = tasks_for(limits, Goal::size, true);
  remember(small, known);
  relax(small, limits, Goal::size);
  run_parallel(small.size(), options_.threads, [&](std::size_t i) {
    if (!stop_()) search_group(small, i, 1, no_result());
  });
  std::vector<SearchTask> tasks =
      tasks_for(limits, Goal::footprint);  // of the same choices in the same order
  for (std::size_t i = 0; i < tasks.size() && !stop_(); ++i) {
    tasks[i].relaxed = small[i].result;
    tasks[i].relaxed.cost = tasks[i].problem->assess(small[i].result.point, 1).cost;
    result.evaluations += small[i].relaxed.evaluations + small[i].result.evaluations;
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const SearchTask& a, const SearchTask& b) { return better(a.relaxed, b.relaxed); });
  if (tasks.size() > options_.budgets.group) tasks.resize(options_.budgets.group);
  run_parallel(tasks.size(), options_.threads, [&](std::size_t i) {
    const ChoiceOptions options{.budget = options_.budgets.choice.footprint,
                                .local = options_.budgets.local,
                                .seed = options_.seed,
                                .hints = {tasks[i].relaxed.point},
                                .stop = stop_};
    if (tasks[i].relaxed.feasible) tasks[i].result = search_choice(*tasks[i].problem, options);
  });
  // The estimate that steers the search lies 2 to 11 % below the footprint (57 random designs), on some designs more than on
  // others: the footprint itself decides, and the small designs that the search began with are candidates too.
  const auto consider = [&](SearchTask& task) {
    if (!certify(task, limits)) return;
    const auto design = design_of(task, limits, Goal::footprint);
    if (design && (!result.design || is_better(Goal::footprint, *design, *result.design)))
      result.design = design;
  };
  for (SearchTask& task : tasks) {
    if (stop_()) break;
    result.evaluations += task.result.evaluations;
    consider(task);
    task.result = task.relaxed;
    consider(task);
  }
  result.stopped = stop_();
  return result;
}

namespace {

/// A place around a point, the nearer the smaller `reach` (in shares of the lengths and of the task's size).
DesignPoint hop(const DesignPoint& from, double reach, double unit, bool pole_is_free, Chance& chance) {
  DesignPoint to = from;
  to.lengths.u += chance.symmetric(reach);
  to.lengths.v += chance.symmetric(reach);
  const double step_y = chance.symmetric(0.5 * reach * unit), step_x = chance.symmetric(0.5 * reach * unit);
  if (pole_is_free) to.pole += Point(step_x, step_y);
  return to;
}

}  // namespace

SearchResult SearchRun::best_from(const RelaxedDesign& start, const Requirements& limits, Goal goal,
                                  SearchResult found) const {
  if (reaches_farther(limits))
    return SearchRun(spec(), options_of_part(), limits).best_from(start, limits, goal, std::move(found));
  const DesignPoint point{{std::log(start.VA), std::log(start.VB)}, start.pole};
  for (SearchTask& task : tasks_for(limits, goal)) {
    if (task.choice->choice.grounding != start.grounding ||
        task.choice->choice.assembly_mode != start.assembly_mode)
      continue;
    if (stop_()) break;
    task.result = refine(*task.problem, point, options_.budgets.local, stop_);
    found.evaluations += task.result.evaluations;
    if (!certify(task, limits)) continue;
    const auto design = design_of(task, limits, goal);
    if (design && (!found.design || is_better(goal, *design, *found.design))) found.design = design;
  }
  return found;
}

SearchResult SearchRun::basin_hopping(const Requirements& limits, Goal goal, SearchResult found) const {
  std::vector<SearchTask> tasks;
  for (SearchTask& task : tasks_for(limits, goal))
    if (task.choice->choice.grounding == found.design->linkage.grounding() &&
        task.choice->choice.assembly_mode == found.design->linkage.assembly_mode())
      tasks.push_back(std::move(task));
  Chance chance(options_.seed);
  const ImproveBudget& budget = options_.budgets.improve;
  const int at_once = budget.hops_at_once;
  for (int first = 0; first < budget.hops && !tasks.empty() && !stop_(); first += at_once) {
    const CopyingLinkage& best = found.design->linkage;
    const DesignPoint centre{{std::log(best.VA()), std::log(best.VB())}, best.pole()};
    std::vector<std::pair<std::size_t, DesignPoint>> starts;
    for (int i = 0; i < at_once; ++i) {
      const std::size_t task = static_cast<std::size_t>(i) % tasks.size();
      const double reach = budget.first_reach * std::pow(budget.nearer, i / 2 + first / at_once);
      starts.emplace_back(task,
                          hop(centre, reach, space_.layout().unit, space_.layout().pole_is_free, chance));
    }
    std::vector<ChoiceResult> results(starts.size());
    run_parallel(starts.size(), options_.threads, [&](std::size_t i) {
      results[i] = refine(*tasks[starts[i].first].problem, starts[i].second, options_.budgets.local, stop_);
    });
    for (std::size_t i = 0; i < starts.size(); ++i) {
      found.evaluations += results[i].evaluations;
      const double now = is_maximized(goal) ? -found.design->value : found.design->value;
      SearchTask& task = tasks[starts[i].first];
      task.result = results[i];
      if (!task.result.feasible || task.result.cost > now - tolerance::hop_gain * std::abs(now) ||
          !certify(task, limits))
        continue;
      const auto design = design_of(task, limits, goal);
      if (design && is_better(goal, *design, *found.design)) found.design = design;
    }
  }
  return found;
}

SearchResult SearchRun::best(const Requirements& limits, Goal goal) const {
  if (reaches_farther(limits)) return SearchRun(spec(), options_of_part(), limits).best(limits, goal);
  const bool has_workshop_lengths = spec().links.workshop.grid || !spec().links.workshop.stock.empty();
  const FirstLook first = has_time_limit() && !has_workshop_lengths ? first_look(limits, goal) : FirstLook{};
  const auto proof = first.proof_is_whole ? first.proof : proven_bound(limits, goal, stop_);
  if (proof && proof->no_design) return {.proven_none = true};
  const std::vector<RelaxedDesign> known = proof ? starts_of(*proof) : std::vector<RelaxedDesign>{};
  SearchResult result = has_workshop_lengths && has_time_limit()
                            ? SearchRun(spec(), part_of_time(options_.budgets.time.any_lengths), limits)
                                  .best_of_any_lengths(limits, goal, known)
                            : best_of_any_lengths(limits, goal, known);
  if (result.design && has_workshop_lengths) {
    const bool stopped = result.stopped;
    result = best_with_workshop_lengths(*this, limits, goal, result);
    result.stopped = result.stopped || stopped;
  }
  if (result.stopped) keep_better(goal, first.design, result.design);
  if (goal == Goal::size || goal == Goal::transmission)
    for (const auto& bound : {first.proof, proof})
      if (bound) result.bound = tighter_bound(goal, result.bound, bound->value);
  if (result.design) {
    result.design->evaluations = result.evaluations;
    result.design->complete = !result.stopped;
  }
  return result;
}

}  // namespace kempe
