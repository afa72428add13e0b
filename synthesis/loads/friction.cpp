#include "synthesis/loads/friction.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "specs/hardware.hpp"
#include "synthesis/loads/link_forces.hpp"
#include "synthesis/loads/moving_masses.hpp"

namespace kempe {

PinFriction::PinFriction(double mu, const LinkStyle& style, const JointHardware& hardware) : coefficient(mu) {
  for (const Joint joint : all_joints)
    radius[static_cast<std::size_t>(joint)] = rubbing_radius(style, hardware, joint);
}

PinLoads pin_loads(const CopyingLinkage& linkage, const Pose& pose, const Point& pen_force) {
  const Complex p = as_complex(pose.A - pose.V), q = as_complex(pose.B - pose.V);
  const Complex turn = p / std::abs(p), factor = pen_factor(linkage.k(), linkage.grounding());
  const Complex on_Y = std::conj(factor) * as_complex(pen_force) * std::conj(turn);
  const LinkForces forces = link_forces(linkage.shape(), std::arg(q / p));
  PinLoads loads;
  loads.A = std::abs(dot(forces.bar_VA, on_Y));
  loads.B = loads.V = std::abs(dot(forces.bar_VB, on_Y));
  loads.C = std::hypot(dot(forces.pin_C[0], on_Y), dot(forces.pin_C[1], on_Y));
  loads.pole = linkage.pole_joint() == Joint::V ? loads.A : std::abs(linkage.k() - 1.0) * pen_force.norm();
  return loads;
}

Point hand_force_against(const CopyingLinkage& linkage, const Point& pen_force) {
  return -as_point(std::conj(linkage.k()) * as_complex(pen_force));
}

double friction_loss(const CopyingLinkage& linkage, const Pose& pose, const PinLoads& loads,
                     const Point& tracer_velocity, const PinFriction& friction) {
  const auto turning = turning_by_tracer(linkage, pose);
  if (!turning) return infinity;
  const Eigen::Vector2d speeds = *turning * tracer_velocity;
  const double of_p = std::abs(speeds[0]), of_q = std::abs(speeds[1]),
               between = std::abs(speeds[1] - speeds[0]);
  const bool at_V = linkage.pole_joint() == Joint::V;
  const double at_joints =
      loads.A * friction.at(Joint::A) + loads.B * friction.at(Joint::B) + loads.C * friction.at(Joint::C);
  return friction.coefficient *
         (at_joints * between + loads.V * friction.at(Joint::V) * (at_V ? of_q : between) +
          loads.pole * friction.at(linkage.pole_joint()) * (at_V ? of_p : of_q));
}

double friction_share(const CopyingLinkage& linkage, double opening, const PinFriction& friction) {
  const Pose pose = linkage.pose_at(opening, 0);
  double most = 0;
  for (int i = 0; i < 90; ++i) {
    const Complex tracer = std::polar(1.0, i * pi / 90), pen = linkage.k() * tracer;
    const Point drag = -as_point(pen) / std::abs(pen);
    most = std::max(most, friction_loss(linkage, pose, drag, as_point(tracer), friction) / std::abs(pen));
  }
  return most;
}

OpeningInterval openings_without_lock(const CopyingLinkage& linkage, const OpeningInterval& within,
                                      const PinFriction& friction) {
  const OpeningInterval all = linkage.openings_with_transmission(0);
  const auto free = [&](double opening) { return friction_share(linkage, opening, friction) < 1; };
  const auto last_free = [&](double inside, double end) {
    if (!free(inside)) return inside;
    if (free(end)) return end;
    while (std::abs(end - inside) > radians(0.001))
      (free(0.5 * (inside + end)) ? inside : end) = 0.5 * (inside + end);
    return inside;
  };
  return {last_free(within.lower, all.lower), last_free(within.upper, all.upper)};
}

}  // namespace kempe
