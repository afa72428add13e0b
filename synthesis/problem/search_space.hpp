#pragma once
// What every choice of a spec shares: the region and the pole's area, prepared for many questions, and the
// length box.

#include <optional>

#include "geometry/region_reach.hpp"
#include "synthesis/problem/obstacle_gap.hpp"
#include "synthesis/problem/requirements.hpp"
#include "synthesis/problem/smooth_reach.hpp"
#include "synthesis/solvers/design_vector.hpp"

namespace kempe {

/// A half plane  normal . (place - at) <= 0  (normal a unit vector).
struct HalfPlane {
  Point normal, at;
  double inside(const Point& place) const { return normal.dot(at - place); }  ///< mm, >= 0 inside
};

/// Prepared from a spec; immutable and safe to share between threads.
class SearchSpace {
 public:
  explicit SearchSpace(Spec spec);

  const Spec& spec() const { return spec_; }
  Complex k() const { return spec_.copy.k(); }
  const RegionReach& region() const { return region_; }
  const DesignLayout& layout() const { return layout_; }
  bool pole_is_free(const Requirements& limits) const { return area_ || limits.pole_margin > 0; }

  /// Distances of the region from a pole, mm; nearest is negative inside the region.
  DistanceRange distances(const Point& pole) const;

  /// Distance of a place from where the pole may stand, mm; 0 inside.
  double pole_distance(const Point& place) const;
  /// The place itself if the pole may stand there, else the nearest where it may.
  Point nearest_pole(const Point& place) const;
  /// True if a place lies inside an edge of the pole's area, and not at a corner or elsewhere.
  bool is_on_edge(const Point& place) const;
  /// Where poles are looked for: the bounding box of where the pole may stand, grown by `margin`.
  Box pole_box(double margin) const;
  /// The spec's obstructions (obstructions.hpp) as convex parts, and the places of the tracer at which they are looked at first.
  const std::vector<ObstacleShape>& obstacles() const { return obstacles_; }
  const std::vector<Point>& tracer_places() const { return places_; }

  /// A corner of the region against its copy, or a corner of the copy against the region.
  struct GapCorner {
    Point corner;    ///< of the region
    bool is_copied;  ///< its image is meant
  };
  const std::vector<GapCorner>& gap_corners() const { return gap_corners_; }
  /// Distance of a corner of region or copy from the other one with the pole at a place, mm; negative: inside it. And the place of
  /// the region that decides it, with the map's derivative by the pole (a complex factor).
  struct CornerGap {
    double distance;
    Point normal;  ///< d distance / d pole = conj(factor) * normal
    Complex factor;
    double curvature;  ///< 1/mm of the distance across the normal: 0 beside an edge
  };
  CornerGap copy_gap(const GapCorner& corner, const Point& pole) const;
  /// The smallest of them and which it is. Crossing edges without a corner inside are not noticed.
  struct SmallestCopyGap {
    double distance;
    std::size_t corner;
  };
  SmallestCopyGap smallest_copy_gap(const Point& pole) const;

  /// Permitted poles on a lattice and on the area's edge, each with its distances.
  struct PoleSample {
    Point pole;
    DistanceRange distances;
  };
  const std::vector<PoleSample>& pole_samples() const { return samples_; }
  /// Half planes around a permitted pole whose intersection is permitted too: for a convex area its edges,
  /// else the largest that grows from this place (each edge cuts where it is nearest to the place).
  std::vector<HalfPlane> room_around(const Point& pole) const;

 private:
  /// Where a corner lies against the region itself.
  struct AgainstRegion {
    Point place;
    Complex factor;  ///< 1 less the derivative of the place by the pole
    double scale;    ///< times which the distance from the region is the gap
  };
  AgainstRegion against_region(const GapCorner& corner, const Point& pole) const;
  void sample_poles();
  void list_gap_corners();

  Spec spec_;
  RegionReach region_;
  std::optional<RegionReach> area_;
  DesignLayout layout_;
  std::optional<DistanceRange> distances_of_fixed_pole_;
  std::vector<PoleSample> samples_;
  std::vector<ObstacleShape> obstacles_;
  std::vector<Point> places_;
  std::vector<GapCorner> gap_corners_;
};

/// Bounds of log VA and log VB for which every length of every link keeps within the limits and the locks.
LogBox length_box(const Reach& reach, const Requirements& limits, const StockLengths& stock_lengths);

}  // namespace kempe
