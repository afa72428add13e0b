#include "synthesis/functions/error.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

double within_half_turn(double angle) {
  return std::abs(angle) <= pi ? angle : std::remainder(angle, 2 * pi);
}

/// The closed loop, its input crank's start turned by every place's own turn.
class Values {
 public:
  Values(const GeneratorVector& u, const Starts& start, FourBarBranch branch)
      : a_(std::exp(u[0])), c_(std::exp(u[2])), squares_(c_ * c_ - std::exp(2 * u[1])),
        cosine_(std::cos(start.input)), sine_(std::sin(start.input)), output_(start.output),
        side_(branch == FourBarBranch::first ? -1 : 1) {}

  double at(const WantedPlace& place) const {
    const double px = a_ * (cosine_ * place.cosine - sine_ * place.sine) - 1;
    const double py = a_ * (sine_ * place.cosine + cosine_ * place.sine), e_squared = px * px + py * py;
    const double beside =
        std::acos(std::clamp((e_squared + squares_) / (2 * c_ * std::sqrt(e_squared)), -1.0, 1.0));
    return within_half_turn(std::atan2(py, px) + side_ * beside - output_ - place.output_turn);
  }

 private:
  double a_, c_, squares_, cosine_, sine_, output_, side_;
};

}  // namespace

double GeneratorError::value_at(const GeneratorVector& u, double x) const {
  return Values(u, starts(u), branch_).at(wanted_->place_at(x));
}

std::vector<double> GeneratorError::values(const GeneratorVector& u,
                                           const std::vector<WantedPlace>& places) const {
  const Values values(u, starts(u), branch_);
  std::vector<double> all;
  all.reserve(places.size());
  for (const WantedPlace& place : places) all.push_back(values.at(place));
  return all;
}

GeneratorVector GeneratorError::unknowns_of(const FunctionDesign& design) const {
  const FourBar& bar = design.linkage;
  GeneratorVector u(size());
  u.head<3>() << std::log(bar.input / bar.ground), std::log(bar.coupler / bar.ground),
      std::log(bar.output / bar.ground);
  Eigen::Index next = 3;
  if (free_input()) u[next++] = design.input_start;
  if (free_output()) u[next] = design.output_start;
  return u;
}

FourBar GeneratorError::linkage(const GeneratorVector& u) const {
  const double d = task_->ground;
  return {d, d * std::exp(u[0]), d * std::exp(u[1]), d * std::exp(u[2]), branch_};
}

Starts GeneratorError::starts(const GeneratorVector& u) const {
  Eigen::Index next = 3;
  Starts starts{};
  starts.input = free_input() ? u[next++] : *task_->input_start;
  starts.output = free_output() ? u[next] : *task_->output_start;
  return starts;
}

Sloped GeneratorError::at(const GeneratorVector& u, const WantedPlace& place) const {
  const double a = std::exp(u[0]), b = std::exp(u[1]), c = std::exp(u[2]);
  const Starts start = starts(u);
  const double phi = start.input + place.input_turn;
  const double px = a * std::cos(phi) - 1, py = a * std::sin(phi), e = std::hypot(px, py);
  const double beside = std::acos(std::clamp((e * e + c * c - b * b) / (2 * e * c), -1.0, 1.0));
  const double psi = std::atan2(py, px) + (branch_ == FourBarBranch::first ? -beside : beside);
  Sloped error{within_half_turn(psi - start.output - place.output_turn), GeneratorVector::Zero(size())};
  const double cos_both = std::cos(phi - psi), sin_both = std::sin(phi - psi);
  const double slope_psi = -c * std::sin(psi) - a * c * sin_both;
  if (!(beside > 0 && beside < pi) || slope_psi == 0) return error;
  error.slope[0] = -a * (a - std::cos(phi) - c * cos_both) / slope_psi;
  error.slope[1] = b * b / slope_psi;
  error.slope[2] = -c * (c + std::cos(psi) - a * cos_both) / slope_psi;
  Eigen::Index next = 3;
  if (free_input()) error.slope[next++] = -(a * std::sin(phi) + a * c * sin_both) / slope_psi;
  if (free_output()) error.slope[next] = -1;
  return error;
}

std::pair<double, bool> GeneratorError::extreme_input(const GeneratorVector& u, int sign) const {
  const double first = starts(u).input, last = first + task_->input_range;
  const double top = sign > 0 ? 0 : pi;
  const double nearest = top + 2 * pi * std::round((0.5 * (first + last) - top) / (2 * pi));
  if (nearest > std::min(first, last) && nearest < std::max(first, last)) return {nearest, false};
  return {sign * std::cos(first) > sign * std::cos(last) ? first : last, true};
}

Sloped GeneratorError::cosine(const GeneratorVector& u, int sign) const {
  const double a = std::exp(u[0]), b = std::exp(u[1]), c = std::exp(u[2]);
  const auto [phi, moves] = extreme_input(u, sign);
  const double value = (b * b + c * c - a * a - 1 + 2 * a * std::cos(phi)) / (2 * b * c);
  Sloped cosine{value, GeneratorVector::Zero(size())};
  cosine.slope[0] = (-a * a + a * std::cos(phi)) / (b * c);
  cosine.slope[1] = b / c - value;
  cosine.slope[2] = c / b - value;
  if (free_input() && moves) cosine.slope[3] = -a * std::sin(phi) / (b * c);
  return cosine;
}

Sloped GeneratorError::largest_cosine(const GeneratorVector& u) const { return cosine(u, 1); }
Sloped GeneratorError::smallest_cosine(const GeneratorVector& u) const { return cosine(u, -1); }

}  // namespace kempe
