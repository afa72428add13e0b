#include "geometry/stated_angle.hpp"

#include <cmath>
#include <limits>

#include "geometry/point.hpp"

namespace kempe {

double stated_degrees(double angle) {
  const double converted = degrees(angle);
  double unit = 1;
  for (int decimals = 0; decimals <= 12; ++decimals, unit *= 10) {
    const double rounded = std::round(converted * unit) / unit;
    if (radians(rounded) == angle) return rounded;
  }
  double below = converted, above = converted;
  for (int step = 0; step < 4; ++step) {
    if (radians(below) == angle) return below;
    if (radians(above) == angle) return above;
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return converted;
}

}  // namespace kempe
