#pragma once
// Units: lengths are millimetres and angles radians, always. Multiply a number by these to say what it is.

namespace kempe {

inline constexpr double pi = 3.14159265358979323846;

inline constexpr double mm = 1;
inline constexpr double inch = 25.4;
inline constexpr double rad = 1;
inline constexpr double degree = pi / 180;

/// An angle in degrees as radians.
inline constexpr double radians(double degrees) { return degrees * degree; }
/// An angle in radians as degrees.
inline constexpr double degrees(double radians) { return radians * (180 / pi); }

}  // namespace kempe
