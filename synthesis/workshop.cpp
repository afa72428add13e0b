#include "synthesis/workshop.hpp"

#include <algorithm>
#include <cmath>

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

/// A pair of lengths of one task, with what orders the candidates.
struct Candidate {
  std::size_t task;
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

/// Size: by the size itself, from the task's relaxed size upward. Others: by the distance from the task's best lengths.
std::vector<Candidate> candidates(const std::vector<SearchTask>& tasks,
                                  const std::vector<WorkshopLengths>& lengths, Goal goal) {
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Reach& reach = tasks[i].problem->reach();
    const ChoiceResult& near = tasks[i].result.feasible ? tasks[i].result : tasks[i].relaxed;
    if (!near.feasible) continue;
    for (const double VA : lengths[i].VA)
      for (const double VB : lengths[i].VB) {
        const double size = reach.factors().size_per_VA * VA + reach.factors().size_per_VB * VB;
        const double away =
            std::hypot(std::log(VA) - near.point.lengths.u, std::log(VB) - near.point.lengths.v);
        if (goal == Goal::size && size < tasks[i].relaxed.cost * (1 - 1e-9)) continue;
        all.push_back({i, VA, VB, goal == Goal::size ? size : away});
      }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  if (all.size() > most_candidates) all.resize(most_candidates);
  return all;
}

/// The best design of one candidate, pole sought where it is free.
SearchResult design_with(const SearchRun& run, const SearchTask& task, const Candidate& candidate,
                         const Requirements& limits, Goal goal) {
  SearchOptions options = run.options();
  options.threads = 1;
  options.progress = nullptr;
  const Spec spec = locked(run.spec(), candidate.VA, candidate.VB);
  const SearchSpace space(spec);
  const auto problem = [&](Goal sought) {
    return std::make_unique<DesignProblem>(space, task.choice->choice, limits, sought, task.allowed,
                                           task.choice->terms);
  };
  ChoiceOptions quick{.poles = 16,
                      .lattice = 1,
                      .evaluations = 60,
                      .starts = 3,
                      .starts_if_none = 4,
                      .seed = options.seed,
                      .stop = run.stop()};
  SearchTask here;
  here.choice = task.choice;
  here.problem = problem(Goal::size);
  here.result = search_choice(*here.problem, quick);
  SearchResult result{.evaluations = here.result.evaluations};
  // The smallest is found soonest, and may stand nearly alone.
  if (here.result.feasible && goal != Goal::size) {
    here.problem = problem(goal);
    const ChoiceResult near = refine(*here.problem, here.result.point, run.stop());
    const ChoiceResult far = search_choice(*here.problem, quick);
    result.evaluations += near.evaluations + far.evaluations;
    if (near.feasible || far.feasible) here.result = better(near, far) ? near : far;
  }
  if (here.result.feasible && run.certify(here, limits)) result.design = run.design_of(here, limits, goal);
  return result;
}

bool is_better(Goal goal, const FoundDesign& a, const FoundDesign& b) {
  return is_maximized(goal) ? a.value > b.value : a.value < b.value;
}

/// Size: the first candidate that works is the best. Others: the best of the first that work.
SearchResult best_candidate(const SearchRun& run, const std::vector<SearchTask>& tasks,
                            const std::vector<Candidate>& all, const Requirements& limits, Goal goal) {
  const std::size_t enough = goal == Goal::size ? 1 : 24;
  SearchResult best;
  std::size_t working = 0;
  for (std::size_t first = 0; first < all.size() && working < enough && !run.stop()(); first += group_size) {
    const std::size_t count = std::min(group_size, all.size() - first);
    std::vector<SearchResult> found(count);
    run_parallel(count, run.options().threads, [&](std::size_t i) {
      found[i] = design_with(run, tasks[all[first + i].task], all[first + i], limits, goal);
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
    const SearchRun inner(other, run.options());
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
  run.relax(tasks, limits, goal);
  const std::vector<WorkshopLengths> lengths = exact_lengths(run, tasks, limits.longest);
  SearchResult result = best_candidate(run, tasks, candidates(tasks, lengths, goal), limits, goal);
  const bool exact = std::any_of(lengths.begin(), lengths.end(), [](const WorkshopLengths& one) {
    return !one.VA.empty() && !one.VB.empty();
  });
  if (!result.design && !exact) result = best_with_another_ratio(run, limits, goal);
  result.evaluations += any_lengths.evaluations;
  return result;
}

}  // namespace kempe
