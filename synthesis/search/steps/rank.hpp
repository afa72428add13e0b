#pragma once
// When one figure is less than another.

#include <cmath>

namespace kempe {

/// A figure as two are compared: its first 34 binary digits, 6e-11 of it. What differs beyond these is rounding, which is another on
/// another machine; where two designs are alike up to there, the one met first is kept, on every machine the same. Portable: it asks
/// no mathematical library.
inline double rank(double figure) {
  int exponent = 0;
  const double mantissa = std::frexp(figure, &exponent);
  return std::isfinite(figure) ? std::ldexp(std::nearbyint(std::ldexp(mantissa, 34)), exponent - 34) : figure;
}

}  // namespace kempe
