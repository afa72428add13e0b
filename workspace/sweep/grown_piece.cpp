#include "workspace/sweep/grown_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workspace/sweep/slack.hpp"

namespace kempe::sweep {

GrownPiece::GrownPiece(const std::array<Point, 3>& corners, int count, double half_width)
    : count_(count), half_width_(half_width) {
  for (std::size_t i = 0; i < size(); ++i) {
    Side& side = sides_[i];
    side.from = corners[i];
    side.along = corners[(i + 1) % size()] - corners[i];
    side.length = side.along.norm();
    if (side.length > 0) side.along /= side.length;
    side.outward = {side.along.y(), -side.along.x()};
    side.height = side.outward.dot(side.from) + half_width;
    side.away = side.from.norm();
    side.from_bearing = std::atan2(side.from.y(), side.from.x());
    side.outward_bearing = std::atan2(side.outward.y(), side.outward.x());
  }
}

double GrownPiece::nearest() const {
  return std::max(0.0, std::sqrt(squared_distance(Point::Zero())) - half_width_);
}

double GrownPiece::farthest() const {
  double far = 0;
  for (std::size_t i = 0; i < size(); ++i) far = std::max(far, sides_[i].away);
  return far + half_width_;
}

void GrownPiece::angles_in(double rho, std::vector<Bearings>& found) const {
  found.clear();
  Crossings angles;
  crossings(rho, angles);
  if (angles.count == 0) {
    if (has(rho, 0)) found.push_back({0, 2 * pi});
    return;
  }
  for (std::size_t i = 0; i < angles.count; ++i) {
    const double from = angles.at[i], to = i + 1 < angles.count ? angles.at[i + 1] : angles.at[0] + 2 * pi;
    if (!has(rho, 0.5 * (from + to))) continue;
    if (!found.empty() && found.back().to == from)
      found.back().to = to;
    else
      found.push_back({from, to});
  }
}

double GrownPiece::squared_distance(const Point& point) const {
  double least = std::numeric_limits<double>::infinity();
  bool inside = count_ == 3;
  for (std::size_t i = 0; i < size(); ++i) {
    const Side& side = sides_[i];
    const Point from = point - side.from;
    const double share = std::clamp(from.dot(side.along), 0.0, side.length);
    least = std::min(least, (from - share * side.along).squaredNorm());
    inside = inside && side.outward.dot(from) < 0;
  }
  return inside ? 0 : least;
}

bool GrownPiece::has(double rho, double bearing) const {
  return squared_distance(rho * Point(std::cos(bearing), std::sin(bearing))) <= half_width_ * half_width_;
}

void GrownPiece::crossings(double rho, Crossings& found) const {
  const double slack = end_slack * (rho + half_width_);
  for (std::size_t i = 0; i < size(); ++i) {
    const Side &side = sides_[i], &before = sides_[(i + size() - 1) % size()];
    if (side.away > 0) {
      // The circle passes that of the corner at two points, beyond both edges where they are of the outline.
      const double forth = (rho * rho + side.away * side.away - half_width_ * half_width_) / (2 * side.away);
      if (std::abs(forth) < rho) {
        const double aside = std::sqrt(rho * rho - forth * forth), half = std::acos(forth / rho);
        const Point ahead = side.from / side.away, left(-ahead.y(), ahead.x());
        for (const double sign : {-1.0, 1.0}) {
          const Point out = forth * ahead + sign * aside * left - side.from;
          if (out.dot(side.along) <= slack && out.dot(before.along) >= -slack)
            found.add(side.from_bearing + sign * half);
        }
      }
    }
    if (side.length > 0 && std::abs(side.height) < rho) {
      const double aside = std::sqrt(rho * rho - side.height * side.height),
                   half = std::acos(side.height / rho);
      const double start = side.from.dot(side.along);
      for (const double sign : {-1.0, 1.0}) {  // `along` lies a quarter turn ahead of `outward`
        const double share = sign * aside - start;
        if (share >= -slack && share <= side.length + slack) found.add(side.outward_bearing + sign * half);
      }
    }
  }
  std::sort(found.at.begin(), found.at.begin() + static_cast<std::ptrdiff_t>(found.count));
}

}  // namespace kempe::sweep
