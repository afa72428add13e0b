#pragma once
// Points of the table's plane, regions of it, and angles.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "kempe/export.hpp"

namespace kempe {

/// A point or vector of the table's plane, mm; x to the right, y away from you.
using Point = Eigen::Vector2d;

/// A plane vector where a formula is a similarity: multiplication turns and scales.
using Complex = std::complex<double>;

/// Straight edges from point to point, mm.
using Polyline = std::vector<Point>;

/// Half a turn, rad.
inline constexpr double pi = 3.14159265358979323846;
/// The library's own unit of angles: 0.5 * rad.
inline constexpr double rad = 1;
/// A degree in rad: 30 * degree.
inline constexpr double degree = pi / 180;
/// An angle in degrees as radians.
inline constexpr double radians(double degrees) { return degrees * degree; }
/// An angle in radians as degrees.
inline constexpr double degrees(double radians) { return radians * (180 / pi); }

/// A closed ring of points, mm; the last point is not the first repeated.
using Ring = std::vector<Point>;

/// Invariant (validate() and the reader establish it, all others assume it): rings are simple and do not cross, the outer
/// ring runs counter-clockwise, holes run clockwise and lie inside.
struct Polygon {
  Ring outer;               ///< counter-clockwise
  std::vector<Ring> holes;  ///< clockwise
  bool operator==(const Polygon&) const = default;
};

/// A set of polygons with disjoint interiors, mm. A value: what is wrong with it is said by validate().
struct KEMPE_EXPORT Region {
  std::vector<Polygon> polygons;  ///< in any order

  /// The upright rectangle with this lower left corner, width and height, mm. Nothing is refused here, nor in circle() and
  /// polygon(): a width, height or radius that is not > 0, or a ring without an area, makes a region that validate() and
  /// design() refuse.
  static Region rectangle(const Point& lower_left, const Point& size);
  /// A circle, mm, as a region must hold it to be covered: the regular polygon around it with 1440 corners, which exceeds
  /// the radius by 2.4e-6 of it at most.
  static Region circle(const Point& centre, double radius);
  /// What a ring of at least three corners encloses, less its holes, mm; rings may run either way.
  static Region polygon(Ring outer, std::vector<Ring> holes = {});

  /// True if it has no polygon.
  bool empty() const { return polygons.empty(); }
  bool operator==(const Region&) const = default;
};

}  // namespace kempe
