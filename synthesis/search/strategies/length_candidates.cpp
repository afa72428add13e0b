#include "synthesis/search/strategies/length_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

/// The first `count` pairs by `order`, which rises in VB from `best_VB(VA)` on and falls up to there; pairs of infinite order
/// are left out. Looks at few of all pairs: a fine grid has billions.
template <typename Order, typename BestVB>
std::vector<LengthPair> pairs_in_order(const RatioLengths& lengths, std::size_t count, const Order& order,
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

void sort_and_cut(std::vector<LengthCandidate>& all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(),
                   [](const LengthCandidate& a, const LengthCandidate& b) { return a.order < b.order; });
  if (all.size() > most) all.resize(most);
}

/// The best lengths of a shape: of the design with any lengths, or without contact.
DesignPoint centre_of(const Prospect& prospect, const std::optional<FoundDesign>& any_lengths) {
  if (any_lengths) {
    const CopyingLinkage& linkage = any_lengths->linkage;
    const Choice& choice = prospect.subproblem.choice->choice;
    if (linkage.grounding() == choice.grounding && linkage.assembly_mode().number == choice.assembly_mode)
      return {{std::log(linkage.VA()), std::log(linkage.VB())}, linkage.pole()};
  }
  return prospect.relaxed.point;
}

}  // namespace

std::vector<Shape> shapes_of(const SearchTask& task, const std::vector<Prospect>& prospects) {
  std::map<std::tuple<Grounding, int, double>, std::vector<std::size_t>> by_shape;
  for (std::size_t i = 0; i < prospects.size(); ++i) {
    const Subproblem& sub = prospects[i].subproblem;
    by_shape[{sub.choice->choice.grounding, sub.choice->choice.assembly_mode, sub.allowed.lower}].push_back(
        i);
  }
  std::vector<Shape> shapes;
  for (auto& [key, alike] : by_shape) {
    const Complex shape = prospects[alike.front()].subproblem.problem->reach().shape();
    shapes.push_back(
        {std::move(alike), stock_lengths_for(task.spec().links.stock_lengths, shape, task.limits.longest)});
  }
  return shapes;
}

std::vector<LengthCandidate> candidates_by_size(const SearchTask& task,
                                                const std::vector<Prospect>& prospects,
                                                const std::vector<Shape>& shapes,
                                                const std::optional<FoundDesign>& any_lengths,
                                                double largest) {
  const std::size_t most = task.budgets().stock.candidates;
  std::vector<LengthCandidate> all;
  for (const Shape& shape : shapes) {
    const Prospect& prospect = prospects[shape.prospects.front()];
    if (!prospect.relaxed.feasible) continue;
    const Reach::LengthFactors& factors = prospect.subproblem.problem->reach().factors();
    const double per_VA = factors.size_per_VA, per_VB = factors.size_per_VB;
    const auto size = [&](double VA, double VB) { return per_VA * VA + per_VB * VB; };
    const double least = (1 - slack::bound_rounding) *
                         std::max(prospect.relaxed.cost, any_lengths ? any_lengths->attained.size : 0);
    const auto order = [&](double VA, double VB) {
      const double here = size(VA, VB);
      return here < least || here >= largest ? std::numeric_limits<double>::infinity() : here;
    };
    const auto best_VB = [&](double VA) { return (least - per_VA * VA) / per_VB; };
    for (const LengthPair& pair : pairs_in_order(shape.lengths, most, order, best_VB))
      all.push_back({&shape, pair, size(pair.VA, pair.VB)});
  }
  sort_and_cut(all, most);
  return all;
}

std::vector<LengthCandidate> candidates_near(const SearchTask& task, const std::vector<Prospect>& prospects,
                                             const std::vector<Shape>& shapes,
                                             const std::optional<FoundDesign>& any_lengths) {
  const StockBudget& budget = task.budgets().stock;
  std::vector<LengthCandidate> all;
  for (const Shape& shape : shapes) {
    const Prospect& prospect = prospects[shape.prospects.front()];
    if (!prospect.relaxed.feasible) continue;
    const DesignPoint centre = centre_of(prospect, any_lengths);
    const auto away = [&](double VA, double VB) {
      return std::hypot(std::log(VA) - centre.lengths.u, std::log(VB) - centre.lengths.v);
    };
    const auto best_VB = [&](double) { return std::exp(centre.lengths.v); };
    const Subproblem& sub = prospect.subproblem;
    const DesignProblem problem(task.space(), sub.choice->choice, task.limits, task.goal, sub.allowed, {});
    for (const LengthPair& pair : pairs_in_order(shape.lengths, budget.near_one_shape, away, best_VB)) {
      if (task.stopped()) break;
      const DesignPoint point{{std::log(pair.VA), std::log(pair.VB)}, centre.pole};
      all.push_back({&shape, pair, merit_at(problem, point, task.budgets().local)});
    }
  }
  sort_and_cut(all, budget.near_all_shapes);
  return all;
}

}  // namespace kempe
