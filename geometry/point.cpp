#include "geometry/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kempe {

namespace {

/// With more digits than a double has, and rounded once: sines of doubles differ in their last digit from library to library, and a
/// linkage near its dead point makes a hundred times as much of it.
Complex unit_at(double angle) {
  const auto turn = static_cast<long double>(angle);
  return {static_cast<double>(std::cos(turn)), static_cast<double>(std::sin(turn))};
}

}  // namespace

Complex copy_ratio(double scale, double rotation) {
  const double quarters = rotation / (pi / 2);
  const double whole = std::round(quarters);
  if (!(std::abs(quarters - whole) <= 1e-15 * std::max(1.0, std::abs(quarters))))
    return scale * unit_at(rotation);
  constexpr std::array<Complex, 4> unit{Complex{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return scale * unit[static_cast<std::size_t>(static_cast<int>(std::fmod(whole, 4)) & 3)];
}

}  // namespace kempe
