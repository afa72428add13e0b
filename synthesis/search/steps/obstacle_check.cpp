#include "synthesis/search/steps/obstacle_check.hpp"

#include "workspace/contact/clearance.hpp"
#include "workspace/map/coverage.hpp"

namespace kempe {

ObstacleCheck check_obstacles(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                              const LayerAssignment& layers, const OpeningInterval& certified_opening,
                              const StopFlag& stop) {
  MapTask task = map_task(linkage, layers, spec);
  task.limits = limits;
  task.limits.copy_gap.reset();  // not the obstacles' matter
  const PreparedTask prepared(task);
  if (obstacle_within(task.limits.clearance, prepared.at_pole)) return {};
  ObstacleCheck check;
  if (const auto figure = smallest_clearance(prepared, stop)) {
    check.clearance = figure->gap;
    if (figure->gap < limits.clearance) {
      check.witness = figure->at;
      return check;
    }
  }
  const Encounters encounters = prepared.scene.nearer_than(limits.clearance);
  std::vector<Subdivision> charts;
  charts.emplace_back(prepared.scene, encounters, prepared.region, AngleGrid(linkage, certified_opening),
                      limits.clearance, SubdivisionMode{.region_only = true});
  const Coverage coverage = coverage_of(task, charts, prepared.region, stop);
  check.clear = coverage.covered;
  check.witness = coverage.witness;
  return check;
}

}  // namespace kempe
