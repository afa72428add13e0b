#include "synthesis/search/steps/obstacle_check.hpp"

#include "workspace/contact/clearance.hpp"
#include "workspace/map/coverage.hpp"

namespace kempe {

namespace {

/// Does one component of the free cells hold the region, at the clearance limit?
Coverage covered_among_obstacles(const PreparedTask& prepared, const OpeningInterval& certified_opening,
                                 const StopFlag& stop) {
  const double clearance = prepared.task.limits.clearance;
  const Encounters encounters = prepared.scene.nearer_than(clearance);
  std::vector<Subdivision> charts;
  charts.emplace_back(prepared.scene, encounters, prepared.region,
                      AngleGrid(prepared.task.linkage, certified_opening), clearance,
                      SubdivisionMode{.region_only = true});
  return coverage_of(prepared.task, charts, prepared.region, stop);
}

}  // namespace

ObstacleCheck check_obstacles(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                              const LayerAssignment& layers, const OpeningInterval& certified_opening,
                              const StopFlag& stop, SmallestGap gap) {
  MapTask task = map_task(linkage, layers, spec);
  task.limits = limits;
  task.limits.copy_gap.reset();  // not the obstacles' matter
  const PreparedTask prepared(task);
  if (obstacle_within(task.limits.clearance, prepared.at_pole)) return {};
  std::optional<Coverage> coverage;
  if (gap == SmallestGap::as_limit) {
    coverage = covered_among_obstacles(prepared, certified_opening, stop);
    if (coverage->covered) return {.clear = true, .clearance = limits.clearance};
  }
  ObstacleCheck check;
  if (const auto figure = smallest_clearance(prepared, stop)) {
    check.clearance = figure->gap;
    if (figure->gap < limits.clearance) {
      check.witness = figure->at;
      return check;
    }
  }
  if (!coverage) coverage = covered_among_obstacles(prepared, certified_opening, stop);
  check.clear = coverage->covered;
  check.witness = coverage->witness;
  return check;
}

}  // namespace kempe
