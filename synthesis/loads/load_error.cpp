#include "synthesis/loads/load_error.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/assembly_mode.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

/// Terms c dot(w, F)^2 whose coefficient grows with one power of one length: sums of c |w|^2 and of c w^2.
struct Bucket {
  double trace = 0;
  Complex difference = 0;

  void add(double coefficient, Complex w) {
    trace += coefficient * std::norm(w);
    difference += coefficient * (w * w);
  }
};

/// The same with derivatives.
struct BucketJet {
  OpeningJet trace, difference;  ///< the first is real

  void add(double coefficient, const OpeningJet& w) {
    difference = difference + Complex(coefficient) * (w * w);
    trace.value += coefficient * std::norm(w.value);
    trace.first += coefficient * 2 * (std::conj(w.value) * w.first).real();
    trace.second += coefficient * 2 * (std::norm(w.first) + (std::conj(w.value) * w.second).real());
  }
};

/// The powers of VA and VB that the buckets' terms grow with: bent and pulled with VA, with VB, and with no length.
enum : std::size_t { VA_bent, VA_pulled, VB_bent, VB_pulled, pins_give, bucket_count };
constexpr std::array<double, bucket_count> power_of_VA{3, 1, 0, 0, 0}, power_of_VB{0, 0, 3, 1, 0};

std::array<double, bucket_count> factors_of(const BarLengths& lengths) {
  const double VA = lengths.VA, VB = lengths.VB;
  return {VA * VA * VA, VA, VB * VB * VB, VB, 1};
}

double inertia(const LinkStyle& style) { return style.thickness * std::pow(style.width, 3) / 12; }

}  // namespace

std::array<PlateArm, 2> plate_arms(Complex third, bool straight) {
  using enum PlateArm::End;
  const double x = third.real();
  if (!straight || x < 0) return {{{C, 1}, {PlateArm::End::tip, std::abs(third)}}};
  if (x < 1) return {{{corner, x}, {C, 1 - x}}};
  return {{{corner, 1}, {PlateArm::End::tip, x - 1}}};
}

LoadErrorProfile::LoadErrorProfile(Complex k, Grounding grounding, const LinkStyle& style,
                                   const Material& material, double pen_force, const PinCompliance& pins)
    : shape_(shape_of(k, grounding)), factor_(pen_factor(k, grounding)), straight_(is_straight(shape_)),
      force_(pen_force), across_(1 / (3 * material.E * inertia(style))),
      along_(1 / (material.E * style.width * style.thickness)), pins_(pins),
      has_rigid_pins_(pins.A == 0 && pins.B == 0 && pins.C == 0 && pins.V == 0 && pins.pole == 0),
      pole_is_at_V_(pole_is_at_V(grounding)), arms_ACX_(plate_arms(1.0 / shape_, straight_)),
      arms_BCY_(plate_arms(shape_, straight_)) {}

template <class Buckets, class Forces>
Buckets LoadErrorProfile::sums_of(const Forces& forces) const {
  using W = std::decay_t<decltype(forces.bar_VA)>;
  Buckets sums;
  for (const PlateArm& arm : arms_ACX_) {
    const auto& force = force_at(arm.end, forces.A, forces.C_of_ACX, forces.X);
    sums[VB_bent].add(across_ * arm.cube(), force.across);
    sums[VB_pulled].add(along_ * arm.length, force.along);
  }
  for (const PlateArm& arm : arms_BCY_) {
    const auto& force = force_at(arm.end, forces.B, forces.C_of_BCY, forces.Y);
    sums[VA_bent].add(across_ * arm.cube(), force.across);
    sums[VA_pulled].add(along_ * arm.length, force.along);
  }
  sums[VA_pulled].add(along_, forces.bar_VA);
  sums[VB_pulled].add(along_, forces.bar_VB);
  if (has_rigid_pins_) return sums;
  sums[pins_give].add(pins_.A, forces.bar_VA);
  sums[pins_give].add(pins_.B + pins_.V, forces.bar_VB);
  for (const W& component : forces.pin_C) sums[pins_give].add(pins_.C, component);
  const Complex pole = pole_is_at_V_ ? shape_ - 1.0 : shape_;
  for (const Complex component : {pole, Complex(0, 1) * pole}) sums[pins_give].add(pins_.pole, W{component});
  return sums;
}

