#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/interval.hpp"

namespace kempe {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double four_ulp = 4 * ulp, sixteen_ulp = 16 * ulp;

/// The interval with `slack` more at both ends, whatever way the processor rounds: `slack` leaves room for it.
Interval around(double lower, double upper, double slack) { return {lower - slack, upper + slack}; }

/// A function's value, computed with the processor rounding to nearest. Volatile: a compiler may move other calculations past
/// the change of the processor's mode.
double at_nearest(double (*function)(double), double of) {
  const volatile double argument = of;
  const NearestRounding nearest;
  const volatile double value = function(argument);
  return value;
}

/// A function of slope at most 1 over an interval of angles, from its value in the middle.
Interval of_slope_one(double (*function)(double), const Interval& angle) {
  const double middle = 0.5 * (angle.inf() + angle.sup()), value = at_nearest(function, middle);
  const double away =
      std::max((Interval(angle.sup()) - middle).sup(), (Interval(middle) - angle.inf()).sup());
  const Interval all = around(value, value, away + four_ulp);
  return {std::max(-1.0, all.inf()), std::min(1.0, all.sup())};
}

}  // namespace

Interval widened(double value) {
  const double slack = sixteen_ulp * std::max(1.0, std::abs(value));
  return around(value, value, slack);
}

IntervalComplex widened(Complex z) {
  const double slack = sixteen_ulp * std::max(std::abs(z.real()), std::abs(z.imag()));
  return {around(z.real(), z.real(), slack), around(z.imag(), z.imag(), slack)};
}

Interval cosine(const Interval& angle) { return of_slope_one(std::cos, angle); }
Interval sine(const Interval& angle) { return of_slope_one(std::sin, angle); }

Interval arc_cosine(const Interval& cosine) {
  constexpr double slack = sixteen_ulp;  // four units in the last place of the largest arc, pi
  const auto arc = [](double of) { return at_nearest(std::acos, std::clamp(of, -1.0, 1.0)); };
  const Interval arcs = around(arc(cosine.sup()), arc(cosine.inf()), slack);
  return {std::max(0.0, arcs.inf()), std::min(pi + slack, arcs.sup())};
}

Interval logarithm(const Interval& positive) {
  const double lower = at_nearest(std::log, positive.inf()), upper = at_nearest(std::log, positive.sup());
  return around(lower, upper, four_ulp * std::max({1.0, std::abs(lower), std::abs(upper)}));
}

}  // namespace kempe
