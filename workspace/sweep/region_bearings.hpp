#pragma once
// In which directions the pole sees the region at given distances.

#include <vector>

#include "geometry/edge_tree.hpp"
#include "kinematics/stop_flag.hpp"
#include "workspace/sweep/bearings.hpp"

namespace kempe::sweep {

/// Bearings at which the region has points at distances inner .. outer from the pole (the origin): the
/// projection of a closed set is that of its boundary, and its boundary is made of the region's edges and of
/// both circles.
class RegionBearings {
 public:
  RegionBearings(const Region& region, const Point& pole) : edges_(region, pole) {}

  /// Gaps between bearings up to `gap` are filled. Once stopped, they are not all.
  std::vector<Bearings> between(double inner, double outer, double gap = 0, const StopFlag& stop = {}) const;

 private:
  void add_circle(double radius, std::vector<Bearings>& found, const StopFlag& stop) const;

  EdgeTree edges_;  ///< seen from the pole
};

}  // namespace kempe::sweep
