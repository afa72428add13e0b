#include "synthesis/search/stock_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "synthesis/search/tolerances.hpp"
#include "synthesis/solvers/parallel.hpp"

namespace kempe {
namespace {

using tolerance::same_length;

const StockBudget& budget_of(const SearchRun& run) { return run.options().budgets.stock; }

std::vector<double> all_lengths(const WorkshopSpec& workshop, double longest) {
  std::vector<double> lengths = workshop.stock;
  if (workshop.grid)
    for (int i = 1; i * *workshop.grid <= longest * (1 + same_length); ++i)
      lengths.push_back(i * *workshop.grid);
  std::sort(lengths.begin(), lengths.end());
  lengths.erase(std::remove_if(lengths.begin(), lengths.end(),
                               [&](double x) { return x > longest * (1 + same_length); }),
                lengths.end());
  return lengths;
}

bool is_among(const std::vector<double>& sorted, double length) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), length * (1 - same_length));
  return at != sorted.end() && *at <= length * (1 + same_length);
}

WorkshopLengths lengths_for_ratio(const std::vector<double>& lengths, double ratio) {
  WorkshopLengths found{.ratio = ratio};
  for (const double length : lengths) {
    if (is_among(lengths, length * ratio)) found.VA.push_back(length);
    if (is_among(lengths, length / ratio)) found.VB.push_back(length);
  }
  return found;
}

}  // namespace

WorkshopLengths workshop_lengths(const WorkshopSpec& workshop, double scale_of_shape, double longest) {
  return lengths_for_ratio(all_lengths(workshop, longest), scale_of_shape);
}

std::vector<WorkshopLengths> nearest_workshop_lengths(const WorkshopSpec& workshop, double scale_of_shape,
                                                      double longest, int count) {
  const std::vector<double> lengths = all_lengths(workshop, longest);
  std::vector<double> ratios;
  for (const double VA : lengths) {  // for each VA the two lengths next to |s| VA
    const auto above = std::lower_bound(lengths.begin(), lengths.end(), VA * scale_of_shape);
    if (above != lengths.end()) ratios.push_back(*above / VA);
    if (above != lengths.begin()) ratios.push_back(*std::prev(above) / VA);
  }
  const auto off = [&](double ratio) { return std::abs(ratio - scale_of_shape); };
  std::sort(ratios.begin(), ratios.end(),
            [&](double a, double b) { return off(a) < off(b) || (off(a) == off(b) && a < b); });
  std::vector<WorkshopLengths> found;
  for (const double ratio : ratios) {
    if (static_cast<int>(found.size()) == count) break;
    if (!found.empty() && std::abs(found.back().ratio - ratio) <= same_length * ratio) continue;
    if (WorkshopLengths here = lengths_for_ratio(lengths, ratio); !here.VA.empty() && !here.VB.empty())
      found.push_back(std::move(here));
  }
  return found;
}

namespace {

struct LengthPair {
  double VA, VB;
};

/// The first `count` pairs by `order`, which rises in VB from `best_VB(VA)` on and falls up to there; pairs of infinite order
/// are left out. Looks at few of all pairs: a fine grid has billions.
template <typename Order, typename BestVB>
std::vector<LengthPair> pairs_in_order(const WorkshopLengths& lengths, std::size_t count, const Order& order,
                                       const BestVB& best_VB) {
  struct Cursor {
    double order;
    std::size_t VA, VB;
    bool up;
    bool operator<(const Cursor& other) const {
      return std::tie(order, VA, VB) > std::tie(other.order, other.VA, other.VB);
    }
  };
  std::priority_queue<Cursor> cursors;
  const auto push = [&](std::size_t i, std::size_t j, bool up) {
    if (j >= lengths.VB.size()) return;
    if (const double here = order(lengths.VA[i], lengths.VB[j]); std::isfinite(here))
      cursors.push({here, i, j, up});
  };
  for (std::size_t i = 0; i < lengths.VA.size(); ++i) {
    const auto at = std::lower_bound(lengths.VB.begin(), lengths.VB.end(), best_VB(lengths.VA[i]));
    const auto j = static_cast<std::size_t>(at - lengths.VB.begin());
    push(i, j, true);
    push(i, j - 1, false);  // wraps to beyond the end
  }
  std::vector<LengthPair> pairs;
  while (!cursors.empty() && pairs.size() < count) {
    const Cursor best = cursors.top();
    cursors.pop();
    pairs.push_back({lengths.VA[best.VA], lengths.VB[best.VB]});
    push(best.VA, best.up ? best.VB + 1 : best.VB - 1, best.up);
  }
  return pairs;
}

/// The tasks that differ in their layers alone: of one grounding, assembly mode and interval of openings.
struct Shape {
  std::vector<std::size_t> tasks;
  WorkshopLengths lengths;
};

/// A pair of lengths of a shape, with what orders the candidates.
struct Candidate {
  const Shape* shape;
  LengthPair lengths;
  double order;
};

/// The spec with both lengths locked.
Spec locked(const Spec& spec, double VA, double VB) {
  Spec result = spec;
  result.links.workshop = {};
  result.links.workshop.locked[0] = VA;
  result.links.workshop.locked[1] = VB;
  return result;
}

std::vector<Shape> shapes_of(const SearchRun& run, const std::vector<SearchTask>& tasks, double longest) {
  std::map<std::tuple<Grounding, int, double>, std::vector<std::size_t>> by_shape;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Choice& choice = tasks[i].choice->choice;
    by_shape[{choice.grounding, choice.assembly_mode, tasks[i].allowed.lower}].push_back(i);
  }
  std::vector<Shape> shapes;
  for (auto& [key, alike] : by_shape) {
    const double scale = std::abs(tasks[alike.front()].problem->reach().shape());
    shapes.push_back({std::move(alike), workshop_lengths(run.spec().links.workshop, scale, longest)});
  }
  return shapes;
}

