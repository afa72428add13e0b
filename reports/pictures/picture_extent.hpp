#pragma once
// How far what a picture shows reaches.

#include <limits>

#include "geometry/arc_polygon.hpp"
#include "reports/pictures/picture_labels.hpp"

namespace kempe {

/// The upright box of all that was added, mm.
class PictureExtent {
 public:
  void add(const Point& at) {
    lower_ = lower_.cwiseMin(at);
    upper_ = upper_.cwiseMax(at);
  }
  /// The square `around` (mm) on all sides of a point.
  void add(const Point& at, double around) {
    add(at - Point::Constant(around));
    add(at + Point::Constant(around));
  }
  void add(const Ring& ring) {
    for (const Point& at : ring) add(at);
  }
  void add(const Region& region) {
    for (const Polygon& polygon : region.polygons) add(polygon.outer);
  }
  void add(const ArcRegion& region);

  /// True until something was added.
  bool empty() const { return !(lower_.x() <= upper_.x()); }
  PictureBox box() const { return {0.5 * (lower_ + upper_), 0.5 * (upper_ - lower_)}; }

 private:
  void add_edge(const ArcVertex& from, const Point& to);

  Point lower_ = Point::Constant(std::numeric_limits<double>::infinity());
  Point upper_ = Point::Constant(-std::numeric_limits<double>::infinity());
};

}  // namespace kempe