LoadErrorProfile::Compliance LoadErrorProfile::compliance(const BarLengths& lengths, double opening) const {
  const auto sums = sums_of<std::array<Bucket, bucket_count>>(link_forces(shape_, opening));
  const auto factors = factors_of(lengths);
  Compliance result{0, 0};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    result.trace += factors[i] * sums[i].trace;
    result.difference += factors[i] * sums[i].difference;
  }
  return result;
}

Complex LoadErrorProfile::displacement(const BarLengths& lengths, double opening, Complex force) const {
  const auto [trace, difference] = compliance(lengths, opening);
  return 0.5 * (std::norm(factor_) * trace * force + factor_ * factor_ * difference * std::conj(force));
}

LoadErrorAt LoadErrorProfile::at(const BarLengths& lengths, double opening) const {
  const auto [trace, difference] = compliance(lengths, opening);
  const double half = 0.5 * force_ * std::norm(factor_), apart = std::abs(difference);
  return {half * (trace + apart), half * std::max(0.0, trace - apart)};
}

LoadErrorJet LoadErrorProfile::worst(const BarLengths& lengths, double opening, bool wants_hessian) const {
  const auto sums = sums_of<std::array<BucketJet, bucket_count>>(link_force_jets(shape_, opening));
  const auto factors = factors_of(lengths);
  LoadErrorJet trace;
  Complex value = 0;
  Eigen::Vector3cd gradient = Eigen::Vector3cd::Zero();
  Eigen::Matrix3cd hessian = Eigen::Matrix3cd::Zero();
  const std::size_t count = has_rigid_pins_ ? pins_give : factors.size();
  for (std::size_t i = 0; i < count; ++i) {
    const OpeningJet t = Complex(factors[i]) * sums[i].trace, d = Complex(factors[i]) * sums[i].difference;
    const Eigen::Vector3d power(power_of_VA[i], power_of_VB[i], 0);
    const Eigen::Vector3d along_opening(0, 0, 1);
    trace.value += t.value.real();
    trace.gradient += t.value.real() * power + t.first.real() * along_opening;
    value += d.value;
    gradient += d.value * power.cast<Complex>() + d.first * along_opening.cast<Complex>();
    if (!wants_hessian) continue;
    const auto curve = [&](const auto& zero, const auto& one, const auto& two) {
      using Scalar = std::decay_t<decltype(zero)>;
      const Eigen::Matrix3d mixed = power * along_opening.transpose() + along_opening * power.transpose();
      return (zero * (power * power.transpose()).template cast<Scalar>() + one * mixed.cast<Scalar>() +
              two * (along_opening * along_opening.transpose()).template cast<Scalar>())
          .eval();
    };
    trace.hessian += curve(t.value.real(), t.first.real(), t.second.real());
    hessian += curve(d.value, d.first, d.second);
  }
  const double apart = std::abs(value), half = 0.5 * force_ * std::norm(factor_);
  LoadErrorJet jet{half * (trace.value + apart), half * trace.gradient, half * trace.hessian};
  if (apart == 0) return jet;
  const Complex direction = std::conj(value) / apart;
  const Eigen::Vector3d slope = (direction * gradient).real();
  jet.gradient += half * slope;
  if (!wants_hessian) return jet;
  jet.hessian +=
      half * ((direction * hessian).real() +
              ((gradient.conjugate() * gradient.transpose()).real() - slope * slope.transpose()) / apart);
  return jet;
}

double LoadErrorProfile::worst_opening(const BarLengths& lengths, const OpeningInterval& openings) const {
  return top_over(openings, [&](double opening) { return at(lengths, opening).worst; });
}

LoadErrorProfile::Range LoadErrorProfile::over(const BarLengths& lengths,
                                               const OpeningInterval& openings) const {
  const double worst = worst_opening(lengths, openings);
  const double least = top_over(openings, [&](double opening) { return -at(lengths, opening).least; });
  return {at(lengths, worst).worst, at(lengths, least).least, worst, least};
}

double LoadErrorProfile::worst_over(const BarLengths& lengths, const OpeningInterval& openings) const {
  return at(lengths, worst_opening(lengths, openings)).worst;
}

LoadErrorProfile load_error_profile(const Spec& spec, Complex k, Grounding grounding) {
  return {k, grounding, spec.links.style, spec.material.value_or(Material{}),
          most_force_at_pen(spec.load.value_or(Load{}))};
}

}  // namespace kempe
