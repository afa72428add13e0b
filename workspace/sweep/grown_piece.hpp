#pragma once
// A convex piece of a link, and which part of a circle about the pole lies in it.

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/point.hpp"
#include "workspace/sweep/bearings.hpp"

namespace kempe::sweep {

/// A convex piece of a link at rest, grown by `half_width` (mm); the pole at the origin. Three corners run counter-clockwise.
class GrownPiece {
 public:
  /// The first `count` corners count: 1 to 3.
  GrownPiece(const std::array<Point, 3>& corners, int count, double half_width);

  /// How near to the pole the piece comes, mm.
  double nearest() const;
  /// How far from it, mm.
  double farthest() const;

  /// The angles of the circle of radius rho about the pole that lie in the piece; replaces `found`.
  void angles_in(double rho, std::vector<Bearings>& found) const;

 private:
  /// A corner and the straight outline beside the edge that leaves it.
  struct Side {
    Point from = Point::Zero(), along = Point::Zero(), outward = Point::Zero();
    double length = 0, height = 0;  ///< of the edge; of the outline's line over the pole
    double away = 0, from_bearing = 0, outward_bearing = 0;
  };
  struct Crossings {
    std::array<double, 12> at;
    std::size_t count = 0;
    void add(double angle) { at[count++] = angle - 2 * pi * std::floor(angle / (2 * pi)); }
  };

  std::size_t size() const { return static_cast<std::size_t>(count_); }
  double squared_distance(const Point& point) const;
  bool has(double rho, double bearing) const;
  /// Angles at which the circle passes the outline, in rising order: its straight parts and its round corners. What
  /// rounding puts at an end of both is listed twice, which does no harm.
  void crossings(double rho, Crossings& found) const;

  std::array<Side, 3> sides_;
  int count_;
  double half_width_;
};

}  // namespace kempe::sweep
