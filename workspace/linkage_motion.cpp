#include "workspace/linkage_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kempe {
namespace {

/// The product as a point. That of std::complex asks for NaN first, which no place or turn is.
Point rotated(Complex z, Complex turn) {
  return {z.real() * turn.real() - z.imag() * turn.imag(), z.real() * turn.imag() + z.imag() * turn.real()};
}

/// std::abs() guards against overflow, which lengths in mm are far from, at four times the cost.
double size_of(Complex z) { return std::sqrt(std::norm(z)); }

}  // namespace

LinkageMotion::LinkageMotion(const CopyingLinkage& linkage) : LinkageMotion(linkage, linkage.pole_joint()) {}

LinkageMotion::LinkageMotion(const CopyingLinkage& linkage, Joint seen_from)
    : VA_(linkage.VA()), VB_(linkage.VB()), chain_end_(linkage.VB() / std::abs(linkage.shape())),
      per_shape_(1.0 / linkage.shape()) {
  const JointWeights origin = weights_of(seen_from, linkage.shape());
  for (const Joint joint : all_joints) {
    const JointWeights weights = weights_of(joint, linkage.shape());
    const auto i = static_cast<std::size_t>(joint);
    a_[i] = weights.of_p - origin.of_p;
    b_[i] = weights.of_q - origin.of_q;
    p_size_[i] = std::abs(a_[i]) * VA_;
    q_size_[i] = std::abs(b_[i]) * VB_;
  }
  // The tracer, seen from the pole, is a fixed multiple of the chain p + q/s: its multiple of p.
  tracer_per_chain_ = weights_of(linkage.tracer_joint(), linkage.shape()).of_p -
                      weights_of(linkage.pole_joint(), linkage.shape()).of_p;
}

OpeningJoints LinkageMotion::over_openings(double opening, double half_opening) const {
  const Complex q_from_p = std::polar(VB_ / VA_, opening);
  const Complex end_from_p = q_from_p * per_shape_;                   // q/s for p = 1
  const Complex unturned = (1.0 + end_from_p) * tracer_per_chain_;    // the tracer for p = 1
  const Complex p = (VA_ / size_of(unturned)) * std::conj(unturned);  // with the tracer at bearing 0
  const Complex q = p * q_from_p;
  const auto squared_chain = [&](const Complex& end) { return VA_ * VA_ * std::norm(1.0 + end); };
  const Complex half_turn = std::polar(1.0, half_opening);
  const double difference = VA_ * VA_ - chain_end_ * chain_end_;
  const auto turning = [&](double squared) { return 0.5 + 0.5 * difference / squared; };  // g'
  const double here = turning(std::max(squared_chain(end_from_p), std::numeric_limits<double>::min()));
  const double one = squared_chain(end_from_p * std::conj(half_turn)),
               other = squared_chain(end_from_p * half_turn);
  const double least = std::max(std::min(one, other), std::numeric_limits<double>::min());
  const double g1 =
      std::max(std::abs(turning(std::max(one, least))), std::abs(turning(std::max(other, least))));
  const double f1 =
      std::max(std::abs(turning(std::max(one, least)) - 1), std::abs(turning(std::max(other, least)) - 1));
  const double bend = std::abs(difference) * std::min(VA_, chain_end_) / (least * std::sqrt(least));

  OpeningJoints over{half_opening, {}};
  for (std::size_t i = 0; i < 6; ++i) {
    const Complex of_p = a_[i] * p;
    const Complex at = of_p + b_[i] * q;
    const Complex unturned_slope = here * at - of_p;  // (here - 1) of_p + here of_q
    const Complex by_opening(-unturned_slope.imag(), unturned_slope.real());
    const double p_size = p_size_[i], q_size = q_size_[i];
    const double speed = size_of(by_opening);
    const double bowed =
        0.5 * half_opening * half_opening * (p_size * (bend + f1 * f1) + q_size * (bend + g1 * g1));
    const double reach = std::min(half_opening * (f1 * p_size + g1 * q_size), half_opening * speed + bowed);
    over.joints[i] = {at, by_opening, size_of(at), speed, bowed, reach};
  }
  return over;
}

MovingJoints LinkageMotion::turned(const OpeningJoints& over, Complex turn, double half_bearing) {
  MovingJoints joints;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [at, by_opening, far, speed, bowed, reach] = over.joints[i];
    const double rest =
        bowed + 0.5 * far * half_bearing * half_bearing + half_bearing * (speed * over.half_opening + bowed);
    joints[i] = {rotated(at, turn),
                 rotated(by_opening, turn),
                 far,
                 speed,
                 rest,
                 std::min(far * half_bearing, 2 * far) + reach};
  }
  return joints;
}

double LinkageMotion::farthest(Joint joint) const {
  const auto i = static_cast<std::size_t>(joint);
  return p_size_[i] + q_size_[i];
}

}  // namespace kempe
