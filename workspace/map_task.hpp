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
  /// Of these the map respects clearance, transmission and the gap between original and copy.
  Limits limits{.clearance = 0, .transmission = 0};
  std::vector<Obstacle> obstacles{};
  std::vector<Body> bodies{};
  std::optional<Polygon> table{};
  Region region{};  ///< what must be covered; may be empty
};

/// True if anything but the linkage itself can be in its way.
bool has_obstructions(const MapTask& task);

/// Of a spec what a map respects, for a linkage in the given layers.
MapTask map_task(const CopyingLinkage& linkage, const LayerAssignment& layers, const Spec& spec);

}  // namespace kempe
