#include "synthesis/search_run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "synthesis/copy_error.hpp"
#include "synthesis/design_check.hpp"
#include "synthesis/last_digits.hpp"
#include "synthesis/nlopt_backend.hpp"
#include "synthesis/parallel.hpp"

namespace kempe {
namespace {

/// Choices searched before what is found may leave out others.
constexpr std::size_t group_size = 4;
/// Of the global search for promising poles; how many are kept.
constexpr int pole_evaluations = 240;
constexpr int promising = 5;

/// The openings at which transmission and copy error keep their limits: one interval, or several.
std::vector<OpeningInterval> allowed_openings(const Spec& spec, const Choice& choice,
                                              const Requirements& limits) {
  const Reach reach(spec.copy.k, choice.vertex, choice.assembly);
  const OpeningInterval usable = openings_with_transmission(reach, limits.transmission);
  if (!limits.copy_error || !spec.tolerance || usable.empty()) return {usable};
  const CopyErrorProfile profile(spec.copy.k, choice.vertex, CopyTolerance::uniform(*spec.tolerance));
  return profile.openings_within(*limits.copy_error, usable);
}

}  // namespace

struct SearchRun::Task {
  std::unique_ptr<DesignProblem> problem;
  const ContactChoice* choice = nullptr;
  OpeningInterval allowed;
  std::vector<Point> poles;  ///< promising without contact
  ChoiceResult relaxed = no_result();
  ChoiceResult result = no_result();
};

SearchRun::SearchRun(const Spec& spec, const SearchOptions& options)
    : space_(spec), options_(options), start_(std::chrono::steady_clock::now()), choices_(choices_of(spec)) {
  stop_ = [this] {
    return (options_.stop && options_.stop->load(std::memory_order_relaxed)) ||
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() >
               options_.time_limit;
  };
}

std::vector<SearchRun::Task> SearchRun::tasks_for(const Requirements& limits, Goal goal) const {
  std::vector<Task> tasks;
  for (const ContactChoice& choice : choices_)
    for (const OpeningInterval& allowed : allowed_openings(spec(), choice.choice, limits)) {
      auto problem =
          std::make_unique<DesignProblem>(space_, choice.choice, limits, goal, allowed, choice.terms);
      if (problem->possible()) tasks.push_back({std::move(problem), &choice, allowed, {}});
    }
  return tasks;
}

ChoiceOptions SearchRun::options_for(bool relaxed) const {
  ChoiceOptions options{.seed = options_.seed, .stop = stop_};
  const bool free = space_.layout().pole_is_free;
  options.lattice = free ? 8 : 20;
  options.evaluations = relaxed ? 60 : free ? 300 : 200;
  options.starts = 6;
  return options;
}

/// Groundings, assemblies and allowed openings once each, without contact.
void SearchRun::relax(std::vector<Task>& tasks, const Requirements& limits, Goal goal) const {
  using Key = std::tuple<Vertex, int, double>;
  struct Relaxed {
    ChoiceResult result;
    std::vector<Point> poles;
  };
  const auto key = [](const Task& task) {
    return Key{task.choice->choice.vertex, task.choice->choice.assembly, task.allowed.lower};
  };
  std::map<Key, Relaxed> relaxed;
  for (const Task& task : tasks) relaxed.emplace(key(task), Relaxed{no_result(), {}});
  std::vector<std::pair<const Key, Relaxed>*> all;
  for (auto& one : relaxed) all.push_back(&one);
  run_parallel(all.size(), options_.threads, [&](std::size_t i) {
    const auto task =
        std::find_if(tasks.begin(), tasks.end(), [&](const Task& t) { return key(t) == all[i]->first; });
    const DesignProblem problem(space_, task->choice->choice, limits, goal, task->allowed, {});
    Relaxed& found = all[i]->second;
    found.poles = promising_poles(problem, pole_evaluations, promising, stop_);
    ChoiceOptions options = options_for(true);
    for (const Point& pole : found.poles)
      for (const double of_lambda : {0.0, 1.0})
        options.hints.push_back({problem.unit_lengths(pole, of_lambda, 0), pole});
    found.result = search_choice(problem, options);
  });
  for (Task& task : tasks) {
    task.relaxed = relaxed[key(task)].result;
    task.poles = relaxed[key(task)].poles;
  }
}

std::optional<FoundDesign> SearchRun::finished(const Task& task, const Requirements& limits,
                                               Goal goal) const {
  const auto& [choice, terms] = *task.choice;
  const DesignPoint& point = task.result.point;
  const auto linkage = CopyingLinkage::make(spec().copy.k, choice.vertex, std::exp(point.lengths.u),
                                            std::exp(point.lengths.v), choice.assembly, point.pole);
  if (!linkage) return std::nullopt;
  const DesignCheck check = check_design(spec(), limits, *linkage, choice.layers);
  if (!check.feasible) return std::nullopt;
  FoundDesign design{.linkage = *linkage, .layers = choice.layers, .goal = goal};
  design.attained = check.attained;
  design.value = check.attained.of(goal);
  design.opening = check.opening;
  design.seed = options_.seed;
  design.solvers = {nlopt_name() + " DIRECT-L", nlopt_name() + " CRS2", nlopt_name() + " SLSQP",
                    last_digits_solver()};
  return design;
}

SearchResult SearchRun::best(const Requirements& limits, Goal goal) const {
  SearchResult result;
  std::vector<Task> tasks = tasks_for(limits, goal);
  relax(tasks, limits, goal);
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return better(a.relaxed, b.relaxed); });
  ChoiceResult best = no_result();
  for (std::size_t first = 0; first < tasks.size() && !stop_(); first += group_size) {
    const std::size_t count = std::min(group_size, tasks.size() - first);
    run_parallel(count, options_.threads, [&](std::size_t i) {
      Task& task = tasks[first + i];
      if (best.feasible && !better(task.relaxed, best)) return;
      ChoiceOptions options = options_for(false);
      options.pole_hints = task.poles;
      if (task.relaxed.feasible) options.hints = {task.relaxed.point}, options.bound = task.relaxed.cost;
      task.result = search_choice(*task.problem, options);
    });
    for (std::size_t i = 0; i < count; ++i)
      if (better(tasks[first + i].result, best)) best = tasks[first + i].result;
    if (options_.progress)
      options_.progress(static_cast<double>(first + count) / static_cast<double>(tasks.size()), "searching");
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return better(a.result, b.result); });
  for (const Task& task : tasks) result.evaluations += task.relaxed.evaluations + task.result.evaluations;
  for (Task& task : tasks) {
    if (!task.result.feasible || result.design) break;
    task.result = refine_further(*task.problem, task.result, stop_);
    result.design = finished(task, limits, goal);
  }
  result.stopped = stop_();
  if (result.design) {
    result.design->evaluations = result.evaluations;
    result.design->complete = !result.stopped;
  }
  return result;
}

}  // namespace kempe
