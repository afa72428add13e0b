#pragma once
// Units: lengths are millimetres and angles radians, always. Multiply a number by these to say what it is.

#include "kempe/point.hpp"

namespace kempe {

inline constexpr double mm = 1;
inline constexpr double inch = 25.4;
inline constexpr double rad = 1;
inline constexpr double degree = pi / 180;

}  // namespace kempe
