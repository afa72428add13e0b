#include "workspace/map/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "geometry/sector.hpp"
#include "geometry/segment_distance.hpp"
#include "workspace/grid_outline.hpp"
#include "workspace/reach.hpp"
#include "workspace/slack.hpp"

namespace kempe {
namespace {

/// Cells that meet the region are cut until there would be more of them than this.
constexpr std::size_t most_open_cells = 200'000;
/// How often all open cells are cut again to find a way between two parts of the region.
constexpr int connecting_cuts = 6;

Coverage covered() { return {true, false, {}, std::nullopt, std::nullopt, {}}; }

std::string at_text(const Point& point) {
  return fmt::format("({}, {})", fixed_text(point.x(), 2), fixed_text(point.y(), 2));
}

/// Not covered at a point, with what stands in the way there.
Coverage not_covered_at(const MapTask& task, const Point& witness) {
  const Verdict verdict = verdict_at(task, witness);
  return {false,
          !verdict.cause,
          fmt::format("The region is not covered at {}: {}.", at_text(witness), verdict.sentence),
          witness,
          verdict.cause,
          verdict.parts};
}

/// Not decided at a point: for want of time, or because it is too near to the limit.
Coverage undecided_at(const Point& open, bool stopped) {
  return {false,
          true,
          fmt::format("It cannot be decided whether the region is covered at {}: {}.", at_text(open),
                      stopped ? "stopped early" : "the gap there equals the clearance up to the resolution"),
          open,
          std::nullopt,
          {}};
}

/// A point of the region at a distance strictly between `inner` and `outer` from the pole; pole at the
/// origin.
std::optional<Point> region_point_between(const EdgeTree& region, double inner, double outer) {
  if (!(inner < outer) || region.empty()) return std::nullopt;
  std::optional<Point> found;
  const auto may_meet = [&](const Box& box) {
    if (found) return false;
    const double far = box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).norm();
    return far > inner && distance(box, {Point::Zero(), Point::Zero()}) < outer;
  };
  for_each_edge(region, may_meet, [&](const EdgeTree::Edge& edge) {
    for (int quarter = 0; quarter < 4 && !found; ++quarter) {
      const auto point = point_in({inner, outer, quarter * pi / 2, (quarter + 1) * pi / 2}, edge);
      if (point && point->norm() > inner && point->norm() < outer) found = point;
    }
  });
  const Point middle(0.5 * (inner + outer), 0);
  if (!found && std::isfinite(outer) && region.winds_around(middle)) return middle;
  return found;
}

/// The region's corner or edge point nearest to the pole and its farthest corner; pole at the origin.
struct Extremes {
  Point nearest, farthest;
};
Extremes extremes_of(const EdgeTree& region) {
  Extremes at{region.edge(0).from, region.edge(0).from};
  for_each_edge(
      region, [](const Box&) { return true; },
      [&](const EdgeTree::Edge& edge) {
        const Point near =
            edge.from + nearest_share(Point::Zero(), edge.from, edge.to) * (edge.to - edge.from);
        if (near.squaredNorm() < at.nearest.squaredNorm()) at.nearest = near;
        if (edge.from.squaredNorm() > at.farthest.squaredNorm()) at.farthest = edge.from;
      });
  return at;
}

/// A point of the region at a distance that no chart holds, table frame: the most telling one, if it can be
/// chosen.
std::optional<Point> beyond_all_charts(const MapTask& task, const std::vector<Subdivision>& charts,
                                       const EdgeTree& region) {
  const double ignored = slack::touching * reachable_annulus(task.linkage).outer;
  std::vector<Annulus> held;
  for (const Subdivision& chart : charts) held.push_back(annulus_over(task.linkage, chart.grid().openings()));
  std::sort(held.begin(), held.end(), [](const Annulus& a, const Annulus& b) { return a.inner < b.inner; });
  const Extremes extremes = extremes_of(region);
  if (!held.empty() && extremes.nearest.norm() < held.front().inner - ignored)
    return task.linkage.pole() + extremes.nearest;
  if (held.empty() || extremes.farthest.norm() > held.back().outer + ignored)
    return task.linkage.pole() + extremes.farthest;
  double inner = 0;
  for (const Annulus& annulus : held) {
    if (const auto point = region_point_between(region, inner, annulus.inner - ignored))
      return task.linkage.pole() + *point;
    inner = annulus.outer + ignored;
  }
  return std::nullopt;
}

/// The free cells that meet the region once every cell is decided; or what was found on the way there.
struct Decided {
  std::optional<Point> in_contact, open;
  std::vector<FreeCell> free;
};

Decided decide_region(const MapTask& task, const Subdivision& chart, const StopFlag& stop) {
  if (chart.region_in_contact()) return {chart.region_in_contact()->second, std::nullopt, {}};
  Subdivision cells = chart;
  cells.look_at_region_only();
  cells.lower_clearance(task.limits.clearance - slack::touching * reachable_annulus(task.linkage).outer);
  while (!cells.open().empty() && !cells.region_in_contact() && cells.open().size() < most_open_cells &&
         !stop())
    if (!cells.split(unless(stop))) break;
  Decided decided;
  if (cells.region_in_contact()) decided.in_contact = cells.region_in_contact()->second;
  for (const OpenCell& cell : cells.open())
    if ((decided.open = cells.region_point_in(cell))) break;
  decided.free = cells.free();
  return decided;
}

std::vector<GridCell> cells_of(const std::vector<FreeCell>& free) {
  std::vector<GridCell> cells;
  for (const FreeCell& one : free) cells.push_back(one.cell);
  return cells;
}

/// Points of the region in different components, table frame; one point for each component.
std::vector<Point> component_points(const AngleGrid& grid, const std::vector<FreeCell>& free,
                                    const std::vector<std::size_t>& component_of) {
  std::vector<std::size_t> seen;
  std::vector<Point> points;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (!free[i].meets_region || std::find(seen.begin(), seen.end(), component_of[i]) != seen.end()) continue;
    seen.push_back(component_of[i]);
    const GridCell& cell = free[i].cell;
    points.push_back(grid.place(cell.x + 0.5 * cell.width, cell.y + 0.5 * cell.height));
    if (points.size() == 2) break;
  }
  return points;
}

