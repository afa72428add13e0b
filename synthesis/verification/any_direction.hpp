#pragma once
// The most of a figure over all directions, as the frames that verify loads look for it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/point.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {

/// The most over all directions of value(direction, rad): sampled, and refined beside each that stands above its neighbours.
template <class Value>
double most_in_any_direction(const Value& value) {
  constexpr std::size_t directions = 180;
  constexpr int steps = 40;
  constexpr double step = 2 * pi / directions;
  std::array<double, directions> seen;
  for (std::size_t i = 0; i < directions; ++i) seen[i] = value(step * static_cast<double>(i));
  double most = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    if (!std::isfinite(seen[i])) return seen[i];
    if (seen[i] < seen[(i + 1) % directions] || seen[i] < seen[(i + directions - 1) % directions]) continue;
    const double at = step * static_cast<double>(i);
    most = std::max({most, seen[i], value(top_by_golden_section(value, at - step, at + step, steps))});
  }
  return most;
}

}  // namespace kempe
