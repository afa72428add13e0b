#pragma once
// What every choice of a spec shares: the region and the pole's area, prepared for many questions, and the
// length box.

#include <optional>

#include "synthesis/design_vector.hpp"
#include "synthesis/reach.hpp"
#include "synthesis/region_reach.hpp"
#include "synthesis/requirements.hpp"

namespace kempe {

/// A half plane  normal . (place - at) <= 0  (normal a unit vector).
struct HalfPlane {
  Point normal, at;
  double inside(const Point& place) const { return normal.dot(at - place); }  ///< mm, >= 0 inside
};

/// Prepared from a spec; immutable and safe to share between threads.
class SearchSpace {
 public:
  explicit SearchSpace(const Spec& spec);

  const Spec& spec() const { return spec_; }
  Complex k() const { return spec_.copy.k; }
  const RegionReach& region() const { return region_; }
  const DesignLayout& layout() const { return layout_; }
  bool pole_is_free(const Requirements& limits) const { return area_ || limits.pole_margin > 0; }

  /// Distances of the region from a pole, mm; nearest negative inside the region.
  struct Annulus {
    double nearest, farthest;
  };
  Annulus annulus(const Point& pole) const;

  /// Distance of a place from where the pole may stand, mm; 0 inside.
  double pole_distance(const Point& place) const;
  /// The place itself if the pole may stand there, else the nearest where it may.
  Point nearest_pole(const Point& place) const;
  /// True if a place lies inside an edge of the pole's area, and not at a corner or elsewhere.
  bool is_on_edge(const Point& place) const;
  /// Where poles are looked for: the bounding box of where the pole may stand, grown by `margin`.
  Box pole_box(double margin) const;
  /// Permitted poles on a lattice and on the area's edge, each with its annulus.
  struct PoleSample {
    Point pole;
    Annulus annulus;
  };
  const std::vector<PoleSample>& pole_samples() const { return samples_; }
  /// Half planes around a permitted pole whose intersection is permitted too: for a convex area its edges,
  /// else the largest that grows from this place (each edge cuts where it is nearest to the place).
  std::vector<HalfPlane> room_around(const Point& pole) const;

 private:
  void sample_poles();

  Spec spec_;
  RegionReach region_;
  std::optional<RegionReach> area_;
  DesignLayout layout_;
  std::optional<Annulus> fixed_annulus_;
  std::vector<PoleSample> samples_;
};

/// Bounds of log VA and log VB for which every length of every link keeps within the limits and the locks.
LogBox length_box(const Reach& reach, const Requirements& limits, const WorkshopSpec& workshop);

}  // namespace kempe
