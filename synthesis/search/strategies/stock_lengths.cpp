#include "synthesis/search/strategies/stock_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>

#include "kinematics/parallel.hpp"
#include "synthesis/search/strategies/locked_lengths.hpp"
#include "workspace/footprint.hpp"

namespace kempe {
namespace {

/// A footprint takes a thousand times as long to evaluate as a size, and the smallest linkage has nearly the least of it.
Goal quick_goal(Goal goal) { return goal == Goal::footprint ? Goal::size : goal; }

/// What every candidate is searched with: the task, and what is known without contact (of the quick goal).
struct Stock {
  const SearchTask& task;
  const std::vector<Prospect>& prospects;
  const std::optional<FoundDesign>& any_lengths;
};

/// The best of the first `enough` candidates that work.
struct BestCandidate {
  SearchResult found;
  std::size_t tried = 0;  ///< candidates
};
BestCandidate best_candidate(const Stock& stock, const std::vector<LengthCandidate>& all,
                             std::size_t enough) {
  const SearchTask& task = stock.task;
  const StockBudget& budget = task.budgets().stock;
  const std::size_t group_size =
      std::clamp(enough, budget.least_group, budget.largest_group);  // fixed: threads change nothing
  SearchResult best;
  std::size_t working = 0, tried = 0;
  while (tried < all.size() && working < enough && !task.stopped()) {
    std::vector<SearchResult> found(std::min(group_size, all.size() - tried));
    run_parallel(found.size(), task.control.options().threads, [&](std::size_t i) {
      found[i] = best_with_locked_lengths(task, stock.prospects, all[tried + i], stock.any_lengths);
    });
    tried += found.size();
    for (const SearchResult& one : found) {
      best.evaluations += one.evaluations;
      working += one.design ? 1 : 0;
      keep_better(task.goal, one.design, best.design);
    }
  }
  best.stopped = task.stopped();
  return {std::move(best), tried};
}

/// Leaves those out that have been tried.
void leave_out(std::vector<LengthCandidate>& candidates, std::span<const LengthCandidate> tried) {
  const auto key = [](const LengthCandidate& one) {
    return std::tuple(one.shape, one.lengths.VA, one.lengths.VB);
  };
  std::set<std::tuple<const Shape*, double, double>> known;
  for (const LengthCandidate& one : tried) known.insert(key(one));
  const auto is_known = [&](const LengthCandidate& one) { return known.contains(key(one)); };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_known), candidates.end());
}

/// The best design that keeps the task's ratio to the last digit.
SearchResult best_with_exact_ratio(const Stock& stock) {
  const SearchTask& task = stock.task;
  const StockBudget& budget = task.budgets().stock;
  const std::vector<Shape> shapes = shapes_of(task, stock.prospects);
  const auto near =
      candidates_near(task.with(quick_goal(task.goal)), stock.prospects, shapes, stock.any_lengths);
  const bool by_size = quick_goal(task.goal) == Goal::size;
  auto [result, tried] = best_candidate(stock, near, by_size ? budget.enough_by_size : budget.enough);
  // The smallest works first; what is smaller and has been tried does not work.
  if (task.goal == Goal::size) {
    const double largest = result.design ? result.design->value : std::numeric_limits<double>::infinity();
    auto by_rising_size = candidates_by_size(task, stock.prospects, shapes, stock.any_lengths, largest);
    leave_out(by_rising_size, std::span(near).first(tried));
    SearchResult smallest = best_candidate(stock, by_rising_size, 1).found;
    result.evaluations += smallest.evaluations;
    if (smallest.design) result.design = std::move(smallest.design);
  }
  result.stopped = task.stopped();
  return result;
}

/// A ratio next to the wanted one, of one grounding.
struct Ratio {
  Complex k;
  Grounding grounding;
  double off;
};

/// Those that lengths up to `longest` allow, of the groundings that may have a design, the smallest error first.
std::vector<Ratio> ratios_near(const SearchTask& task, const std::vector<Prospect>& known, double longest) {
  const Spec& spec = task.spec();
  std::vector<Ratio> ratios;
  for (const Grounding grounding : spec.objective.groundings) {
    if (std::none_of(known.begin(), known.end(), [&](const Prospect& one) {
          return one.relaxed.feasible && one.subproblem.choice->choice.grounding == grounding;
        }))
      continue;
    const Complex shape = shape_of(spec.copy.k(), grounding);
    for (const RatioLengths& lengths :
         nearest_stock_lengths(spec.links.stock_lengths, shape, longest, task.budgets().stock.ratios)) {
      const Complex k = ratio_of(shape / std::abs(shape) * lengths.ratio, grounding);
      ratios.push_back({k, grounding, std::abs(k - spec.copy.k())});
    }
  }
  std::stable_sort(ratios.begin(), ratios.end(),
                   [](const Ratio& a, const Ratio& b) { return a.off < b.off; });
  return ratios;
}

