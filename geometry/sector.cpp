#include "geometry/sector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kempe {
namespace {

/// Shares [from, to] of the way along an edge; empty if from > to.
struct Shares {
  double from = 0, to = 1;
};

/// Keeps the shares at which a linear function, `start` at 0 and `end` at 1, is not negative.
void clip(Shares& shares, double start, double end) {
  if (start < 0 && end < 0) shares = {1, 0};
  if (start < 0 && end >= 0) shares.from = std::max(shares.from, start / (start - end));
  if (start >= 0 && end < 0) shares.to = std::min(shares.to, start / (start - end));
}

/// Appends the shares at which the edge's line crosses the circle about the origin.
void add_crossings(std::array<double, 8>& at, std::size_t& count, const EdgeTree::Edge& edge, double radius) {
  const Point along = edge.to - edge.from;
  const double a = along.squaredNorm(), b = edge.from.dot(along);
  if (!(a > 0)) return;
  const double squared = radius * radius - edge.from.squaredNorm() + b * b / a;
  if (squared < 0) return;
  const double half = std::sqrt(squared / a);
  at[count++] = -b / a - half;
  at[count++] = -b / a + half;
}

}  // namespace

std::optional<Point> point_in(const Sector& sector, const EdgeTree::Edge& edge) {
  const Point right(std::cos(sector.from), std::sin(sector.from)),
      left(std::cos(sector.to), std::sin(sector.to));
  Shares shares;
  clip(shares, cross(right, edge.from), cross(right, edge.to));
  clip(shares, cross(edge.from, left), cross(edge.to, left));
  if (shares.from > shares.to) return std::nullopt;
  std::array<double, 8> at{shares.from, shares.to, 0.5 * (shares.from + shares.to)};
  std::size_t count = 3;
  // Between neighbouring crossings of both circles the edge stays on one side of each.
  add_crossings(at, count, edge, sector.inner);
  add_crossings(at, count, edge, sector.outer);
  std::sort(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(count));
  const auto try_at = [&](double share) -> std::optional<Point> {
    if (share < shares.from || share > shares.to) return std::nullopt;
    Point point = edge.from + share * (edge.to - edge.from);
    const double distance = point.norm();
    if (distance < sector.inner || distance > sector.outer) return std::nullopt;
    return point;
  };
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (auto point = try_at(0.5 * (at[i] + at[i + 1]))) return point;
  for (std::size_t i = 0; i < count; ++i)
    if (auto point = try_at(at[i])) return point;
  return std::nullopt;
}

Box box_around(const Sector& sector) {
  // The chord's circle sector: its corners, and the outer circle's tangent box where the sector is wide.
  const double middle = 0.5 * (sector.from + sector.to), half = 0.5 * (sector.to - sector.from);
  const Point centre =
      std::polar(1.0, middle).real() * Point::UnitX() + std::polar(1.0, middle).imag() * Point::UnitY();
  const Point side(-centre.y(), centre.x());
  const double near = sector.inner * std::cos(half), wide = sector.outer * std::sin(half);
  Box box{Point::Constant(std::numeric_limits<double>::infinity()),
          Point::Constant(-std::numeric_limits<double>::infinity())};
  for (const double along : {near, sector.outer})
    for (const double across : {-wide, wide}) {
      const Point corner = along * centre + across * side;
      box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
    }
  return box;
}

}  // namespace kempe
