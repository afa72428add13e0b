#include "workspace/map_task.hpp"

namespace kempe {

bool has_obstructions(const MapTask& task) {
  return !task.obstacles.empty() || !task.bodies.empty() || task.table.has_value();
}

MapTask map_task(const CopyingLinkage& linkage, const LayerAssignment& layers, const Spec& spec) {
  return {.linkage = linkage,
          .style = spec.links.style,
          .layers = layers,
          .limits = spec.limits,
          .obstacles = spec.obstacles,
          .bodies = spec.bodies,
          .table = spec.table,
          .region = spec.region};
}

}  // namespace kempe
