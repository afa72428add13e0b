#pragma once
// Units: lengths are millimetres and angles radians, always. Multiply a number by these, or by rad and degree of point.hpp, to
// say what it is.

#include "kempe/point.hpp"

namespace kempe {

inline constexpr double mm = 1;
inline constexpr double inch = 25.4;

}  // namespace kempe
