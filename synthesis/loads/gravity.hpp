#pragma once

namespace kempe {

inline constexpr double standard_gravity = 9.80665;   ///< m/s^2, N/kg
inline constexpr double cubic_metres_per_mm3 = 1e-9;  ///< in a cubic millimetre

}  // namespace kempe