/// The first thing in the way when opening and bearing go straight from one place to another, either way
/// round.
std::optional<Verdict> between(const MapTask& task, const Point& from, const Point& to) {
  const CopyingLinkage& linkage = task.linkage;
  const Complex a = as_complex(from - linkage.pole()), b = as_complex(to - linkage.pole());
  constexpr int steps = 400;
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double radius = (1 - share) * std::abs(a) + share * std::abs(b);
    const Complex place = std::polar(radius, std::arg(a) + share * std::arg(b / a));
    const Verdict verdict = verdict_at(task, linkage.pole() + as_point(place));
    if (!verdict.free) return verdict;
  }
  return std::nullopt;
}

Coverage cut_off(const MapTask& task, const Point& one, const Point& other, bool certain) {
  Coverage coverage{false, !certain, {}, other, std::nullopt, {}};
  std::string by;
  if (const auto obstruction = between(task, one, other)) {
    coverage.cause = obstruction->cause;
    coverage.parts = obstruction->parts;
    by = fmt::format("; between them: {}", obstruction->sentence);
  }
  coverage.why_not = fmt::format("The part of the region around {} {} cut off from the part around {}{}.",
                                 at_text(other), certain ? "is" : "may be", at_text(one), by);
  return coverage;
}

/// Are two cells of the region connected if every open cell were free? Then nothing is certain.
bool connected_with_open(const Subdivision& chart, const std::vector<FreeCell>& free) {
  std::vector<GridCell> all = cells_of(free);
  for (const OpenCell& open : chart.open()) all.push_back(open.cell);
  const GridOutline outline = outline_of(all, Corners::join);
  std::vector<std::size_t> of_free(outline.component_of.begin(),
                                   outline.component_of.begin() + static_cast<std::ptrdiff_t>(free.size()));
  return component_points(chart.grid(), free, of_free).size() < 2;
}

Coverage connected(const MapTask& task, const Subdivision& chart, Decided decided, const StopFlag& stop) {
  Subdivision refined = chart;
  for (int cut = 0;; ++cut) {
    const std::vector<FreeCell>& free = decided.free;
    const auto points =
        component_points(chart.grid(), free, outline_of(cells_of(free), Corners::part).component_of);
    if (points.size() < 2) return covered();
    if (cut == connecting_cuts || refined.open().size() > most_open_cells || stop())
      return cut_off(task, points[0], points[1], !connected_with_open(refined, free));
    refined.split(unless(stop));
    decided = decide_region(task, refined, stop);
    if (decided.in_contact || decided.open) return cut_off(task, points[0], points[1], false);
  }
}

}  // namespace

Coverage coverage_of(const MapTask& task, const std::vector<Subdivision>& charts, const EdgeTree& region,
                     const StopFlag& stop) {
  if (region.empty()) return covered();
  if (region.winds_around(Point::Zero()))
    return {false,
            false,
            "The region holds the pole, which the tracer cannot reach.",
            task.linkage.pole(),
            Cause::out_of_reach,
            {}};
  if (const auto point = beyond_all_charts(task, charts, region)) return not_covered_at(task, *point);
  std::vector<Decided> decided;
  std::optional<Point> open;
  for (const Subdivision& chart : charts) {
    decided.push_back(decide_region(task, chart, stop));
    if (decided.back().in_contact) return not_covered_at(task, *decided.back().in_contact);
    if (decided.back().open) open = decided.back().open;
  }
  if (open) return undecided_at(*open, stop());
  std::optional<Point> first;
  std::optional<Coverage> result;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const auto of_chart = component_points(charts[i].grid(), decided[i].free,
                                           std::vector<std::size_t>(decided[i].free.size(), 0));
    if (of_chart.empty()) continue;
    if (first) return cut_off(task, *first, of_chart.front(), true);  // another interval of openings
    first = of_chart.front();
    result = connected(task, charts[i], decided[i], stop);
  }
  return result.value_or(covered());
}

}  // namespace kempe
