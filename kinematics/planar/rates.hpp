#pragma once
// Velocities and accelerations of points of a moving linkage, from the rates of its bodies.

#include <Eigen/Core>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// Angle of a body's rate vector entry: angular velocity (rad/s) or acceleration (rad/s^2); 0 for the ground.
double spin_of(const Eigen::VectorXd& rates, int body);

/// Velocity of a body's point, mm/s; `rate` is PlanarPath::velocity.
Point velocity_of(const PlanarPosition& position, const Eigen::VectorXd& rate, const BodyPoint& point);

/// Acceleration of a body's point, mm/s^2; `second` is PlanarPath::acceleration.
Point acceleration_of(const PlanarPosition& position, const Eigen::VectorXd& rate,
                      const Eigen::VectorXd& second, const BodyPoint& point);

}  // namespace kempe
