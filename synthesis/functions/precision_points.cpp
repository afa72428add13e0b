#include "synthesis/functions/precision_points.hpp"

#include <cmath>

#include "geometry/point.hpp"

namespace kempe {

std::vector<double> chebyshev_points(double lower, double upper, int n) {
  std::vector<double> points;
  const double centre = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  for (int j = 1; j <= n; ++j) points.push_back(centre + half * std::cos((2 * j - 1) * pi / (2 * n)));
  return points;
}

}  // namespace kempe
