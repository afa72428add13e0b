#pragma once
// A linkage with its parts and its surroundings: what is mapped.

#include <optional>
#include <vector>

#include "specs/spec.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// What is mapped: a linkage with its parts, and what it must respect.
struct MapTask {
  CopyingLinkage linkage;
  LinkStyle style;
  LayerAssignment layers;
  double clearance = 0;     ///< mm
  double transmission = 0;  ///< rad
  std::vector<Obstacle> obstacles{};
  Region region{};                     ///< what must be covered; may be empty
  std::optional<double> sheets_gap{};  ///< mm
};

/// Of the limits those that a map respects.
MapTask map_task(const CopyingLinkage& linkage, const LinkStyle& style, const LayerAssignment& layers,
                 const Limits& limits, const std::vector<Obstacle>& obstacles, const Region& region);

}  // namespace kempe
