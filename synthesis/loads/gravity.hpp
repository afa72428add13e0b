#pragma once

#include <cmath>

#include "kempe/spec.hpp"

namespace kempe {

inline constexpr double standard_gravity = 9.80665;   ///< m/s^2, N/kg
inline constexpr double cubic_metres_per_mm3 = 1e-9;  ///< in a cubic millimetre

/// m/s^2: what of gravity acts across the plane of a table tilted by `tilt` (rad, 0 to pi/2); nothing where it stands upright, whatever the
/// rounding of pi/2 leaves of its cosine.
inline double gravity_across(double tilt) {
  constexpr double upright = 1e-12;
  const double share = std::cos(tilt);
  return share > upright ? standard_gravity * share : 0;
}

/// m/s^2: what of gravity pulls along the table; nothing on a level one.
inline double gravity_along(double tilt) { return standard_gravity * std::sin(tilt); }

/// N: so much pulls the pen along the plane at most: the load's force and, on a tilted table, the weight of what the pen carries, as if both
/// had one direction.
inline double most_force_at_pen(const Load& load) {
  return load.pen_force + standard_gravity * std::sin(load.tilt) * load.pen_mass;
}

}  // namespace kempe