/// Prospects of a ratio next to another one, whose results without contact are as good as their own.
std::vector<Prospect> prospects_next_to(const std::vector<Prospect>& known, const SearchTask& task) {
  std::vector<Prospect> prospects;
  for (Subproblem& sub : task.subproblems()) {
    const Choice& choice = sub.choice->choice;
    const auto one = std::find_if(known.begin(), known.end(), [&](const Prospect& other) {
      const Choice& there = other.subproblem.choice->choice;
      return there.grounding == choice.grounding && there.assembly_mode == choice.assembly_mode;
    });
    Prospect& prospect = prospects.emplace_back(Prospect{std::move(sub)});
    if (one == known.end()) continue;
    prospect.relaxed = one->relaxed;
    prospect.relaxed.cost *= task.goal == Goal::size ? task.budgets().stock.neighbouring_size : 1;
    prospect.poles = one->poles;
  }
  return prospects;
}

SearchResult best_with_ratio(const SearchTask& task, const std::vector<Prospect>& known, const Ratio& ratio) {
  Spec other = task.spec();
  other.copy = Copy::of(ratio.k);
  other.objective.groundings = {ratio.grounding};
  const SearchTask there{std::make_shared<const SearchProblem>(other, task.limits), task.control.part(),
                         task.limits, task.goal};
  const std::vector<Prospect> prospects = prospects_next_to(known, there.with(quick_goal(task.goal)));
  return best_with_exact_ratio({there, prospects, std::nullopt});
}

/// A design of the quick goal, told by the task's own.
FoundDesign told_by(const SearchTask& task, FoundDesign design) {
  const Spec& spec = task.spec();
  if (task.goal == Goal::footprint)
    design.attained.footprint = footprint(design.linkage, spec.links.style, spec.region).area;
  design.goal = task.goal;
  design.value = design.attained.of(task.goal);
  return design;
}

/// The first design that is good enough; where the first few found are not, the best of them.
template <typename GoodEnough>
SearchResult best_of_ratios(const SearchTask& task, const std::vector<Prospect>& known,
                            const std::vector<Ratio>& ratios, const GoodEnough& is_good_enough) {
  const SearchTask quick = task.with(quick_goal(task.goal));
  const StockBudget& budget = task.budgets().stock;
  const int most_found = task.spec().obstacles.empty() ? budget.found_ratios : budget.found_ratios_obstacles;
  SearchResult result;
  const Ratio* chosen = nullptr;
  int found = 0;
  for (const Ratio& ratio : ratios) {
    if (task.stopped()) break;
    SearchResult here = best_with_ratio(quick, known, ratio);
    result.evaluations += here.evaluations;
    if (!here.design) continue;
    const bool good = is_good_enough(*here.design);
    if (good || !chosen || is_better(quick.goal, *here.design, *result.design))
      result.design = std::move(here.design), chosen = &ratio;
    if (good || ++found == most_found) break;
  }
  if (chosen && quick.goal != task.goal) {
    SearchResult best = best_with_ratio(task, known, *chosen);
    result.evaluations += best.evaluations;
    // Where the time was over first, the quick one is a design as well.
    result.design = best.design ? *std::move(best.design) : told_by(task, *std::move(result.design));
  }
  result.stopped = task.stopped();
  return result;
}

/// Where no stock lengths keep k: the ratio next to it for which the design is not much worse than with any lengths, or failing
/// that, the ratio next to it for which there is a design.
SearchResult best_with_another_ratio(const SearchTask& task, const std::vector<Prospect>& known,
                                     const FoundDesign& any_lengths) {
  const auto lengths = any_lengths.linkage.lengths().values();
  const double worse = task.budgets().stock.worse_for_ratio, most = task.limits.longest;
  const double longest = std::min(worse * *std::max_element(lengths.begin(), lengths.end()), most);
  const auto good = [&](const FoundDesign& design) {
    const double value = any_lengths.attained.of(design.goal);
    return is_maximized(design.goal) ? design.value >= value / worse : design.value <= value * worse;
  };
  SearchResult result = best_of_ratios(task, known, ratios_near(task, known, longest), good);
  if (result.design || result.stopped) return result;
  SearchResult farther =
      best_of_ratios(task, known, ratios_near(task, known, most), [](const FoundDesign&) { return true; });
  farther.evaluations += result.evaluations;
  return farther;
}

/// All choices without contact, of the quick goal; as far as they are known from the search with any lengths, these.
std::vector<Prospect> prospects_from(const SearchTask& task, std::vector<Prospect> relaxed) {
  const SearchTask quick = task.with(quick_goal(task.goal));
  if (relaxed.empty() || quick.goal != task.goal) return prospects_of(quick, quick.subproblems(), {});
  sort_by_choice(relaxed);
  relax_rest_under_load(task, relaxed);
  return relaxed;
}

}  // namespace

SearchResult best_with_stock_lengths(const SearchTask& task, const SearchResult& any_lengths,
                                     std::vector<Prospect> relaxed) {
  const std::vector<Prospect> prospects = prospects_from(task, std::move(relaxed));
  SearchResult result = best_with_exact_ratio({task, prospects, any_lengths.design});
  result.evaluations += any_lengths.evaluations;
  if (result.design || result.stopped || !any_lengths.design) return result;
  SearchResult inexact = best_with_another_ratio(task, prospects, *any_lengths.design);
  inexact.evaluations += result.evaluations;
  return inexact;
}

}  // namespace kempe
