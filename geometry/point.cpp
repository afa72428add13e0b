#include "geometry/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kempe {

Complex copy_ratio(double scale, double rotation) {
  const double quarters = rotation / (pi / 2);
  const double whole = std::round(quarters);
  if (!(std::abs(quarters - whole) <= 1e-15 * std::max(1.0, std::abs(quarters))))
    return std::polar(scale, rotation);
  constexpr std::array<Complex, 4> unit{Complex{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return scale * unit[static_cast<std::size_t>(static_cast<int>(std::fmod(whole, 4)) & 3)];
}

}  // namespace kempe
