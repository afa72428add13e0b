#include "kinematics/four_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/slack.hpp"

namespace kempe {

std::string_view name(CrankMotion motion) {
  switch (motion) {
    case CrankMotion::crank_rocker: return "crank-rocker";
    case CrankMotion::double_crank: return "double crank";
    case CrankMotion::rocker_crank: return "rocker-crank";
    case CrankMotion::double_rocker: return "double rocker";
    case CrankMotion::change_point: return "change point";
  }
  return "";
}

FreudensteinCoefficients FourBar::coefficients() const {
  const double a = input, b = coupler, c = output, d = ground;
  return {d / a, d / c, (a * a - b * b + c * c + d * d) / (2 * a * c)};
}

double FourBar::closure_margin(double input_angle) const {
  const double e = std::abs(ground - std::polar(input, input_angle));
  const double reach = coupler + output;
  return (reach - e) * (e - std::abs(coupler - output)) / (reach * reach);
}

std::optional<double> FourBar::output_angle(double input_angle) const {
  if (!(closure_margin(input_angle) >= 0)) return std::nullopt;
  // The output pivot sees the input crank's pin under `sight`; the triangle (e, b, c) gives the angle beside
  // it.
  const Complex to_pin = std::polar(input, input_angle) - ground;
  const double e = std::abs(to_pin);
  if (e == 0) return std::nullopt;
  const double cosine = (e * e + output * output - coupler * coupler) / (2 * e * output);
  const double beside = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double angle = std::arg(to_pin) + (branch == FourBarBranch::first ? -beside : beside);
  return std::arg(std::polar(1.0, angle));
}

std::optional<double> FourBar::transmission_angle(double input_angle) const {
  if (!(closure_margin(input_angle) >= 0)) return std::nullopt;
  const double e = std::abs(ground - std::polar(input, input_angle));
  const double cosine = (coupler * coupler + output * output - e * e) / (2 * coupler * output);
  return std::acos(std::min(1.0, std::abs(cosine)));
}

std::optional<double> FourBar::least_transmission_angle(double first, double last) const {
  const auto [low, high] = std::minmax(first, last);
  double least = pi / 2;
  const auto look = [&](double angle) {
    const auto here = transmission_angle(angle);
    least = here ? std::min(least, *here) : -1;
    return here.has_value();
  };
  if (!look(first) || !look(last)) return std::nullopt;
  // Where cos of the input angle is +-1.
  for (double half_turns = std::ceil(low / pi); half_turns * pi < high; ++half_turns)
    if (!look(half_turns * pi)) return std::nullopt;
  return least;
}

CrankMotion FourBar::motion() const {
  std::array<double, 4> sorted{ground, input, coupler, output};
  std::sort(sorted.begin(), sorted.end());
  const double excess = sorted[0] + sorted[3] - sorted[1] - sorted[2];
  if (std::abs(excess) <= slack::balanced_bars * sorted[3]) return CrankMotion::change_point;
  if (excess > 0) return CrankMotion::double_rocker;
  if (sorted[0] == input) return CrankMotion::crank_rocker;
  if (sorted[0] == ground) return CrankMotion::double_crank;
  return sorted[0] == output ? CrankMotion::rocker_crank : CrankMotion::double_rocker;
}

std::optional<DirectedFourBar> four_bar_from(const FreudensteinCoefficients& k, double ground) {
  if (!std::isfinite(k.K1) || !std::isfinite(k.K2) || !std::isfinite(k.K3) || k.K1 == 0 || k.K2 == 0)
    return std::nullopt;
  const double a = ground / k.K1, c = ground / k.K2;  // directed: a negative length points the other way
  const double b_squared = a * a + c * c + ground * ground - 2 * a * c * k.K3;
  const double largest = std::max({std::abs(a), std::abs(c), ground});
  if (!std::isfinite(b_squared) || b_squared <= slack::no_coupler * largest * largest) return std::nullopt;
  return DirectedFourBar{{ground, std::abs(a), std::sqrt(b_squared), std::abs(c)}, a < 0, c < 0};
}

}  // namespace kempe
