#pragma once
// What stands at pole, tracer or pen alone: a post, a pin, the point of a body that keeps its direction. The copy says where it is, whatever
// the lengths are, seen from the table or from another of the three points: a fixed multiple of the tracer's place from the pole. So
// its smallest gap to an obstruction over the region is the distance between an image of the region and the obstruction, exact up to
// rounding, where cells of angles would have to be as small as the figure is fine all along an edge of the region.

#include <optional>

#include "kinematics/stop_flag.hpp"
#include "workspace/contact/prepared_task.hpp"

namespace kempe {

/// A gap and where it is.
struct PointGap {
  double gap;  ///< mm; as ObstacleGap's
  Encounter between;
  Point at;  ///< the tracer's place, in the region
};

struct CopyContacts {
  std::optional<PointGap>
      smallest{};       ///< of those that the copy decides about; absent: none is below what was asked
  Encounters others{};  ///< those that it says nothing about, and once stopped those not yet looked at
};

/// Divides some of a scene's encounters. Gaps of `below` (mm) and more are not told; of those nearer to each other than `alike` (mm) the
/// first is named. The linkage must reach the whole region, which is not empty.
CopyContacts copy_contacts(const PreparedTask& prepared, const Encounters& encounters, double below,
                           double alike, const StopFlag& stop = {});

}  // namespace kempe
