#include "kinematics/planar/driver_motion.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

constexpr int cubic_steps = 64;

using Controls = std::array<Point, 4>;

Point cubic_at(const Controls& c, double u) {
  const double v = 1 - u;
  return v * v * v * c[0] + 3 * v * v * u * c[1] + 3 * v * u * u * c[2] + u * u * u * c[3];
}

Point cubic_slope(const Controls& c, double u) {
  const double v = 1 - u;
  return 3 * (v * v * (c[1] - c[0]) + 2 * v * u * (c[2] - c[1]) + u * u * (c[3] - c[2]));
}

Point cubic_second(const Controls& c, double u) {
  return 6 * ((1 - u) * (c[2] - 2 * c[1] + c[0]) + u * (c[3] - 2 * c[2] + c[1]));
}

/// Arc length between two parameters by Gauss's rule with five places.
double cubic_length(const Controls& c, double from, double to) {
  constexpr std::array<double, 3> place{0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = weight[0] * cubic_slope(c, middle).norm();
  for (std::size_t i = 1; i < 3; ++i)
    sum += weight[i] * (cubic_slope(c, middle - half * place[i]).norm() +
                        cubic_slope(c, middle + half * place[i]).norm());
  return sum * half;
}

Point on_circle(const Point& centre, double radius, double angle) {
  return centre + radius * Point(std::cos(angle), std::sin(angle));
}

}  // namespace

PathPiece PathPiece::line(const Point& from, const Point& to) {
  PathPiece piece;
  piece.points_ = {from, to, Point::Zero(), Point::Zero()};
  piece.length_ = (to - from).norm();
  return piece;
}

PathPiece PathPiece::arc(const Point& centre, double radius, double start, double sweep) {
  PathPiece piece;
  piece.kind_ = Kind::arc;
  piece.points_ = {centre, Point::Zero(), Point::Zero(), Point::Zero()};
  piece.radius_ = radius;
  piece.start_ = start;
  piece.sweep_ = sweep;
  piece.length_ = radius * std::abs(sweep);
  return piece;
}

PathPiece PathPiece::cubic(const Point& a, const Point& b, const Point& c, const Point& d) {
  PathPiece piece;
  piece.kind_ = Kind::cubic;
  piece.points_ = {a, b, c, d};
  piece.cubic_lengths_.push_back(0);
  for (int i = 0; i < cubic_steps; ++i)
    piece.cubic_lengths_.push_back(piece.cubic_lengths_.back() + cubic_length(piece.points_,
                                                                              double(i) / cubic_steps,
                                                                              double(i + 1) / cubic_steps));
  piece.length_ = piece.cubic_lengths_.back();
  return piece;
}

std::optional<double> PathPiece::most_curved() const {
  if (kind_ == Kind::cubic) return std::nullopt;
  return kind_ == Kind::arc ? 1 / radius_ : 0.0;
}

PathPlace PathPiece::at(double way) const {
  const double share = length_ > 0 ? std::clamp(way / length_, 0.0, 1.0) : 0;
  if (kind_ == Kind::cubic) return on_cubic(std::clamp(way, 0.0, length_));
  if (kind_ == Kind::line) {
    const Point ahead = points_[1] - points_[0];
    return {points_[0] + share * ahead, ahead.normalized(), Point::Zero()};
  }
  const double angle = start_ + share * sweep_;
  const Point out(std::cos(angle), std::sin(angle));
  const Point ahead = sweep_ > 0 ? Point(-out.y(), out.x()) : Point(out.y(), -out.x());
  return {on_circle(points_[0], radius_, angle), ahead, -out / radius_};
}

/// The parameter for an arc length: the table's interval, then Newton.
PathPlace PathPiece::on_cubic(double way) const {
  const auto above = std::upper_bound(cubic_lengths_.begin() + 1, cubic_lengths_.end() - 1, way);
  const auto step = static_cast<double>(above - cubic_lengths_.begin()) - 1;
  const double from = step / cubic_steps, before = *(above - 1), here = *above - before;
  double u = from + (here > 0 ? (way - before) / here : 0) / cubic_steps;
  for (int i = 0; i < 6; ++i) {
    const double speed = cubic_slope(points_, u).norm();
    if (speed > 0) u = std::clamp(u - (before + cubic_length(points_, from, u) - way) / speed, 0.0, 1.0);
  }
  const Point slope = cubic_slope(points_, u), second = cubic_second(points_, u);
  const double speed = slope.norm();
  if (!(speed > 0)) return {cubic_at(points_, u), (points_[3] - points_[0]).normalized(), Point::Zero()};
  const Point ahead = slope / speed;
  return {cubic_at(points_, u), ahead, (second - second.dot(ahead) * ahead) / (speed * speed)};
}

DriverPath::DriverPath(std::vector<PathPiece> pieces, std::optional<double> even_speed)
    : speed(even_speed), pieces_(std::move(pieces)) {
  for (const PathPiece& piece : pieces_) ends_.push_back(length_ += piece.length());
  for (double& end : ends_) end /= length_;
  if (!ends_.empty()) ends_.back() = 1;
}

double DriverPath::extent() const {
  const Point start = pieces_.front().begin();
  double result = 0;
  for (const PathPiece& piece : pieces_)
    for (const double share : {0.25, 0.5, 0.75, 1.0})
      result = std::max(result, (piece.at(share * piece.length()).at - start).norm());
  return result;
}

std::size_t DriverPath::piece_at(double share) const {
  return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end() - 1, share) - ends_.begin());
}

PathPlace DriverPath::at(double share) const {
  const std::size_t number = piece_at(share);
  const double begin = number == 0 ? 0 : ends_[number - 1];
  return pieces_[number].at((share - begin) * length_);
}

}  // namespace kempe
