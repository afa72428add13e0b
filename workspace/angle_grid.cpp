#include "workspace/angle_grid.hpp"

#include <cmath>

namespace kempe {

AngleGrid::AngleGrid(const CopyingLinkage& linkage, const OpeningInterval& openings)
    : linkage_(linkage), openings_(openings) {}

double AngleGrid::opening(double y) const {
  if (y == rise) return openings_.upper;
  return openings_.lower + openings_.width() * (y * (1.0 / rise));
}

Point AngleGrid::place(double x, double y) const {
  return linkage_.pole() + as_point(std::polar(radius(y), bearing(x)));
}

double AngleGrid::area(const GridCell& cell) const {
  const double a = radius(cell.y), b = radius(cell.top());
  return 0.5 * std::abs(a - b) * (a + b) * bearing(cell.width);
}

}  // namespace kempe
