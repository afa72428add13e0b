#include "synthesis/search/strategies/tree_search.hpp"

#include <cmath>

#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/steps/prove.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "synthesis/search/strategies/strategy.hpp"

namespace kempe {
namespace {

bool is_of(const RelaxedDesign& design, const Choice& choice) {
  return choice.grounding == design.grounding && choice.assembly_mode == design.assembly_mode &&
         choice.layers == design.layers;
}

class TreeSearch {
 public:
  explicit TreeSearch(const SearchTask& task) : task_(task), strategy_(strategy_for(task.goal)) {
    for (Subproblem& sub : task.subproblems()) prospects_.push_back({std::move(sub)});
  }

  SearchResult run() {
    const auto tree = searched_by_tree(spec_for_tree(task_),
                                       task_.goal == Goal::size ? Objective::size : Objective::transmission,
                                       {.tolerance = slack::tree_bound,
                                        .boxes = task_.budgets().tree.boxes,
                                        .load_limit = true,
                                        .shortest = task_.limits.shortest,
                                        .threads = task_.control.options().threads,
                                        .stop = task_.stop(),
                                        .progress = task_.control.progress_of("searching")},
                                       trials());
    if (tree && tree->no_design) return {.proven_none = true, .evaluations = best_.evaluations};
    strategy_.finish(task_, best_);
    if (!best_.design) return {.stopped = task_.stopped(), .evaluations = best_.evaluations};
    best_.design->evaluations = best_.evaluations;
    best_.design->complete = !task_.stopped();
    return {.design = best_.design,
            .stopped = task_.stopped(),
            .exhausted = tree && tree->exhausted && !task_.stopped(),
            .bound = tree && tree->tight ? told(*tree) : std::nullopt,
            .evaluations = best_.evaluations};
  }

 private:
  /// The tree's bound; no bound that is told rests on the limit on the load error. Where the last digits made a design a trifle better than the
  /// one it was proven with, it holds all the same.
  std::optional<double> told(const ProvenBound& tree) const {
    const auto bound = task_.limits.load_error ? tree.without_load_limit : std::optional(tree.value);
    if (!bound) return std::nullopt;
    const double value = best_.design->value;
    return is_maximized(task_.goal) ? std::max(*bound, value) : std::min(*bound, value);
  }

  Trials trials() {
    return {.run = [this](const RelaxedDesign& start) { return try_from(start); },
            .without_load_limit = [this](const RelaxedDesign& start) { return value_without_load(start); },
            .most = task_.budgets().tree.trials,
            .places = task_.space().tracer_places(),
            .margin = slack::inward_obstacle * task_.space().layout().unit,
            .tolerance = task_.limits.load_error ? slack::tree_under_load : slack::tree_search,
            .share_of_load_limit = slack::gap_of_a_limit};
  }

  Trial try_from(const RelaxedDesign& start) {
    Trial trial;
    trial.in_vain = true;
    for (Prospect& prospect : prospects_)
      if (is_of(start, prospect.subproblem.choice->choice)) try_from(start, prospect, trial);
    if (best_.result.feasible) trial.best = is_maximized(task_.goal) ? -best_.result.cost : best_.result.cost;
    return trial;
  }

  void try_from(const RelaxedDesign& start, Prospect& prospect, Trial& trial) {
    const DesignProblem& problem = *prospect.subproblem.problem;
    const std::size_t known = problem.places().size();
    const DesignPoint point{{std::log(start.VA), std::log(start.VB)}, start.pole};
    const ChoiceResult found = refine(problem, point, task_.budgets().local, task_.stop(), &best_.result);
    trial.in_vain =
        trial.in_vain && !found.feasible;  // what is feasible is certified, which may add to the problem
    strategy_.certify(task_, prospect, found, best_);
    trial.in_the_way.insert(trial.in_the_way.end(),
                            problem.places().begin() + static_cast<std::ptrdiff_t>(known),
                            problem.places().end());
  }

  /// Of the local solution from `start` on, certified.
  std::optional<double> value_without_load(const RelaxedDesign& start) {
    if (!without_load_) {
      without_load_ = without_load_limit(task_);
      if (without_load_) subproblems_without_load_ = without_load_->subproblems();
    }
    for (Subproblem& sub : subproblems_without_load_) {
      if (!is_of(start, sub.choice->choice)) continue;
      const DesignPoint point{{std::log(start.VA), std::log(start.VB)}, start.pole};
      const ChoiceResult found =
          certified(*without_load_, sub, refine(*sub.problem, point, task_.budgets().local, task_.stop()));
      best_.evaluations += found.evaluations;
      if (found.feasible) return is_maximized(task_.goal) ? -found.cost : found.cost;
    }
    return std::nullopt;
  }

  const SearchTask& task_;
  const Strategy& strategy_;
  std::vector<Prospect> prospects_;
  Incumbent best_;
  std::optional<SearchTask> without_load_{};  ///< once it is asked for
  std::vector<Subproblem> subproblems_without_load_{};
};

}  // namespace

bool suits_tree_search(const SearchTask& task) {
  const Requirements& limits = task.limits;
  return !has_stock_lengths(task.spec()) && (task.goal == Goal::size || task.goal == Goal::transmission) &&
         (!task.space().obstacles().empty() || limits.load_error) && limits.pole_margin == 0 &&
         !limits.size && !limits.footprint && !limits.load_error_in_all;
}

SearchResult best_by_tree(const SearchTask& task) { return TreeSearch(task).run(); }

}  // namespace kempe
