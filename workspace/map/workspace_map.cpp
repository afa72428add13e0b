#include "workspace/map/workspace_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/regions/region_algebra.hpp"
#include "workspace/cell_polygons.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/map/copy_gap.hpp"
#include "workspace/map/coverage.hpp"
#include "workspace/map/largest_sheet.hpp"
#include "workspace/map/losses.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// Cells are cut until there would be more than this, whatever the tolerance asks: about 400 MB of lists.
constexpr std::size_t most_map_cells = 1'000'000;
/// Where hardly anything is free the open band is measured against this share of the interval's area.
constexpr double least_share = 0.01;

void append(ArcRegion& region, ArcRegion more) {
  region.insert(region.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Shares of the work done after the smallest clearance, the refinement and the coverage; what is left is for the sheets.
constexpr double after_clearance = 0.15, after_refinement = 0.75, after_coverage = 0.9;

void tell(const MapOptions& options, double share) {
  if (options.progress) options.progress(share);
}

/// Each refinement halves the open band, so its logarithm tells how much is left. `open`: as a share of what is free.
void tell_refinement(const MapOptions& options, double open, double& widest) {
  widest = std::max(widest, open);
  const double left = open > options.map_tolerance && widest > options.map_tolerance
                          ? std::log(open / options.map_tolerance) / std::log(widest / options.map_tolerance)
                          : 0;
  tell(options, std::lerp(after_refinement, after_clearance, std::clamp(left, 0.0, 1.0)));
}

/// Refines all charts until the open band is within the tolerance.
void refine(std::vector<Subdivision>& charts, const MapOptions& options) {
  const StopFlag& stop = options.stop;
  double whole = 0, widest_open = 0;
  for (const Subdivision& chart : charts)
    whole += chart.grid().area({0, 0, AngleGrid::turn, AngleGrid::rise});
  while (!stop()) {
    double open_area = 0, free_area = 0;
    std::size_t cells = 0;
    for (const Subdivision& chart : charts) {
      open_area += chart.open_area();
      free_area += chart.free_area();
      cells += chart.open().size();
    }
    const double of = std::max(free_area, least_share * whole);
    if (cells == 0 || cells > most_map_cells || open_area <= options.map_tolerance * of) return;
    tell_refinement(options, open_area / of, widest_open);
    bool any = false;
    for (Subdivision& chart : charts) any = chart.split(unless(stop)) || any;
    if (!any) return;
  }
}

void add_cells(WorkspaceMap& map, const ContactScene& scene, const Subdivision& chart) {
  std::vector<GridCell> free, open;
  for (const FreeCell& one : chart.free()) free.push_back(one.cell);
  for (const OpenCell& one : chart.open()) open.push_back(one.cell);
  append(map.collision_free, polygons_of(chart.grid(), free, Corners::part));
  append(map.uncertain, polygons_of(chart.grid(), open, Corners::join));
  std::map<std::pair<std::size_t, std::string_view>, std::vector<GridCell>> lost;
  for (const ContactCell& one : chart.contact())
    lost[{one.between.obstacle, scene.piece_name(one.between)}].push_back(one.cell);
  for (const auto& [between, cells] : lost)
    map.lost.push_back({Cause::obstacle_contact,
                        {std::string(between.second), scene.obstacles[between.first].name},
                        polygons_of(chart.grid(), cells, Corners::join)});
}

/// rad: openings so near to each other are one.
constexpr double same_opening = 1e-8;

/// The openings of `within` that are not in `free`, which rises, each with a pair in contact there.
std::vector<ContactOpenings> lost_openings(const MapTask& task, const std::vector<FreeOpenings>& free,
                                           const OpeningInterval& within) {
  std::vector<OpeningInterval> gaps;
  double decided = within.lower;
  const auto add_gap = [&](double to) {
    if (decided < to) gaps.push_back({decided, to});
  };
  for (const FreeOpenings& one : free) {
    add_gap(one.interval.lower);
    decided = one.interval.upper;
  }
  add_gap(within.upper);
  if (gaps.empty()) return {};
  const auto contacts =
      contact_openings(task.linkage, task.style, task.layers, task.limits.clearance, within);
  std::vector<ContactOpenings> lost;
  for (auto [from, to] : gaps)  // each by as few contacts as the sorted list needs
    while (from < to) {
      const ContactOpenings* best = nullptr;
      for (const ContactOpenings& one : contacts)
        if (one.interval.lower <= from + same_opening && (!best || one.interval.upper > best->interval.upper))
          best = &one;
      if (!best) break;
      const double end = best->interval.upper > from ? std::min(best->interval.upper, to) : to;
      lost.push_back({{from, to - end < same_opening ? to : end}, best->pair});
      from = lost.back().interval.upper;
    }
  return lost;
}

/// Slivers of rounding are no lost area.
constexpr double sliver = 1e-12;

void add_lost(WorkspaceMap& map, Cause cause, std::vector<std::string> parts, ArcRegion area_lost) {
  if (area(area_lost) > sliver * area(map.reachable))
    map.lost.push_back({cause, std::move(parts), std::move(area_lost)});
}

/// Exact Boolean operations on more corners than this would take seconds.
constexpr std::size_t most_corners = 20'000;

/// The part of the region beyond the outer reach: the plane there is lost too, but it has no end.
ArcRegion region_beyond(const MapTask& task, const Annulus& chain) {
  std::size_t corners = 0;
  for (const Polygon& polygon : task.region.polygons) {
    corners += polygon.outer.size();
    for (const Ring& hole : polygon.holes) corners += hole.size();
  }
  if (corners == 0 || corners > most_corners ||
      distance_range(task.region, chain.centre).farthest <= chain.outer)
    return {};
  return difference(as_arcs(task.region), as_region({chain.centre, 0, chain.outer}));
}

/// What is lost whatever the bearing: annuli.
void add_lost_annuli(WorkspaceMap& map, const MapTask& task, const std::vector<FreeOpenings>& free) {
  const Annulus chain = chain_annulus(task.linkage), reach = reachable_annulus(task.linkage);
  const Annulus usable = usable_annulus(task.linkage, task.limits.transmission);
  ArcRegion unreachable = as_region({chain.centre, 0, chain.inner});
  append(unreachable, region_beyond(task, chain));
  add_lost(map, Cause::out_of_reach, {}, std::move(unreachable));
  add_lost(map, Cause::beyond_change_point, {}, difference(chain, reach));
  add_lost(map, Cause::transmission_below_limit, {}, difference(reach, usable));
  const OpeningInterval within = task.linkage.openings_with_transmission(task.limits.transmission);
  if (within.empty()) return;
  for (const ContactOpenings& one : lost_openings(task, free, within))
    add_lost(map, Cause::self_contact, {name(one.pair.first), name(one.pair.second)},
             as_region(annulus_over(task.linkage, one.interval)));
}

/// The interval that holds most of the region's openings: a design that is best at a contact holds all of
/// them but for rounding. The widest where none holds any.
OpeningInterval certified(const MapTask& task, const std::vector<FreeOpenings>& free) {
  const auto needed = openings_over(task.linkage, task.region);
  std::vector<OpeningInterval> intervals, held;
  for (const FreeOpenings& one : free) {
    intervals.push_back(one.interval);
    held.push_back(needed ? intersect(one.interval, *needed) : OpeningInterval{});
  }
  const auto most = std::max_element(held.begin(), held.end(),
                                     [](const auto& a, const auto& b) { return a.width() < b.width(); });
  if (most != held.end() && most->width() > 0)
    return intervals[static_cast<std::size_t>(most - held.begin())];
  return widest(intervals).value_or(OpeningInterval{});
}

/// Nothing is free while an obstacle stands at the pole post.
void lose_all_to(WorkspaceMap& map, const MapTask& task, const std::string& obstacle) {
  const std::string post = std::string("pole post ") + letter(task.linkage.pole_joint());
  ArcRegion area = as_region(annulus_over(task.linkage, map.certified_opening));
  add_lost(map, Cause::obstacle_contact, {post, obstacle}, std::move(area));
  map.coverage = {false,
                  false,
                  "The " + post + " stands in " + obstacle +
                      " or within its clearance: no position of the linkage is free.",
                  task.linkage.pole(),
                  Cause::obstacle_contact,
                  {post, obstacle}};
}

void add_losses(WorkspaceMap& map, const Region& region) {
  map.coverage.losses = region_losses(map.lost, region);
  if (const std::string sentence = losses_sentence(map.coverage.losses); !sentence.empty())
    map.coverage.why_not += " " + sentence;
}

/// Sheets that overlap are a fault of the region and the pole, wherever the linkage can go.
void add_copy_overlap(WorkspaceMap& map, const MapTask& task, const StopFlag& stop) {
  auto overlap = copy_overlap(task, stop() ? OverlapArea::left_out : OverlapArea::wanted);
  if (!overlap) return;
  add_lost(map, Cause::copy_overlap, {}, std::move(overlap->area));
  if (map.coverage.covered)
    map.coverage = {false,
                    false,
                    "The region cannot be copied on this table: " + overlap->sentence + ".",
                    overlap->at,
                    Cause::copy_overlap,
                    {}};
}

}  // namespace

WorkspaceMap map_workspace(const MapTask& task, const MapOptions& options) {
  WorkspaceMap map;
  map.map_tolerance = options.map_tolerance;
  map.reachable = as_region(reachable_annulus(task.linkage));
  map.usable = as_region(usable_annulus(task.linkage, task.limits.transmission));
  const auto free = contact_free_openings(task.linkage, task.style, task.layers, task.limits.clearance,
                                          task.linkage.openings_with_transmission(task.limits.transmission));
  map.certified_opening = certified(task, free);
  add_lost_annuli(map, task, free);
  tell(options, 0);
  map.clearance_min = HUGE_VAL;
  const PreparedTask prepared(task);
  const auto clearance = smallest_clearance(prepared, options.stop);
  if (clearance && (clearance->certified || !options.stop())) {
    map.clearance_min = clearance->gap;
    map.clearance_min_parts = clearance->parts;
    map.clearance_min_at = clearance->at;
  }
  if (const auto obstacle = obstacle_within(task.limits.clearance, prepared.at_pole)) {
    lose_all_to(map, task, *obstacle);
    return map;
  }
  const Encounters encounters = prepared.scene.nearer_than(task.limits.clearance);
  std::vector<Subdivision> charts;
  for (const FreeOpenings& one : free)
    charts.emplace_back(prepared.scene, encounters, prepared.region, AngleGrid(task.linkage, one.interval),
                        task.limits.clearance);
  tell(options, after_clearance);
  refine(charts, options);
  tell(options, after_refinement);
  for (const Subdivision& chart : charts) add_cells(map, prepared.scene, chart);
  map.coverage = coverage_of(task, charts, prepared.region, options.stop);
  if (!map.coverage.covered && !options.stop()) add_losses(map, task.region);
  add_copy_overlap(map, task, options.stop);
  map.complete = !options.stop();
  tell(options, after_coverage);
  if (options.largest_sheets && map.complete)
    map.largest_sheets = largest_sheets(map.collision_free, task.region, options.stop, options.threads);
  if (options.largest_sheets && options.stop()) {  // what was found by then need not be the largest
    map.largest_sheets.clear();
    map.complete = false;
  }
  tell(options, 1);
  return map;
}

}  // namespace kempe
