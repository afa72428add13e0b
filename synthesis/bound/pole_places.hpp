#pragma once
// Where the pole may stand, and how far the region is from there: for boxes of places and for single ones.

#include <optional>
#include <vector>

#include "geometry/region.hpp"
#include "synthesis/bound/copy_gap.hpp"
#include "synthesis/bound/tree_node.hpp"

namespace kempe::bounding {

/// The upright box of all places where a pole may stand, mm.
Box box_of_places(const PoleSpec& pole);

/// The pole's places of a spec. The spec must outlive it.
class PolePlaces {
 public:
  /// With `posts` the posts of pole, tracer and pen keep the clearance.
  PolePlaces(const Spec& spec, bool posts);

  /// Sets the node's x and y to the box of all places.
  void plant(TreeNode& root) const;
  /// Measures the distances over the places in the node's box; false if the pole cannot stand in it.
  bool measure(TreeNode& node) const;
  /// The same, whatever the gap between original and copy.
  bool measure_distances(TreeNode& node) const;
  /// The places of the region that are nearest to the pole and farthest from it.
  ReachedPlaces ends_from(const Point& pole) const;
  /// The region's distances from one place, mm; nothing if the pole cannot stand there.
  std::optional<DistanceRange> distances_from(const Point& pole) const;

 private:
  const Point& farthest_corner(const Range& x, const Range& y) const;

  const Spec& spec_;
  RegionReach region_;
  std::optional<RegionReach> area_;
  std::vector<Point> corners_;  // of the region's hull, so many as are worth looking at
  CopyGap copy_gap_;
  double least_radius_ = 0;    // mm: nearer to the pole the posts would touch
  double place_rounding_ = 0;  // mm: how far places of region and pole may be off
};

}  // namespace kempe::bounding
