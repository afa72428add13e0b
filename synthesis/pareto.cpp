#include "synthesis/pareto.hpp"

#include <algorithm>

#include "synthesis/search_run.hpp"

namespace kempe {
namespace {

/// The limits with the objective kept at least as good as `value`.
Requirements kept(Requirements limits, Objective objective, double value) {
  switch (objective) {
    case Objective::size: limits.size = value; break;
    case Objective::footprint: limits.footprint = value; break;
    case Objective::copy_error: limits.copy_error = std::min(limits.copy_error.value_or(value), value); break;
    case Objective::transmission: limits.transmission = std::max(limits.transmission, value); break;
  }
  return limits;
}

/// Limits that a spec knows itself: the search is at its best with them.
bool is_natural_limit(Objective objective) {
  return objective == Objective::transmission || objective == Objective::copy_error;
}

bool beats(const ParetoPoint& a, const ParetoPoint& b, Objective first, Objective second) {
  const auto better = [](double x, double y, bool larger) { return larger ? x > y : x < y; };
  const bool worse_first = better(b.first, a.first, is_maximized(first));
  const bool worse_second = better(b.second, a.second, is_maximized(second));
  return !worse_first && !worse_second &&
         (better(a.first, b.first, is_maximized(first)) || better(a.second, b.second, is_maximized(second)));
}

}  // namespace

Front pareto_front(const Spec& spec, Objective first, Objective second, int count, const SearchOptions& options) {
  const SearchRun run(spec, options);
  const Requirements limits = requirements_of(spec);
  const Goal first_goal = goal_of(first), second_goal = goal_of(second);
  Front front;
  std::vector<ParetoPoint> found;
  const auto add = [&](const SearchResult& result) {
    front.stopped = front.stopped || result.stopped;
    if (result.design)
      found.push_back({result.design->attained.of(first_goal), result.design->attained.of(second_goal), *result.design});
    return result.design.has_value();
  };
  if (!add(run.best(limits, first_goal)) || !add(run.best(limits, second_goal))) return front;
  const bool limit_second = is_natural_limit(second) || !is_natural_limit(first);
  const double from = limit_second ? found[0].second : found[0].first;
  const double to = limit_second ? found[1].second : found[1].first;
  for (int i = 1; i + 1 < count && !front.stopped; ++i) {
    const double value = from + (to - from) * i / (count - 1);
    add(limit_second ? run.best(kept(limits, second, value), first_goal)
                     : run.best(kept(limits, first, value), second_goal));
    if (options.progress) options.progress(static_cast<double>(i) / count, "front");
  }
  for (const ParetoPoint& point : found)
    if (std::none_of(found.begin(), found.end(),
                     [&](const ParetoPoint& other) { return beats(other, point, first, second); }))
      front.points.push_back(point);
  std::stable_sort(front.points.begin(), front.points.end(), [&](const ParetoPoint& a, const ParetoPoint& b) {
    return is_maximized(first) ? a.first > b.first : a.first < b.first;
  });
  return front;
}

}  // namespace kempe