void sort_and_cut(std::vector<Candidate>& all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  if (all.size() > most) all.resize(most);
}

/// By size, from the size that no lengths can beat up to `largest`.
std::vector<Candidate> candidates_by_size(const SearchRun& run, const std::vector<SearchTask>& tasks,
                                          const std::vector<Shape>& shapes,
                                          const std::optional<FoundDesign>& any_lengths, double largest) {
  std::vector<Candidate> all;
  for (const Shape& shape : shapes) {
    const SearchTask& task = tasks[shape.tasks.front()];
    if (!task.relaxed.feasible) continue;
    const double per_VA = task.problem->reach().factors().size_per_VA;
    const double per_VB = task.problem->reach().factors().size_per_VB;
    const auto size = [&](double VA, double VB) { return per_VA * VA + per_VB * VB; };
    const double least = (1 - tolerance::bound_rounding) *
                         std::max(task.relaxed.cost, any_lengths ? any_lengths->attained.size : 0);
    const auto order = [&](double VA, double VB) {
      const double here = size(VA, VB);
      return here < least || here >= largest ? std::numeric_limits<double>::infinity() : here;
    };
    const auto best_VB = [&](double VA) { return (least - per_VA * VA) / per_VB; };
    for (const LengthPair& pair : pairs_in_order(shape.lengths, budget_of(run).candidates, order, best_VB))
      all.push_back({&shape, pair, size(pair.VA, pair.VB)});
  }
  sort_and_cut(all, budget_of(run).candidates);
  return all;
}

/// The best lengths of a shape: of the design with any lengths, or without contact.
DesignPoint centre_of(const SearchTask& task, const std::optional<FoundDesign>& any_lengths) {
  if (any_lengths) {
    const CopyingLinkage& linkage = any_lengths->linkage;
    if (linkage.grounding() == task.choice->choice.grounding &&
        linkage.assembly_mode() == task.choice->choice.assembly_mode)
      return {{std::log(linkage.VA()), std::log(linkage.VB())}, linkage.pole()};
  }
  return task.relaxed.point;
}

/// A footprint takes a thousand times as long to evaluate as a size, and the smallest linkage has nearly the least of it.
Goal quick_goal(Goal goal) { return goal == Goal::footprint ? Goal::size : goal; }

