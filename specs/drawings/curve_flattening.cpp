#include "specs/drawings/curve_flattening.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/regions/region_checks.hpp"

namespace kempe {

bool is_sound(const DrawnStroke& stroke) {
  return std::all_of(stroke.points.begin(), stroke.points.end(), [](const Point& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= largest_coordinate;
  });
}

void CurveFlattener::add(const Point& mapped) {
  if (is_full() || (!stroke_.points.empty() && stroke_.points.back() == mapped)) return;
  stroke_.points.push_back(mapped);
  ++points_;
}

int CurveFlattener::steps_for(double bend) const {
  // A chord over a step h of the parameter departs from the curve by at most bend h^2 / 8.
  constexpr double most = 100'000;
  const double steps = std::ceil(std::sqrt(bend / (8 * tolerance_)));
  if (std::isnan(steps)) return static_cast<int>(most);  // the points show that the curve is not finite
  return static_cast<int>(std::clamp(steps, 1.0, most));
}

void CurveFlattener::finish_stroke(bool closed) {
  if (closed && stroke_.points.size() > 1 && stroke_.points.front() == stroke_.points.back())
    stroke_.points.pop_back();
  stroke_.closed = closed && stroke_.points.size() > 2;
  if (stroke_.points.size() > 1) strokes_.push_back(std::move(stroke_));
  stroke_ = {};
}

void CurveFlattener::move_to(const Point& to) {
  finish_stroke(false);
  pen_ = start_ = to;
}

void CurveFlattener::line_to(const Point& to) {
  add(map_ * pen_);
  add(map_ * to);
  pen_ = to;
}

void CurveFlattener::quadratic_to(const Point& control, const Point& to) {
  const Point a = map_ * pen_, b = map_ * control, c = map_ * to;
  const int steps = steps_for(2 * (a - 2 * b + c).norm());
  add(a);
  for (int i = 1; i < steps && !is_full(); ++i) {
    const double t = static_cast<double>(i) / steps, u = 1 - t;
    add(u * u * a + 2 * u * t * b + t * t * c);
  }
  add(c);
  pen_ = to;
}

void CurveFlattener::cubic_to(const Point& control1, const Point& control2, const Point& to) {
  const Point a = map_ * pen_, b = map_ * control1, c = map_ * control2, d = map_ * to;
  const int steps = steps_for(6 * std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm()));
  add(a);
  for (int i = 1; i < steps && !is_full(); ++i) {
    const double t = static_cast<double>(i) / steps, u = 1 - t;
    add(u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
  }
  add(d);
  pen_ = to;
}

namespace {

/// How far u cos t + v sin t is from 0 at most: the larger singular value of (u v).
double farthest(const Point& u, const Point& v) {
  const double unit =
      std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());  // squares of large radii overflow
  if (!(unit > 0) || std::isinf(unit)) return unit;
  const Point a = u / unit, b = v / unit;
  const double sum = a.squaredNorm() + b.squaredNorm(), area = cross(a, b);
  return unit * std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * area * area))));
}

}  // namespace

double CurveFlattener::own_tolerance() const {
  return tolerance_ / std::max(1e-300, farthest(map_.linear().col(0), map_.linear().col(1)));
}

void CurveFlattener::elliptic_to(const Point& centre, const Point& a, const Point& b, double from,
                                 double sweep, const Point& to) {
  const Point middle = map_ * centre, u = map_.linear() * a, v = map_.linear() * b;
  const int steps = std::max(steps_for(farthest(u, v) * sweep * sweep),
                             static_cast<int>(std::ceil(std::abs(sweep) / (pi / 4))));
  add(map_ * pen_);
  for (int i = 1; i < steps && !is_full(); ++i) {
    const double t = from + sweep * i / steps;
    add(middle + u * std::cos(t) + v * std::sin(t));
  }
  add(map_ * to);
  pen_ = to;
}

void CurveFlattener::close() {
  finish_stroke(true);
  pen_ = start_;
}

std::vector<DrawnStroke> CurveFlattener::take() {
  finish_stroke(false);
  return std::move(strokes_);
}

}  // namespace kempe
