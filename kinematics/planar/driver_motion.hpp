#pragma once
// How drivers move: over a range, or a point along a path.

#include <array>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// A driver value that goes evenly from one end to the other.
struct DriverRange {
  double from = 0, to = 0;     ///< mm or rad
  std::optional<double> rate;  ///< mm/s or rad/s, instead of (to - from) / duration
  bool operator==(const DriverRange&) const = default;
};

/// A point of a path: place, unit tangent, and the tangent's change a mm (curvature times normal).
struct PathPlace {
  Point at, tangent, bend;
};

/// A piece of a path: a straight line, an arc of a circle, or a cubic Bezier curve.
class PathPiece {
 public:
  static PathPiece line(const Point& from, const Point& to);
  /// `radius` mm, > 0; `start` and `sweep` rad, sweep positive counter-clockwise.
  static PathPiece arc(const Point& centre, double radius, double start, double sweep);
  static PathPiece cubic(const Point& a, const Point& b, const Point& c, const Point& d);

  bool is_straight() const { return kind_ == Kind::line; }
  Point begin() const { return at(0).at; }
  Point end() const { return at(length_).at; }
  double length() const { return length_; }  ///< mm; of a cubic by quadrature, to rounding for tame curves
  /// A bound of the curvature, 1/mm; nothing if none is known.
  std::optional<double> most_curved() const;
  PathPlace at(double way) const;  ///< after `way` mm of arc length
  bool operator==(const PathPiece&) const = default;

 private:
  enum class Kind { line, arc, cubic };
  PathPlace on_cubic(double way) const;

  Kind kind_ = Kind::line;
  std::array<Point, 4> points_{};  ///< line: ends first; arc: centre first; cubic: control points
  double radius_ = 0, start_ = 0, sweep_ = 0;
  double length_ = 0;
  std::vector<double> cubic_lengths_;  ///< arc length at equal steps of the cubic's parameter
};

/// A path of such pieces, run through at even speed.
/// Invariant: at least one piece, each longer than 0; a piece starts where the last one ended.
class DriverPath {
 public:
  /// `even_speed` mm/s, instead of length / duration.
  explicit DriverPath(std::vector<PathPiece> pieces, std::optional<double> even_speed = {});

  std::optional<double> speed;

  const std::vector<PathPiece>& pieces() const { return pieces_; }
  double length() const { return length_; }  ///< mm
  double extent() const;                     ///< mm, about the largest distance from its start
  /// The place at a share 0..1 of the length; at a corner that of the piece that starts there.
  PathPlace at(double share) const;
  /// The piece that is under way at a share, by number.
  std::size_t piece_at(double share) const;
  /// Shares at which pieces end, the last one 1.
  const std::vector<double>& ends() const { return ends_; }
  bool operator==(const DriverPath&) const = default;

 private:
  std::vector<PathPiece> pieces_;
  std::vector<double> ends_;
  double length_ = 0;
};

}  // namespace kempe
