#include "workspace/map_task.hpp"

namespace kempe {

bool has_obstructions(const MapTask& task) {
  return !task.obstacles.empty() || !task.bodies.empty() || task.table.has_value();
}

MapTask map_task(const CopyingLinkage& linkage, const LayerAssignment& layers, const Spec& spec) {
  return {.linkage = linkage,
          .style = spec.links.style,
          .layers = layers,
          .clearance = spec.limits.clearance,
          .transmission = spec.limits.transmission,
          .obstacles = spec.obstacles,
          .bodies = spec.bodies,
          .table = spec.table,
          .region = spec.region,
          .copy_gap = spec.limits.copy_gap};
}

}  // namespace kempe
