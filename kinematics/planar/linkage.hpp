#pragma once
// Any planar linkage as bodies and constraints: what the general solver moves.
//
// A body has a position (x, y) and a direction (angle) in the table's frame; points are fixed on bodies by
// local coordinates. Nothing here knows of copying linkages: verification builds a design from these parts
// alone.

#include <string>
#include <variant>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// A point fixed on a body, in the body's own frame (mm). Body 0 is the ground, whose frame is the table's.
struct BodyPoint {
  int body = 0;
  Point local = Point::Zero();
  bool operator==(const BodyPoint&) const = default;
};

/// a = b: two points stay together, the bodies turn about them. Two equations.
struct Revolute {
  BodyPoint a, b;
  bool operator==(const Revolute&) const = default;
};

/// direction . (point - origin) = value, the direction turning with the origin's body. One equation: a point
/// on a line (direction = the line's normal), or a driven coordinate (origin on the ground).
struct Coordinate {
  BodyPoint point, origin;
  Point direction{1, 0};  ///< unit vector in the frame of origin's body
  double value = 0;       ///< mm
  bool operator==(const Coordinate&) const = default;
};

/// |a - b| = value. One equation.
struct Distance {
  BodyPoint a, b;
  double value = 1;  ///< mm, > 0
  bool operator==(const Distance&) const = default;
};

/// angle(body) - angle(reference) = value. One equation. Angles are continuous: they count whole turns.
struct RelativeAngle {
  int body = 0, reference = 0;
  double value = 0;  ///< rad
  bool operator==(const RelativeAngle&) const = default;
};

/// Two wheels whose centres `carrier` holds: a (angle(first) - angle(carrier)) + b (angle(second) -
/// angle(carrier)) = value. Outer teeth: a and b are the radii; one wheel with inner teeth: its radius is
/// negative. One equation.
struct GearPair {
  int first = 0, second = 0, carrier = 0;
  double first_radius = 1, second_radius = 1;  ///< in any unit (teeth will do): only their ratio counts
  double value = 0;                            ///< in that unit, of pitch circle
  bool operator==(const GearPair&) const = default;
};

/// direction . (centre - rack_origin) + radius (angle(pinion) - angle(rack)) = value: the pinion rolls on the
/// rack's line. One equation; that the centre keeps its distance from the line is another joint's task. With
/// the pinion on the left of the direction (as seen along it) the radius is positive.
struct RackAndPinion {
  BodyPoint centre;       ///< on the pinion
  BodyPoint rack_origin;  ///< on the rack
  Point direction{1, 0};  ///< unit vector along the rack, in the rack's frame
  double radius = 1;      ///< mm
  double value = 0;       ///< mm
  bool operator==(const RackAndPinion&) const = default;
};

using Constraint = std::variant<Revolute, Coordinate, Distance, RelativeAngle, GearPair, RackAndPinion>;

/// Number of equations of a constraint: 2 for a revolute joint, else 1.
int equation_count(const Constraint& constraint);

/// The bodies that a constraint mentions.
std::vector<int> bodies_of(const Constraint& constraint);

/// The points that a constraint mentions.
std::vector<BodyPoint> points_of(const Constraint& constraint);

/// Where a body is: the place of its frame's origin and its direction.
struct BodyPlacement {
  Point at = Point::Zero();
  double angle = 0;  ///< rad, continuous
  bool operator==(const BodyPlacement&) const = default;
};

/// A position of a whole linkage: one placement a body, the ground (always at rest) first.
using PlanarPosition = std::vector<BodyPlacement>;

/// A vector of a body's frame as it lies in the table's frame: turned, not shifted.
Point turned(const PlanarPosition& position, int body, const Point& local);

/// Where a body's point is, table frame, mm.
Point place(const PlanarPosition& position, const BodyPoint& point);

/// A planar linkage: bodies and constraints, some of which are drivers.
///
/// Invariant: body 0 is the ground; every constraint mentions existing bodies only. A value.
class PlanarLinkage {
 public:
  static constexpr int ground = 0;

  struct NamedConstraint {
    std::string name;
    Constraint constraint;
    bool operator==(const NamedConstraint&) const = default;
  };

  /// Adds a body with three freedoms and returns its number.
  int add_body(std::string name = {});

  /// Adds a body that cannot turn, for a point that belongs to no link; returns its number.
  int add_particle(const std::string& name = {});

  /// Adds a constraint and returns its number.
  int add(const Constraint& constraint, std::string name = {});

  /// Adds a constraint whose value is driven and returns the driver's number (0, 1, ... in order of adding).
  /// Not for revolute joints.
  int drive(const Constraint& constraint, std::string name = {});

  /// Drives a point's place: two drivers, x then y in the ground's frame. Returns the first's number.
  int drive_point(const BodyPoint& point, const std::string& name = {});

  int body_count() const { return static_cast<int>(bodies_.size()); }  ///< the ground included
  const std::string& body_name(int body) const { return bodies_[static_cast<std::size_t>(body)]; }
  bool is_particle(int body) const { return is_particle_[static_cast<std::size_t>(body)]; }
  int particle_count() const;
  const std::vector<NamedConstraint>& constraints() const { return constraints_; }
  /// Numbers of the constraints that are drivers, in the order of adding.
  const std::vector<int>& drivers() const { return drivers_; }
  bool is_driver(int constraint) const;
  /// The values at which the drivers were added.
  std::vector<double> driver_values() const;

  int unknown_count() const { return 3 * (body_count() - 1); }
  int equation_count() const;

  /// The linkage's characteristic length, mm: what residuals and steps are compared with, so that no answer depends on
  /// the unit. The largest distance between two jointed points of one body, or held between two bodies (drivers
  /// aside). Where there is none, the drivers' travel, else 1.
  double size() const { return size_ > 0 ? size_ : travel_ > 0 ? travel_ : 1; }

  /// How far the drivers move points, mm; 0 if that is not known.
  void set_travel(double travel) { travel_ = travel; }

  /// How far places are apart that a motion leads to, mm, about: the size or the travel.
  double reach() const { return travel_ > size() ? travel_ : size(); }

  /// The linkage without its drivers: what mobility is about.
  PlanarLinkage undriven() const;

  /// A sentence about the first number that is not finite, a distance or radius that is zero, a direction
  /// that is no unit vector, or a constraint of a body to itself; empty if there is none.
  std::string fault() const;

  bool operator==(const PlanarLinkage&) const = default;

 private:
  int append(const Constraint& constraint, std::string name);
  void measure(const Constraint& constraint);

  std::vector<std::string> bodies_{"ground"};
  std::vector<bool> is_particle_{false};
  std::vector<NamedConstraint> constraints_;
  std::vector<int> drivers_;
  std::vector<std::vector<Point>> jointed_{1};  ///< points of each body that constraints hold, drivers aside
  double travel_ = 0, size_ = 0;                ///< mm
};

}  // namespace kempe
