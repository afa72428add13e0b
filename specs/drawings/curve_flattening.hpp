#pragma once
// Curves of a drawing as polylines within a tolerance of them.

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "geometry/regions/region_growth.hpp"

namespace kempe {

/// A stroke of a drawing, as the pen would draw it.
struct DrawnStroke {
  Stroke points;  ///< mm, at least two; of a closed one the first is not repeated at the end
  bool closed = false;
};

/// All its points are finite, and none is beyond ten kilometres (largest_coordinate).
bool is_sound(const DrawnStroke& stroke);

/// Takes a drawing's curves in their own coordinates, maps them by an affine map and gives back polylines.
///
/// Guarantees, for curves that are finite:
///  1. every point of a polyline lies on its curve (up to rounding), in the order of drawing;
///  2. no point of a curve is farther than the tolerance from its polyline;
///  3. straight parts come back as they are;
///  4. it makes no more than `room` points and one: who asks for more finds is_full(), and what has come until then.
class CurveFlattener {
 public:
  /// How many points a drawing may have.
  static constexpr std::size_t most_points = 5'000'000;

  /// `map` takes the curves' coordinates to mm; `tolerance` mm, > 0.
  CurveFlattener(const Eigen::Affine2d& map, double tolerance, std::size_t room = most_points)
      : map_(map), tolerance_(tolerance), room_(room) {}

  /// Whether there were more points than room.
  bool is_full() const { return points_ > room_; }

  /// Where the pen is, in the curves' own coordinates.
  const Point& pen() const { return pen_; }
  /// Where the present stroke began.
  const Point& start() const { return start_; }

  /// The tolerance in the curves' own units, where the map stretches most.
  double own_tolerance() const;

  void move_to(const Point& to);
  void line_to(const Point& to);
  void quadratic_to(const Point& control, const Point& to);
  void cubic_to(const Point& control1, const Point& control2, const Point& to);
  /// An arc of an ellipse about `centre` with the half axes a and b (vectors): centre + a cos t + b sin t, t
  /// from `from` by `sweep` (rad); the pen must stand at its beginning, and ends exactly at `to`.
  void elliptic_to(const Point& centre, const Point& a, const Point& b, double from, double sweep,
                   const Point& to);
  void close();

  /// How many points there are up to now.
  std::size_t points() const { return points_; }
  /// The strokes; those of a single point are left out.
  std::vector<DrawnStroke> take();

 private:
  void add(const Point& mapped);
  /// Steps for a curve whose second derivative in its parameter (0..1) is at most `bend` (mm).
  int steps_for(double bend) const;
  void finish_stroke(bool closed);

  Eigen::Affine2d map_;
  double tolerance_;
  std::size_t room_;
  Point pen_ = Point::Zero(), start_ = Point::Zero();
  DrawnStroke stroke_;
  std::vector<DrawnStroke> strokes_;
  std::size_t points_ = 0;
};

}  // namespace kempe