/// Those next to the best lengths of each shape, by what the goal promises there without contact.
std::vector<Candidate> candidates_near(const SearchRun& run, const std::vector<SearchTask>& tasks,
                                       const std::vector<Shape>& shapes, const Requirements& limits,
                                       Goal goal, const std::optional<FoundDesign>& any_lengths) {
  std::vector<Candidate> all;
  for (const Shape& shape : shapes) {
    const SearchTask& task = tasks[shape.tasks.front()];
    if (!task.relaxed.feasible) continue;
    const DesignPoint centre = centre_of(task, any_lengths);
    const auto away = [&](double VA, double VB) {
      return std::hypot(std::log(VA) - centre.lengths.u, std::log(VB) - centre.lengths.v);
    };
    const DesignProblem problem(run.space(), task.choice->choice, limits, quick_goal(goal), task.allowed, {});
    for (const LengthPair& pair : pairs_in_order(shape.lengths, budget_of(run).near_one_shape, away,
                                                 [&](double) { return std::exp(centre.lengths.v); })) {
      if (run.stop()()) break;
      const DesignPoint point{{std::log(pair.VA), std::log(pair.VB)}, centre.pole};
      all.push_back({&shape, pair, merit_at(problem, point, run.options().budgets.local)});
    }
  }
  sort_and_cut(all, budget_of(run).near_all_shapes);
  return all;
}

/// The search for the pole with both lengths locked.
class LockedLengths {
 public:
  LockedLengths(const SearchRun& run, const Candidate& candidate, const Requirements& limits, Goal goal)
      : run_(run), candidate_(candidate), limits_(limits), goal_(goal),
        spec_(locked(run.space().spec(), candidate.lengths.VA, candidate.lengths.VB)), space_(spec_) {}

  /// The best design over all layers, sought around `poles` too. Without contact first: where no pole does there, no layers
  /// need to be looked at, and a pole that does is a good place to start.
  SearchResult best(const std::vector<SearchTask>& tasks, const std::vector<Point>& poles) {
    SearchResult result;
    const SearchTask& first = tasks[candidate_.shape->tasks.front()];
    const ChoiceResult small = search(first, {}, Goal::size, starts_at(poles), result);
    if (!small.feasible) return result;
    const double near_enough =
        goal_ == Goal::footprint ? tolerance::near_free_footprint : tolerance::near_free_cost;
    const ChoiceResult free = goal_ == Goal::size ? small : search(first, {}, goal_, {small.point}, result);
    int more_layers = budget_of(run_).more_layers;
    for (const std::size_t i : candidate_.shape->tasks) {
      if (run_.stop()() || (result.design && more_layers-- == 0)) break;
      if (result.design && cost_of(*result.design) <= free.cost + near_enough * std::abs(free.cost)) break;
      if (auto found = with_layers(tasks[i], small, free, result);
          found && (!result.design || cost_of(*found) < cost_of(*result.design)))
        result.design = std::move(found);
    }
    return result;
  }

 private:
  double cost_of(const FoundDesign& design) const {
    return is_maximized(goal_) ? -design.value : design.value;
  }

  std::vector<DesignPoint> starts_at(const std::vector<Point>& poles) const {
    std::vector<DesignPoint> starts;
    for (const Point& pole : poles)
      starts.push_back({{std::log(candidate_.lengths.VA), std::log(candidate_.lengths.VB)}, pole});
    return starts;
  }

  ChoiceResult search(const SearchTask& task, const ContactTerms& contact, Goal sought,
                      std::vector<DesignPoint> hints, SearchResult& counted) const {
    const DesignProblem problem(space_, task.choice->choice, limits_, sought, task.allowed, contact);
    const bool slow = sought == Goal::footprint, obstacles = !contact.obstacles.empty();
    const ChoiceBudgets& budgets = run_.options().budgets.choice;
    ChoiceResult found = search_choice(problem, {.budget = slow        ? budgets.locked_footprint
                                                           : obstacles ? budgets.locked_obstacles
                                                                       : budgets.locked,
                                                 .local = run_.options().budgets.local,
                                                 .seed = run_.options().seed,
                                                 .hints = std::move(hints),
                                                 .stop = run_.stop()});
    counted.evaluations += found.evaluations;
    return found;
  }

  /// The smallest is found soonest, and may stand nearly alone: it leads to the best of the goal.
  std::optional<FoundDesign> with_layers(const SearchTask& task, const ChoiceResult& small,
                                         const ChoiceResult& free, SearchResult& counted) const {
    SearchTask here;
    here.choice = task.choice;
    here.result = search(task, task.choice->terms, Goal::size, {small.point, free.point}, counted);
    if (!here.result.feasible) return std::nullopt;
    if (goal_ != Goal::size) {
      const ChoiceResult led =
          search(task, task.choice->terms, goal_, {here.result.point, free.point}, counted);
      if (led.feasible) here.result = led;
    }
    here.problem = std::make_unique<DesignProblem>(space_, task.choice->choice, limits_, goal_, task.allowed,
                                                   task.choice->terms);
    if (!run_.certify(here, limits_)) return std::nullopt;
    return run_.design_of(here, limits_, goal_);
  }

