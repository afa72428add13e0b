#pragma once
// Which link lies in which layer: every assignment tried, the best by clearance, and why fewer layers would
// not do.

#include <string>
#include <vector>

#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// One assignment and the smallest gap it has while the tracer covers the region.
struct LayerFinding {
  LayerAssignment layers;
  double gap = 0;            ///< mm; an upper bound where `compared` is false
  std::string parts;         ///< the two that come so near
  Point at = Point::Zero();  ///< the tracer's place there
  bool keeps_clearance = false;
  /// rad, widest interval of usable openings without contact of the links themselves
  double free_opening = 0;
  /// False: of as many layers another is clearly better, for the links alone or by a gap met on the way; then not all was looked at
  bool compared = true;
};

struct LayerChoice {
  LayerAssignment best;
  /// Of the assignments looked at, the best first: largest gap, then fewer layers.
  std::vector<LayerFinding> findings;
  /// Sentences for a person, one for each number of layers below the best's: what two parts would do there. One more
  /// where the best leaves a layer empty: what they would do with as many layers and links in all. Empty if the best
  /// has two layers.
  std::vector<std::string> why_not_fewer;
};

/// Tries every assignment to at most `layers` layers (>= 2) for the task; with empty layers only those that no lower one replaces
/// (layer_demands.hpp). The task's own layers are looked at first: where they are good, the others need less time.
/// Without a region, or where the assembly mode reaches none of it, the gap is that over all openings that keep
/// the transmission limit. Deterministic: equal gaps are ranked by the number of layers, then in the order of
/// layer_assignments(). Stopped early, the best of those tried so far, at least one.
LayerChoice choose_layers(const MapTask& task, int layers, const StopFlag& stop = {});

}  // namespace kempe
