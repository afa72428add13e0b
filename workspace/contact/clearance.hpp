#pragma once
// The smallest gap while the tracer covers the region.

#include "kinematics/stop_flag.hpp"
#include "workspace/contact/prepared_task.hpp"

namespace kempe {

struct ClearanceFigure {
  double gap = 0;            ///< mm; attained at `at`
  std::string parts;         ///< "link VA and obstacle 2"
  Point at = Point::Zero();  ///< the tracer's place, in the region
  bool certified = false;    ///< no point of the region has a gap smaller by more than 0.01 mm
};

/// The smallest gap of any two parts, or of a part and an obstacle, a body or the table's edge, over the region; openings at which the
/// assembly mode does not exist are left out. Self-contact in closed form, obstacles by branch and bound over the
/// two angles. Nothing if the region is empty or nowhere reachable. A gap is at least minus the half widths:
/// the depth of axes that cross is not measured. Stopped early, the smallest gap met so far comes back, not certified; so does the first of an
/// obstruction that is below `enough`.
std::optional<ClearanceFigure> smallest_clearance(const PreparedTask& task, const StopFlag& stop = {},
                                                  double enough = -infinity);
std::optional<ClearanceFigure> smallest_clearance(const MapTask& task, const StopFlag& stop = {},
                                                  double enough = -infinity);

/// The same of moving parts and obstructions (obstructions.hpp) alone.
struct ObstacleClearance {
  ClearanceFigure figure;  ///< without parts where none come nearer than `within`
  double proven = 0;  ///< mm: no gap is smaller, `within` at most; -infinity if the figure is not certified
};
/// Gaps above `within` (mm) are not looked for. The region must be reachable and not empty.
ObstacleClearance obstacle_clearance(const MapTask& task, double within, const StopFlag& stop = {});

}  // namespace kempe