  const SearchRun& run_;
  const Candidate& candidate_;
  const Requirements& limits_;
  Goal goal_;
  Spec spec_;
  SearchSpace space_;
};

/// The poles that are worth a look for a candidate: of the best with any lengths, and promising without contact.
std::vector<Point> poles_for(const Candidate& candidate, const std::vector<SearchTask>& tasks,
                             const std::optional<FoundDesign>& any_lengths) {
  const SearchTask& task = tasks[candidate.shape->tasks.front()];
  std::vector<Point> poles{task.relaxed.point.pole};
  if (any_lengths) poles.push_back(any_lengths->linkage.pole());
  poles.insert(poles.end(), task.poles.begin(), task.poles.end());
  return poles;
}

/// The best of the first `enough` candidates that work.
SearchResult best_candidate(const SearchRun& run, const std::vector<SearchTask>& tasks,
                            const std::vector<Candidate>& all, const Requirements& limits, Goal goal,
                            const std::optional<FoundDesign>& any_lengths, std::size_t enough) {
  SearchResult best;
  std::size_t working = 0;
  const std::size_t group_size =
      std::clamp(enough, budget_of(run).least_group,
                 budget_of(run).largest_group);  // of fixed size: threads change nothing
  for (std::size_t first = 0; first < all.size() && working < enough && !run.stop()(); first += group_size) {
    const std::size_t count = std::min(group_size, all.size() - first);
    std::vector<SearchResult> found(count);
    run_parallel(count, run.options().threads, [&](std::size_t i) {
      const Candidate& candidate = all[first + i];
      found[i] =
          LockedLengths(run, candidate, limits, goal).best(tasks, poles_for(candidate, tasks, any_lengths));
    });
    for (SearchResult& one : found) {
      best.evaluations += one.evaluations;
      if (!one.design) continue;
      ++working;
      if (!best.design || is_better(goal, *one.design, *best.design)) best.design = std::move(one.design);
    }
  }
  best.stopped = run.stop()();
  return best;
}

/// The best design that keeps the run's ratio to the last digit, given its tasks with what is known without contact.
SearchResult best_with_exact_ratio(const SearchRun& run, const std::vector<SearchTask>& tasks,
                                   const Requirements& limits, Goal goal,
                                   const std::optional<FoundDesign>& any_lengths) {
  const std::vector<Shape> shapes = shapes_of(run, tasks, limits.longest);
  const auto near = candidates_near(run, tasks, shapes, limits, goal, any_lengths);
  const std::size_t enough =
      goal == Goal::size || goal == Goal::footprint ? budget_of(run).enough_by_size : budget_of(run).enough;
  SearchResult result = best_candidate(run, tasks, near, limits, goal, any_lengths, enough);
  if (goal == Goal::size) {  // the smallest works first
    const double largest = result.design ? result.design->value : std::numeric_limits<double>::infinity();
    SearchResult smallest =
        best_candidate(run, tasks, candidates_by_size(run, tasks, shapes, any_lengths, largest), limits, goal,
                       any_lengths, 1);
    result.evaluations += smallest.evaluations;
    if (smallest.design) result.design = std::move(smallest.design);
  }
  result.stopped = run.stop()();
  return result;
}

/// A ratio next to the wanted one, of one grounding.
struct Ratio {
  Complex k;
  Grounding grounding;
  double off;
};

/// Those that lengths up to `longest` allow, the smallest error first.
std::vector<Ratio> ratios_near(const SearchRun& run, double longest) {
  const Spec& spec = run.spec();
  std::vector<Ratio> ratios;
  for (const Grounding grounding : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k, grounding);
    for (const WorkshopLengths& lengths :
         nearest_workshop_lengths(spec.links.workshop, std::abs(shape), longest, budget_of(run).ratios)) {
      const Complex k = ratio_of(shape / std::abs(shape) * lengths.ratio, grounding);
      ratios.push_back({k, grounding, std::abs(k - spec.copy.k)});
    }
  }
  std::stable_sort(ratios.begin(), ratios.end(),
                   [](const Ratio& a, const Ratio& b) { return a.off < b.off; });
  return ratios;
}

