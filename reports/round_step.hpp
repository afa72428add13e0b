#pragma once
// Steps that people count in.

#include <cmath>

namespace kempe {

/// The least of 1, 2, 5 times a power of ten that is not below `wanted` (> 0).
inline double round_step(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (wanted <= factor * power) return factor * power;
  return 10 * power;
}

}  // namespace kempe
