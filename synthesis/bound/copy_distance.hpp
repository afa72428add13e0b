#pragma once
// How far the copy of a place is from a place, with directed rounding.

#include "geometry/complex_vectors.hpp"
#include "geometry/region_reach.hpp"

namespace kempe::bounding {

/// The place from + share (to - from), 0 <= share <= 1, itself: not the double next to it.
struct PlaceOnSegment {
  Point from, to;
  double share = 0;
};
inline PlaceOnSegment exactly_at(const Point& place) { return {place, place, 0}; }

/// Upper bound of the distance of the copy of `copied` (pole + k (copied - pole), k known to a few units in its last place) from
/// `other`, for every pole within `radius` of `pole`, mm. It changes by no more than |1 - k| per mm of the pole's way.
double copy_distance_at_most(Complex k, const PlaceOnSegment& copied, const PlaceOnSegment& other,
                             const Point& pole, double radius);

/// Whether the copy of `copied` lies inside the region for every pole within `radius` of `pole`, k known to a few units in its last
/// place. True is proven: exactly which side of all edges it lies on, and with directed rounding that it comes to none of them.
bool copy_surely_inside(Complex k, const Point& copied, const RegionReach& region, const Point& pole,
                        double radius);

}  // namespace kempe::bounding
