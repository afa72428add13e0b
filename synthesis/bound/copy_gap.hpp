#pragma once
// The gap between original and copy over a box of poles.

#include <optional>
#include <vector>

#include "geometry/region_reach.hpp"
#include "specs/spec.hpp"
#include "synthesis/bound/copy_distance.hpp"

namespace kempe::bounding {

/// Where the gap is looked at: some places of the region. The copy's distance from the region at a pole
/// is at most the least of their images' distances (copy_distance.hpp). "Too near" is said with directed rounding alone; "far enough"
/// only saves work.
/// `region` must outlive it.
class CopyGap {
 public:
  CopyGap(const Spec& spec, const RegionReach& region);

  enum class Verdict { too_near, undecided, far_enough };

  /// Whether original and copy come too near for every pole within `radius` of `pole`, or for none (as far as
  /// the places tell).
  Verdict verdict(const Point& pole, double radius) const;

 private:
  PlaceOnSegment place_near(const Point& to, const RegionReach::Nearest& nearest) const;

  const RegionReach& region_;
  Complex k_;
  std::optional<double> gap_;
  double extent_;  ///< mm: the region's farthest corner from the frame's origin
  std::vector<Point> places_;
};

}  // namespace kempe::bounding
