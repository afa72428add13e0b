#include "synthesis/workshop.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "synthesis/parallel.hpp"

namespace kempe {
namespace {

/// Two lengths closer than this share of the larger are one.
constexpr double same_length = 1e-9;
/// Candidates tried before the search gives up.
constexpr std::size_t most_candidates = 4000;
constexpr std::size_t group_size = 16;
/// Inexact ratios tried.
constexpr int most_ratios = 24;

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

/// A pair of lengths, with all tasks that differ in their layers alone, and what orders the candidates.
struct Candidate {
  std::vector<std::size_t> tasks;
  double VA, VB, order;
};

/// The spec with both lengths locked.
Spec locked(const Spec& spec, double VA, double VB) {
  Spec result = spec;
  result.links.workshop = {};
  result.links.workshop.locked[0] = VA;
  result.links.workshop.locked[1] = VB;
  return result;
}

/// The ratio k whose shape under this grounding is s.
Complex ratio_of(Complex shape, Vertex vertex) {
  switch (vertex) {
    case Vertex::pole: return shape;
    case Vertex::tracer: return 1.0 - shape;
    case Vertex::pen: break;
  }
  return 1.0 / (1.0 - shape);
}

/// The tasks that differ in their layers alone: of one grounding, assembly and interval of openings.
std::vector<std::vector<std::size_t>> tasks_by_shape(const std::vector<SearchTask>& tasks) {
  std::map<std::tuple<Vertex, int, double>, std::vector<std::size_t>> shapes;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Choice& choice = tasks[i].choice->choice;
    shapes[{choice.vertex, choice.assembly, tasks[i].allowed.lower}].push_back(i);
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& shape : shapes) result.push_back(std::move(shape.second));
  return result;
}

/// Size: by the size itself, from the task's relaxed size upward. Others: by the distance from the best lengths without
/// contact.
std::vector<Candidate> candidates(const std::vector<SearchTask>& tasks,
                                  const std::vector<WorkshopLengths>& lengths, Goal goal) {
  std::vector<Candidate> all;
  for (const std::vector<std::size_t>& shape : tasks_by_shape(tasks)) {
    const SearchTask& task = tasks[shape.front()];
    const Reach& reach = task.problem->reach();
    if (!task.relaxed.feasible) continue;
    for (const double VA : lengths[shape.front()].VA)
      for (const double VB : lengths[shape.front()].VB) {
        const double size = reach.factors().size_per_VA * VA + reach.factors().size_per_VB * VB;
        const double away = std::hypot(std::log(VA) - task.relaxed.point.lengths.u,
                                       std::log(VB) - task.relaxed.point.lengths.v);
        if (goal == Goal::size && size < task.relaxed.cost * (1 - 1e-9)) continue;
        all.push_back({shape, VA, VB, goal == Goal::size ? size : away});
      }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  if (all.size() > most_candidates) all.resize(most_candidates);
  return all;
}

/// The search for the pole with both lengths locked.
class LockedLengths {
 public:
  LockedLengths(const SearchRun& run, const Candidate& candidate, const Requirements& limits, Goal goal)
      : run_(run), candidate_(candidate), limits_(limits), goal_(goal),
        spec_(locked(run.spec(), candidate.VA, candidate.VB)), space_(spec_) {}

  /// The best design over all layers, sought around `poles` too. Without contact first: where no pole does there, no layers
  /// need to be looked at, and a pole that does is a good place to start.
  SearchResult best(const std::vector<SearchTask>& tasks, const std::vector<Point>& poles) {
    SearchResult result;
    const SearchTask& first = tasks[candidate_.tasks.front()];
    const ChoiceResult small = search(first, {}, Goal::size, starts_at(poles), result);
    if (!small.feasible) return result;
    const ChoiceResult free = goal_ == Goal::size ? small : search(first, {}, goal_, {small.point}, result);
    for (const std::size_t i : candidate_.tasks) {
      if (run_.stop()()) break;
      if (result.design && cost_of(*result.design) <= free.cost + 1e-7 * std::abs(free.cost)) break;
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
      starts.push_back({{std::log(candidate_.VA), std::log(candidate_.VB)}, pole});
    return starts;
  }

  ChoiceResult search(const SearchTask& task, const ContactTerms& contact, Goal sought,
                      std::vector<DesignPoint> hints, SearchResult& counted) const {
    const DesignProblem problem(space_, task.choice->choice, limits_, sought, task.allowed, contact);
    const ChoiceResult found = search_choice(problem, {.poles = 16,
                                                       .evaluations = contact.empty() ? 80 : 200,
                                                       .starts = 3,
                                                       .starts_if_none = 8,
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
  const SearchTask& task = tasks[candidate.tasks.front()];
  std::vector<Point> poles{task.relaxed.point.pole};
  if (any_lengths) poles.push_back(any_lengths->linkage.pole());
  poles.insert(poles.end(), task.poles.begin(), task.poles.end());
  return poles;
}

/// Size: the first candidate that works is the best. Others: the best of the first that work.
SearchResult best_candidate(const SearchRun& run, const std::vector<SearchTask>& tasks,
                            const std::vector<Candidate>& all, const Requirements& limits, Goal goal,
                            const SearchResult& any_lengths) {
  const std::size_t enough = goal == Goal::size ? 1 : 24;
  SearchResult best;
  std::size_t working = 0;
  for (std::size_t first = 0; first < all.size() && working < enough && !run.stop()(); first += group_size) {
    const std::size_t count = std::min(group_size, all.size() - first);
    std::vector<SearchResult> found(count);
    run_parallel(count, run.options().threads, [&](std::size_t i) {
      const Candidate& candidate = all[first + i];
      found[i] = LockedLengths(run, candidate, limits, goal)
                     .best(tasks, poles_for(candidate, tasks, any_lengths.design));
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

std::vector<WorkshopLengths> exact_lengths(const SearchRun& run, const std::vector<SearchTask>& tasks,
                                           double longest) {
  std::vector<WorkshopLengths> lengths;
  for (const SearchTask& task : tasks)
    lengths.push_back(
        workshop_lengths(run.spec().links.workshop, std::abs(task.problem->reach().shape()), longest));
  return lengths;
}

/// Where no workshop lengths keep k: a ratio next to it, grounding by grounding, the smallest error first.
SearchResult best_with_another_ratio(const SearchRun& run, const Requirements& limits, Goal goal) {
  struct Ratio {
    Complex k;
    Vertex vertex;
    double off;
  };
  const Spec& spec = run.spec();
  std::vector<Ratio> ratios;
  for (const Vertex vertex : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k, vertex);
    for (const WorkshopLengths& lengths :
         nearest_workshop_lengths(spec.links.workshop, std::abs(shape), limits.longest, most_ratios)) {
      const Complex k = ratio_of(shape / std::abs(shape) * lengths.ratio, vertex);
      ratios.push_back({k, vertex, std::abs(k - spec.copy.k)});
    }
  }
  std::stable_sort(ratios.begin(), ratios.end(),
                   [](const Ratio& a, const Ratio& b) { return a.off < b.off; });
  SearchResult result;
  for (const Ratio& ratio : ratios) {
    if (result.design || run.stop()()) break;
    Spec other = spec;
    other.copy.k = ratio.k;
    other.objective.groundings = {ratio.vertex};
    const SearchRun inner(other, run.options_from_now());
    for (const Goal sought : {Goal::size, goal}) {  // the smallest is found soonest: is there any?
      SearchResult here = inner.best(limits, sought);
      result.evaluations += here.evaluations;
      if (!here.design) break;
      if (sought == goal) result.design = std::move(here.design);
      if (result.design) break;
    }
  }
  result.stopped = run.stop()();
  return result;
}

}  // namespace

SearchResult best_with_workshop_lengths(const SearchRun& run, const Requirements& limits, Goal goal,
                                        const SearchResult& any_lengths) {
  std::vector<SearchTask> tasks = run.tasks_for(limits, goal);
  // A footprint takes a thousand times as long to evaluate as a size, and the smallest linkage has nearly the least of it.
  run.relax(tasks, limits, goal == Goal::footprint ? Goal::size : goal);
  const std::vector<WorkshopLengths> lengths = exact_lengths(run, tasks, limits.longest);
  SearchResult result =
      best_candidate(run, tasks, candidates(tasks, lengths, goal), limits, goal, any_lengths);
  const bool exact = std::any_of(lengths.begin(), lengths.end(), [](const WorkshopLengths& one) {
    return !one.VA.empty() && !one.VB.empty();
  });
  if (!result.design && !exact) result = best_with_another_ratio(run, limits, goal);
  result.evaluations += any_lengths.evaluations;
  return result;
}

}  // namespace kempe
