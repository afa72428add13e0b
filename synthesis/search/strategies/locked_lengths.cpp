#include "synthesis/search/strategies/locked_lengths.hpp"

#include <cmath>

#include "synthesis/search/steps/certify.hpp"
#include "synthesis/search/steps/prove.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

/// Both lengths locked, and no others.
StockLengths locked(const LengthPair& lengths) {
  StockLengths result;
  result.locked[0] = lengths.VA;
  result.locked[1] = lengths.VB;
  return result;
}

double cost_of(Goal goal, const FoundDesign& design) {
  return is_maximized(goal) ? -design.value : design.value;
}

/// The poles that are worth a look: promising without contact, and that of the best with any lengths.
std::vector<DesignPoint> starts_of(const Prospect& prospect, const LengthPair& lengths,
                                   const std::optional<FoundDesign>& any_lengths) {
  std::vector<Point> poles{prospect.relaxed.point.pole};
  if (any_lengths) poles.push_back(any_lengths->linkage.pole());
  poles.insert(poles.end(), prospect.poles.begin(), prospect.poles.end());
  std::vector<DesignPoint> starts;
  for (const Point& pole : poles) starts.push_back({{std::log(lengths.VA), std::log(lengths.VB)}, pole});
  return starts;
}

class LockedLengths {
 public:
  LockedLengths(const SearchTask& task, const LengthPair& lengths) : task_(task), locked_(locked(lengths)) {}

  std::uint64_t evaluations() const { return evaluations_; }

  /// Where it is proven that these lengths are too soft wherever the pole stands: sooner than a search in vain. Where the pole stands fast
  /// a look at the one design is sooner still.
  bool are_too_soft(Grounding grounding) const {
    if (!task_.limits.load_error || task_.spec().pole.is_fixed()) return false;
    Spec spec = task_.space().spec();
    spec.links.stock_lengths = locked_;
    spec.objective.groundings = {grounding};
    return is_too_soft_anywhere(task_, spec);
  }

  /// The best of a goal, without contact if there is none given.
  ChoiceResult search(const Subproblem& sub, const ContactTerms& contact, Goal sought,
                      std::vector<DesignPoint> hints) {
    const DesignProblem problem(task_.space(), sub.choice->choice, task_.limits, sought, sub.allowed, contact,
                                locked_);
    ChoiceOptions options = choice_options(task_, task_.budgets().choice.with_locked_lengths(
                                                      sought == Goal::footprint, !contact.obstacles.empty()));
    options.hints = std::move(hints);
    ChoiceResult found = search_choice(problem, options);
    evaluations_ += found.evaluations;
    return found;
  }

  /// The smallest is found soonest, and may stand nearly alone: it leads to the best of the goal.
  std::optional<FoundDesign> with_layers(const Subproblem& sub, const ChoiceResult& small,
                                         const ChoiceResult& free) {
    const Goal goal = task_.goal;
    const ContactTerms& contact = sub.choice->terms;
    ChoiceResult found = search(sub, contact, Goal::size, {small.point, free.point});
    if (!found.feasible) return std::nullopt;
    if (goal != Goal::size) {
      const ChoiceResult led = search(sub, contact, goal, {found.point, free.point});
      if (led.feasible) found = led;
    }
    Subproblem here{sub.choice, sub.allowed,
                    std::make_unique<DesignProblem>(task_.space(), sub.choice->choice, task_.limits, goal,
                                                    sub.allowed, contact, locked_)};
    found = certified(task_, here, found);
    return found.feasible ? design_of(task_, here, found) : std::nullopt;
  }

 private:
  const SearchTask& task_;
  StockLengths locked_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace

SearchResult best_with_locked_lengths(const SearchTask& task, const std::vector<Prospect>& prospects,
                                      const LengthCandidate& candidate,
                                      const std::optional<FoundDesign>& any_lengths) {
  const Goal goal = task.goal;
  LockedLengths locked(task, candidate.lengths);
  const Prospect& first = prospects[candidate.shape->prospects.front()];
  const Subproblem& sub = first.subproblem;
  if (locked.are_too_soft(sub.choice->choice.grounding)) return {.evaluations = locked.evaluations()};
  const ChoiceResult small =
      locked.search(sub, {}, Goal::size, starts_of(first, candidate.lengths, any_lengths));
  if (!small.feasible) return {.evaluations = locked.evaluations()};
  const ChoiceResult free = goal == Goal::size ? small : locked.search(sub, {}, goal, {small.point});
  const double near = goal == Goal::footprint ? slack::near_free_footprint : slack::near_free_cost;
  SearchResult result;
  int more_layers = task.budgets().stock.more_layers;
  for (const std::size_t i : candidate.shape->prospects) {
    if (task.stopped() || (result.design && more_layers-- == 0)) break;
    if (result.design && cost_of(goal, *result.design) <= free.cost + near * std::abs(free.cost)) break;
    keep_better(goal, locked.with_layers(prospects[i].subproblem, small, free), result.design);
  }
  result.evaluations = locked.evaluations();
  return result;
}

}  // namespace kempe
