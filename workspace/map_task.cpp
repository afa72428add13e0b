#include "workspace/map_task.hpp"

namespace kempe {

MapTask map_task(const CopyingLinkage& linkage, const LinkStyle& style, const LayerAssignment& layers,
                 const Limits& limits, const std::vector<Obstacle>& obstacles, const Region& region) {
  return {.linkage = linkage,
          .style = style,
          .layers = layers,
          .clearance = limits.clearance,
          .transmission = limits.transmission,
          .obstacles = obstacles,
          .region = region,
          .sheets_gap = limits.sheets_gap};
}

}  // namespace kempe
