#include "synthesis/search/pareto.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "synthesis/problem/local_frame.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/diagnosis/diagnosis.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"
#include "synthesis/search/section_search.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "workspace/footprint.hpp"

namespace kempe {
namespace {

/// A copy of `value` that a design with exactly this value still keeps.
double slackened(Objective objective, double value) {
  return value * (is_maximized(objective) ? 1 - slack::same_value : 1 + slack::same_value);
}

double value_of(const Spec& spec, const FoundDesign& design, Objective objective) {
  if (objective == Objective::footprint && design.attained.footprint == 0)
    return footprint(design.linkage, spec.links.style, spec.region).area;
  return design.attained.of(goal_of(objective));
}

bool is_no_worse(Objective objective, double one, double other) {
  return is_maximized(objective) ? one >= other * (1 - slack::same_value)
                                 : one <= other * (1 + slack::same_value);
}

/// Without those that another beats in one and equals in the other, in the order of `a`.
std::vector<ParetoPoint> undominated(std::vector<ParetoPoint> points, Objective a, Objective b) {
  std::vector<ParetoPoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < points.size() && !beaten; ++j) {
      const bool as_good =
          is_no_worse(a, points[j].a, points[i].a) && is_no_worse(b, points[j].b, points[i].b);
      const bool equal = is_no_worse(a, points[i].a, points[j].a) && is_no_worse(b, points[i].b, points[j].b);
      beaten = j != i && as_good && (!equal || j < i);
    }
    if (!beaten) kept.push_back(points[i]);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const ParetoPoint& x, const ParetoPoint& y) { return x.a < y.a; });
  return kept;
}

using Front = tl::expected<std::vector<ParetoPoint>, NoDesign>;

/// `origin`: of the spec's coordinates, on the table.
Front front_here(const Spec& spec, const Point& origin, Objective a, Objective b, int points,
                 const SearchOptions& options) {
  const SearchTask task = pose(spec, SearchControl(options));
  const Requirements& limits = task.limits;
  // The footprint is the one that is hard to limit: then the other is limited.
  const Objective limited_one = a == Objective::footprint ? b : a, other = a == Objective::footprint ? a : b;
  std::vector<ParetoPoint> found;
  const auto add = [&](const SearchResult& result) {
    if (result.design)
      found.push_back({value_of(spec, *result.design, a), value_of(spec, *result.design, b), *result.design});
    return result.design.has_value();
  };
  const auto limited_value = [&](const ParetoPoint& point) { return limited_one == a ? point.a : point.b; };
  SearchResult first = best_design(task.with(goal_of(limited_one)));
  if (!first.design && first.stopped && !first.proven_none) return found;
  if (!first.design) {
    Diagnosis diagnosis = diagnose(task, first, origin);
    if (!diagnosis.permitted || first.proven_none) return tl::unexpected(std::move(diagnosis.none));
    first.design = std::move(diagnosis.permitted);
  }
  const double from = value_of(spec, *first.design, limited_one);
  add(best_design(
      task.with(with_limit(limits, goal_of(limited_one), slackened(limited_one, from)), goal_of(other))));
  if (found.empty()) add(first);
  if (task.stopped() || !add(best_design(task.with(goal_of(other))))) return found;
  const double to = limited_value(found.back());
  const int steps = std::max(2, points) - 1;
  for (int i = 1; i < steps && !task.stopped(); ++i) {
    if (options.progress) options.progress(static_cast<double>(i) / steps, "front");
    // Even steps in the logarithm: both ends may differ by much.
    const double at = from * std::pow(to / from, static_cast<double>(i) / steps);
    add(best_design(task.with(with_limit(limits, goal_of(limited_one), at), goal_of(other))));
  }
  return undominated(std::move(found), a, b);
}

/// Of bounds and proofs what claim_no_more() leaves. Of one section.
Front front_of(const Spec& spec, Objective a, Objective b, int points, const SearchOptions& options) {
  if (auto none = plainly_impossible(spec, options.unit)) return tl::unexpected(*std::move(none));
  const Point origin = local_origin(spec);
  if (origin.isZero(0)) return front_here(spec, origin, a, b, points, options);
  Front front = front_here(shifted(spec, -origin), origin, a, b, points, options);
  if (!front) return tl::unexpected(shifted(std::move(front.error()), origin));
  for (ParetoPoint& point : *front) point.design = shifted(point.design, origin);
  return front;
}

}  // namespace

namespace {

/// The front of each section, and of all of them what no other design beats.
Front front_of_sections(const Spec& spec, Objective a, Objective b, int points,
                        const SearchOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<ParetoPoint> all;
  std::optional<NoDesign> none;
  bool proven = true, any_front = false;  // the front of a section that was stopped is empty
  const std::size_t count = spec.links.sections.size();
  for (std::size_t i = 0; i < count; ++i) {
    const LinkSection& section = spec.links.sections[i];
    SearchOptions part = options;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    part.time_limit = std::max(0.0, options.time_limit - spent.count()) / static_cast<double>(count - i);
    part.diagnose = options.diagnose && i + 1 == count && all.empty();
    Front front = front_of(with_section(spec, section), a, b, points, part);
    if (front) {
      any_front = true;
      for (ParetoPoint& point : *front) {
        point.design.section = section;
        all.push_back(std::move(point));
      }
      continue;
    }
    proven = proven && front.error().proven;
    for (Relaxation& relaxation : front.error().relaxations) relaxation.design.section = section;
    none = std::move(front.error());
  }
  if (any_front || !none) return undominated(std::move(all), a, b);
  none->proven = proven;
  none->sentence = of_no_section(spec, options.unit, none->sentence);
  return tl::unexpected(*std::move(none));
}

}  // namespace

Front pareto_front(const Spec& spec, Objective a, Objective b, int points, const SearchOptions& options) {
  Front front = spec.links.sections.size() > 1 ? front_of_sections(spec, a, b, points, options)
                                               : front_of(spec, a, b, points, options);
  if (!front) claim_no_more(front.error(), spec.links.hardware);
  if (front)
    for (ParetoPoint& point : *front) claim_no_more(point.design, spec.links.hardware);
  return front;
}

}  // namespace kempe
