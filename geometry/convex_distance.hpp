#pragma once
// Signed distance of two convex sets of few corners, with the features that decide it.
//
// Apart: the smallest distance of a corner of one from the other. Overlapping: minus the smallest shift that
// parts them; it is along the normal of an edge of one of them, because the Minkowski difference has the
// edges of both (separating axes). Either way the distance is |corner - corner| or the height of a corner
// over an edge's line.

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/complex_vectors.hpp"

namespace kempe {

/// A point, a segment, or a convex polygon in either direction.
using ConvexCorners = std::span<const Complex>;

struct NearestFeatures {
  double distance = 0;          ///< mm, negative: depth of overlap
  bool corner_of_first = true;  ///< which set has the corner; the other has the edge (or the other corner)
  std::size_t corner = 0;
  std::size_t from = 0;  ///< the edge's start, or the other corner
  std::size_t to = 0;    ///< the edge's end
  bool is_edge = false;
  double side = 1;  ///< distance = side * (to - from) x (corner - from) / |to - from|
};

NearestFeatures nearest_features(ConvexCorners first, ConvexCorners second);

/// nearest_features(first, second).distance to the last bit, and quicker. Where that is larger than `enough`, mm, a number above `enough`
/// that is no larger than the distance but for rounding.
double convex_distance(ConvexCorners first, ConvexCorners second, double enough = infinity);

/// A convex set that stays where it is, with the directions of its edges, which are worked out once.
class FixedConvex {
 public:
  explicit FixedConvex(std::vector<Complex> corners);
  const std::vector<Complex>& corners() const { return corners_; }
  /// Of each edge, of size 1; 0 for an edge without a length.
  const std::vector<Complex>& directions() const { return directions_; }
  /// Of its edges, the side on which the set does not lie: 1 left, -1 right; 0 for a segment, which has two free sides.
  double free_side() const { return free_side_; }

 private:
  std::vector<Complex> corners_, directions_;
  double free_side_;
};

/// As for two sets, several times as quick where the distance is beyond `enough`.
double convex_distance(ConvexCorners moving, const FixedConvex& fixed, double enough = infinity);

/// The distance of a point alone, without the features; as nearest_features({&point, 1}, set).distance but for rounding, and
/// several times as quick.
double distance_from(Complex point, ConvexCorners set);

}  // namespace kempe
