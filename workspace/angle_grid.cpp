#include "workspace/angle_grid.hpp"

#include <cmath>

namespace kempe {

AngleGrid::AngleGrid(const CopyingLinkage& linkage, const OpeningInterval& openings)
    : linkage_(linkage), openings_(openings), dead_(std::arg(linkage.shape())) {
  const double chain = chain_length_per_tracer(linkage.k(), linkage.grounding());
  area_scale_ = 2 * linkage.VA() * linkage.VB() / std::abs(linkage.shape()) / (chain * chain);
}

double AngleGrid::opening(double y) const {
  if (y == rise) return openings_.upper;
  return openings_.lower + openings_.width() * (y * (1.0 / rise));
}

Point AngleGrid::place(double x, double y) const {
  return linkage_.pole() + as_point(std::polar(radius(y), bearing(x)));
}

double AngleGrid::area_per_bearing(std::uint32_t y, std::uint32_t height) const {
  // r^2 = (VA^2 + m^2 + 2 VA m cos(d - arg s)) / n^2 with m = VB/|s| and n the chain over the tracer's distance; as a product
  // the difference of the two ends' squares keeps its digits in the smallest cell.
  const double middle = opening(y + 0.5 * height), half = 0.5 * openings_.width() * (height * (1.0 / rise));
  return area_scale_ * std::abs(std::sin(middle - dead_) * std::sin(half));
}

}  // namespace kempe
