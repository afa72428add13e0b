#include "synthesis/problem/smooth_reach.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

const double log_two = std::log(2.0);

}  // namespace

Reach::Reach(Complex k, Grounding grounding, int assembly_mode)
    : s_(shape_of(k, grounding)), direction_of_s_(s_ / std::abs(s_)),
      chain_(chain_length_per_tracer(k, grounding)), log_s_(std::log(std::abs(s_))), arg_s_(std::arg(s_)),
      interval_(assembly_modes(s_)[static_cast<std::size_t>(assembly_mode)].openings),
      lower_end_(std::polar(1.0, interval_.lower)), upper_end_(std::polar(1.0, interval_.upper)) {
  bend_ = std::sin(interval_.middle() - arg_s_) > 0 ? 1 : -1;
  near_is_lower_ = bend_ < 0;
  const double scale = std::abs(s_), turn = std::abs(1.0 - s_);
  factors_ = {std::min({1.0, scale, turn}),       std::max({1.0, scale, turn}),
              std::min({1.0, 1.0, turn}) / scale, std::max({1.0, 1.0, turn}) / scale,
              1 + 0.5 * (1 + scale + turn),       1 + 0.5 * (1 + (1 + turn) / scale)};
  factors_.least_of_VB = std::min(1.0, std::min(1.0, turn) / scale);
  factors_.most_of_VB = std::max(1.0, std::max(1.0, turn) / scale);
}

LinkageJet Reach::radius(const LogLengths& lengths, double opening) const {
  const double a = std::exp(lengths.u), b = std::exp(lengths.v - log_s_);
  const double ab_cos = a * b * std::cos(opening - arg_s_), ab_sin = a * b * std::sin(opening - arg_s_);
  const double W = std::max(a * a + b * b + 2 * ab_cos, slack::above_zero);
  const Eigen::Vector3d W1(2 * a * a + 2 * ab_cos, 2 * b * b + 2 * ab_cos, -2 * ab_sin);
  Eigen::Matrix3d W2;
  W2 << 4 * a * a + 2 * ab_cos, 2 * ab_cos, -2 * ab_sin,  //
      2 * ab_cos, 4 * b * b + 2 * ab_cos, -2 * ab_sin,    //
      -2 * ab_sin, -2 * ab_sin, -2 * ab_cos;
  const double w = std::sqrt(W);
  return {w / chain_, W1 / (2 * w * chain_), (W2 / (2 * w) - W1 * W1.transpose() / (4 * w * W)) / chain_};
}

double Reach::radius_value(const LogLengths& lengths, double opening) const {
  const double a = std::exp(lengths.u), b = std::exp(lengths.v - log_s_);
  return std::abs(a + std::polar(b, opening - arg_s_)) / chain_;
}

SideLengths Reach::sides(const LogLengths& lengths) const {
  return {std::exp(lengths.u), std::exp(lengths.v), std::exp(lengths.v - log_s_)};
}

// tan^2(psi/2) = outer / inner keeps its digits at both dead points, unlike acos. Out of reach one of them is 0.
Reach::HalfAngle Reach::half_angle(const SideLengths& sides, double radius) const {
  const double a = sides.VA, b = sides.b, w = radius * chain_;
  return {std::max(0.0, (a + b - w) * (a + b + w)),
          std::max(0.0, (w - std::abs(a - b)) * (w + std::abs(a - b)))};
}

Complex Reach::direction_at(const SideLengths& sides, double radius) const {
  const auto [outer, inner] = half_angle(sides, radius);
  const Complex half(std::sqrt(inner), bend_ * std::sqrt(outer));
  const Complex direction = direction_of_s_ * (half * half) / (outer + inner);
  if (cross(lower_end_, direction) > 0 && cross(direction, upper_end_) > 0) return direction;
  return std::polar(1.0, opening_at(sides, radius));  // at an end, or none is reached
}

double Reach::opening_at(const SideLengths& sides, double radius) const {
  const auto [outer, inner] = half_angle(sides, radius);
  double opening = arg_s_ + bend_ * 2 * std::atan2(std::sqrt(outer), std::sqrt(inner));
  opening -= 2 * pi * std::round((opening - interval_.middle()) / (2 * pi));
  return std::clamp(opening, interval_.lower, interval_.upper);
}

double Reach::from_near_end(double opening) const {
  return near_is_lower_ ? opening - interval_.lower : interval_.upper - opening;
}

double Reach::from_far_end(double opening) const {
  return near_is_lower_ ? interval_.upper - opening : opening - interval_.lower;
}

double Reach::near_cosine(const OpeningInterval& allowed) const {
  return std::cos((near_is_lower_ ? allowed.lower : allowed.upper) - arg_s_);
}

double Reach::far_cosine(const OpeningInterval& allowed) const {
  return std::cos((near_is_lower_ ? allowed.upper : allowed.lower) - arg_s_);
}

std::optional<double> Reach::lambda_limit(double r_min, double r_max, const OpeningInterval& allowed) const {
  if (allowed.empty() || !(r_min > 0)) return std::nullopt;
  const double near = near_cosine(allowed), far = far_cosine(allowed);
  const double q2 = (r_max * r_max) / (r_min * r_min);
  if (!std::isfinite(q2) || far - q2 * near < q2 - 1) return std::nullopt;
  constexpr double most = 50;  // b = e^50 VA: far beyond any box of lengths
  if (q2 - 1 < slack::point_like) return most;
  return std::min(most, std::acosh(std::max(1.0, (far - q2 * near) / (q2 - 1))));
}

LogRange Reach::log_m_range(double lambda, double r_min, double r_max, const OpeningInterval& allowed) const {
  const double h = std::cosh(lambda);
  return {std::log(chain_ * r_max) - 0.5 * std::log(h + far_cosine(allowed)),
          std::log(chain_ * r_min) - 0.5 * std::log(std::max(h + near_cosine(allowed), slack::above_zero))};
}

LogRange Reach::log_m_range(double lambda, const LogBox& box) const {
  return {0.5 * log_two + std::max(box.u.lower + 0.5 * lambda, box.v.lower - log_s_ - 0.5 * lambda),
          0.5 * log_two + std::min(box.u.upper + 0.5 * lambda, box.v.upper - log_s_ - 0.5 * lambda)};
}

LogRange Reach::lambda_range(const LogBox& box) const {
  return {box.v.lower - log_s_ - box.u.upper, box.v.upper - log_s_ - box.u.lower};
}

LogLengths Reach::lengths(double lambda, double log_m) const {
  return {log_m - 0.5 * log_two - 0.5 * lambda, log_m - 0.5 * log_two + 0.5 * lambda + log_s_};
}

}  // namespace kempe
