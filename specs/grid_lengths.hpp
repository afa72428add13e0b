#pragma once
// Lengths that are multiples of a grid.

#include <algorithm>
#include <cmath>

namespace kempe {

/// The largest multiple of a grid that is no longer than `longest` but for rounding; all in mm, > 0.
inline double longest_multiple(double grid, double longest) {
  constexpr double rounding = 1e-9;  // 301.2 / 100.4 is below 3
  return std::min(longest, std::floor(longest / grid * (1 + rounding)) * grid);
}

}  // namespace kempe