/// Tasks of a ratio next to another one, whose results without contact are as good as their own.
std::vector<SearchTask> tasks_next_to(const std::vector<SearchTask>& known, const SearchRun& run,
                                      const Requirements& limits, Goal goal) {
  std::vector<SearchTask> tasks = run.tasks_for(limits, goal);
  for (SearchTask& task : tasks)
    for (const SearchTask& one : known)
      if (one.choice->choice.grounding == task.choice->choice.grounding &&
          one.choice->choice.assembly_mode == task.choice->choice.assembly_mode) {
        task.relaxed = one.relaxed;
        task.relaxed.cost *= goal == Goal::size ? budget_of(run).neighbouring_size : 1;
        task.poles = one.poles;
        break;
      }
  return tasks;
}

SearchResult best_with_ratio(const SearchRun& run, const std::vector<SearchTask>& known, const Ratio& ratio,
                             const Requirements& limits, Goal goal) {
  Spec other = run.spec();
  other.copy.k = ratio.k;
  other.objective.groundings = {ratio.grounding};
  const SearchRun inner(other, run.options_of_part());
  return best_with_exact_ratio(inner, tasks_next_to(known, inner, limits, quick_goal(goal)), limits, goal,
                               {});
}

/// The first design that is good enough; where the first few found are not, the best of them.
template <typename GoodEnough>
SearchResult best_of_ratios(const SearchRun& run, const std::vector<SearchTask>& known,
                            const std::vector<Ratio>& ratios, const Requirements& limits, Goal goal,
                            const GoodEnough& is_good_enough) {
  const Goal sought = quick_goal(goal);
  SearchResult result;
  const Ratio* chosen = nullptr;
  const int most_found =
      run.spec().obstacles.empty() ? budget_of(run).found_ratios : budget_of(run).found_ratios_obstacles;
  int found = 0;
  for (const Ratio& ratio : ratios) {
    if (run.stop()()) break;
    SearchResult here = best_with_ratio(run, known, ratio, limits, sought);
    result.evaluations += here.evaluations;
    if (!here.design) continue;
    const bool good = is_good_enough(*here.design);
    if (good || !chosen || is_better(sought, *here.design, *result.design))
      result.design = std::move(here.design), chosen = &ratio;
    if (good || ++found == most_found) break;
  }
  if (chosen && sought != goal) {
    SearchResult best = best_with_ratio(run, known, *chosen, limits, goal);
    result.evaluations += best.evaluations;
    result.design = std::move(best.design);
  }
  result.stopped = run.stop()();
  return result;
}

/// Where no workshop lengths keep k: the ratio next to it for which the design is not much worse than with any lengths, or
/// failing that, the ratio next to it for which there is a design.
SearchResult best_with_another_ratio(const SearchRun& run, const std::vector<SearchTask>& known,
                                     const Requirements& limits, Goal goal, const FoundDesign& any_lengths) {
  const auto lengths = any_lengths.linkage.lengths().values();
  const double worse_for_ratio = budget_of(run).worse_for_ratio;
  const double longest = worse_for_ratio * *std::max_element(lengths.begin(), lengths.end());
  const auto good = [&](const FoundDesign& design) {
    const double value = any_lengths.attained.of(design.goal);
    return is_maximized(design.goal) ? design.value >= value / worse_for_ratio
                                     : design.value <= value * worse_for_ratio;
  };
  SearchResult result =
      best_of_ratios(run, known, ratios_near(run, std::min(longest, limits.longest)), limits, goal, good);
  if (result.design || result.stopped) return result;
  SearchResult farther = best_of_ratios(run, known, ratios_near(run, limits.longest), limits, goal,
                                        [](const FoundDesign&) { return true; });
  farther.evaluations += result.evaluations;
  return farther;
}

}  // namespace

SearchResult best_with_workshop_lengths(const SearchRun& run, const Requirements& limits, Goal goal,
                                        const SearchResult& any_lengths) {
  std::vector<SearchTask> tasks = run.tasks_for(limits, quick_goal(goal));
  run.relax(tasks, limits, quick_goal(goal));
  SearchResult result = best_with_exact_ratio(run, tasks, limits, goal, any_lengths.design);
  result.evaluations += any_lengths.evaluations;
  if (result.design || result.stopped || !any_lengths.design) return result;
  SearchResult inexact = best_with_another_ratio(run, tasks, limits, goal, *any_lengths.design);
  inexact.evaluations += result.evaluations;
  return inexact;
}

}  // namespace kempe
