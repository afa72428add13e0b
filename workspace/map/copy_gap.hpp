#pragma once
// Original and copy lie on one table: do they keep their distance?

#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// What is wrong if the region and its copy are nearer than the task's copy_gap; nothing if they keep it or
/// none is asked for. Exact for the corners as doubles; it depends on the ratio, the pole and the region
/// alone.
struct CopyOverlap {
  std::string sentence;  ///< with figures
  Point at;              ///< the region's place nearest to the copy, or in it
  /// The part of the region nearer to the copy than the gap; empty for very large regions, and where left out.
  ArcRegion area;
};
/// The area takes exact Boolean operations: up to some seconds.
enum class OverlapArea { wanted, left_out };
std::optional<CopyOverlap> copy_overlap(const MapTask& task, OverlapArea area);

}  // namespace kempe
