#pragma once
// Obstacles, certified: is the region covered with all of them in place?

#include <optional>

#include "kinematics/stop_flag.hpp"
#include "synthesis/problem/requirements.hpp"

namespace kempe {

/// Whether the tracer covers the whole region, in one component, with every part clear of every obstacle. Certain, not
/// sampled (workspace/map/coverage.hpp). If not, `witness` is a place of the region where it fails, the tightest one where
/// there is one. Stopped early: not clear unless that was certain already.
struct ObstacleCheck {
  bool clear = false;
  std::optional<Point> witness{};
  /// mm, the smallest gap of any parts or obstacle over the region, or the limit that it keeps
  double clearance = 0;
};
/// Whether the smallest gap of a design that is clear is measured, which takes several times as long, or told as the limit that
/// it keeps.
enum class SmallestGap { measured, as_limit };
ObstacleCheck check_obstacles(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                              const LayerAssignment& layers, const OpeningInterval& certified_opening,
                              const StopFlag& stop = {}, SmallestGap gap = SmallestGap::measured);

}  // namespace kempe
