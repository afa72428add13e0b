#pragma once
// What acts on a linkage from outside, and the masses that its motion has to move.

#include <Eigen/Core>
#include <vector>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// A force at a point, N. Its direction stands still on the table, or turns with a body.
struct PointForce {
  BodyPoint at;
  Point newton = Point::Zero();            ///< in the frame of `turns_with`
  int turns_with = PlanarLinkage::ground;  ///< a body; the ground: the direction stands still
  bool operator==(const PointForce&) const = default;
};

/// Two equal and opposite forces along the line of two points: a spring, a gas strut.
struct PairForce {
  BodyPoint a, b;
  double newton = 0;  ///< > 0 pushes the points apart
  bool operator==(const PairForce&) const = default;
};

/// A moment on a body, N mm, counter-clockwise positive; `against` bears the opposite one.
struct BodyMoment {
  int body = 0, against = PlanarLinkage::ground;
  double moment = 0;
  bool operator==(const BodyMoment&) const = default;
};

/// A mass of a body.
struct BodyMass {
  int body = 0;
  double kg = 0;
  Point centre = Point::Zero();  ///< of mass, in the body's frame, mm
  double inertia = 0;            ///< about the centre of mass, kg mm^2
  bool operator==(const BodyMass&) const = default;
};

struct PlanarLoads {
  std::vector<PointForce> forces;
  std::vector<PairForce> pairs;
  std::vector<BodyMoment> moments;
  std::vector<BodyMass> masses;
  Point gravity = Point::Zero();  ///< m/s^2, on all masses

  bool empty() const { return forces.empty() && pairs.empty() && moments.empty() && masses.empty(); }
  bool operator==(const PlanarLoads&) const = default;
};

/// The unit vector from b to a, in the table's frame. NaN where the two coincide (they are nearer than slack::same_point of their
/// distances from the origin): a force along their line has no direction then.
Point direction_between(const Point& a, const Point& b);

/// The loads and the weights as generalised forces: for each body but the ground the force (N) and the moment about its
/// frame's origin (N mm), in the order of the unknowns. Times the unknowns' rates (mm/s, rad/s) they are the power that the
/// loads bring in, N mm/s. NaN for the bodies of a pair whose points coincide.
Eigen::VectorXd applied_forces(const PlanarLoads& loads, const PlanarPosition& position);

/// What the masses need to move as they do, in the same order and units: mass times acceleration of the centre of mass,
/// and the moments that go with it. `rate` and `second` are the unknowns' first and second derivatives by time
/// (PlanarPath::velocity and acceleration).
Eigen::VectorXd inertia_forces(const PlanarLoads& loads, const PlanarPosition& position,
                               const Eigen::VectorXd& rate, const Eigen::VectorXd& second);

}  // namespace kempe
