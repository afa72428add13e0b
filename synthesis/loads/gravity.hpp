#pragma once

#include <cmath>

#include "kempe/load.hpp"

namespace kempe {

inline constexpr double standard_gravity = 9.80665;   ///< m/s^2, N/kg
inline constexpr double cubic_metres_per_mm3 = 1e-9;  ///< in a cubic millimetre

/// N: so much pulls the pen along the plane at most: the load's force and, on a tilted table, the weight of what the pen carries, as if both
/// had one direction.
inline double most_force_at_pen(const Load& load) {
  return load.pen_force + standard_gravity * std::sin(load.tilt) * load.pen_mass;
}

}  // namespace kempe
