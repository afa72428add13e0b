#pragma once
// Friction in the pins while the hand leads the tracer and the pen is dragged: the sum of mu r |f| |omega| over the pins, with the forces f
// that the pins bear without friction. That is right to first order; near the change points f and omega grow as 1 / sin d, and where
// friction would take all of the hand's work the linkage is about to lock.

#include <array>

#include "kempe/links.hpp"
#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// Dry friction in round pins.
struct PinFriction {
  /// Pins of one radius, mm, > 0.
  PinFriction(double mu, double of_all) : coefficient(mu) { radius.fill(of_all); }
  /// Each joint's own pin or bearing.
  PinFriction(double mu, const LinkStyle& style, const JointHardware& hardware);

  double coefficient;            ///< mu, >= 0
  std::array<double, 6> radius;  ///< mm, of the pins, in the order of Joint
  double at(Joint joint) const { return radius[static_cast<std::size_t>(joint)]; }
};

/// N, what the pins bear without friction. Where the pole is at V, VA and VB turn on its post: `pole` is VA's part, `V` is VB's.
struct PinLoads {
  double A = 0, B = 0, C = 0, V = 0, pole = 0;
};
/// For a force on the pen (N, table frame). At a pose that is no change point.
PinLoads pin_loads(const CopyingLinkage& linkage, const Pose& pose, const Point& pen_force);

/// N that the hand pushes with at the tracer to hold a force on the pen, without friction: -conj(k) F_pen.
Point hand_force_against(const CopyingLinkage& linkage, const Point& pen_force);

/// N mm/s lost in the pins under these forces while the tracer moves at `tracer_velocity`, mm/s; infinite at a dead point.
double friction_loss(const CopyingLinkage& linkage, const Pose& pose, const PinLoads& loads,
                     const Point& tracer_velocity, const PinFriction& friction);
/// The same with a force on the pen.
inline double friction_loss(const CopyingLinkage& linkage, const Pose& pose, const Point& pen_force,
                            const Point& tracer_velocity, const PinFriction& friction) {
  return friction_loss(linkage, pose, pin_loads(linkage, pose, pen_force), tracer_velocity, friction);
}

/// The largest share of a drag's work at the pen that friction takes in addition, over all directions of motion (sampled every 2 degrees),
/// where the drag opposes the pen's motion; infinite at a dead point. At an opening that is no change point.
double friction_share(const CopyingLinkage& linkage, double opening, const PinFriction& friction);

/// The openings about `within` in its assembly mode where friction_share() stays below 1, to a thousandth of a degree. An end of `within`
/// where it is 1 or more comes back unchanged.
OpeningInterval openings_without_lock(const CopyingLinkage& linkage, const OpeningInterval& within,
                                      const PinFriction& friction);

}  // namespace kempe
