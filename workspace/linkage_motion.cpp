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

LinkageMotion::LinkageMotion(const CopyingLinkage& linkage, Joint seen_from,
                             const std::vector<LinkagePoint>& points)
    : VA_(linkage.VA()), VB_(linkage.VB()), chain_end_(linkage.VB() / std::abs(linkage.shape())),
      per_shape_(1.0 / linkage.shape()) {
  const LinkagePoint origin = linkage_point(seen_from, linkage.shape());
  for (const Joint joint : all_joints) {
    const LinkagePoint point = linkage_point(joint, linkage.shape());
    places_[static_cast<std::size_t>(joint)] = place_of(point.of_p - origin.of_p, point.of_q - origin.of_q);
  }
  for (const LinkagePoint& point : points)
    points_.push_back(place_of(point.of_p - origin.of_p, point.of_q - origin.of_q));
  // The tracer, seen from the pole, is a fixed multiple of the chain p + q/s: its multiple of p.
  tracer_per_chain_ = linkage_point(linkage.tracer_joint(), linkage.shape()).of_p -
                      linkage_point(linkage.pole_joint(), linkage.shape()).of_p;
}

LinkageMotion::LinkageMotion(const CopyingLinkage& linkage, Link seen_from,
                             const std::vector<LinkagePoint>& points)
    : LinkageMotion(linkage, end_of(seen_from), points) {
  seen_from_link_ = true;
  link_along_p_ = is_along_p(seen_from);
  link_axis_ = axis_at_end(seen_from, linkage.shape());
}

OpeningJoints LinkageMotion::over_openings_from_link(double opening, double half_opening) const {
  const double sense = link_along_p_ ? 1 : -1;
  const Complex turn = std::polar(1.0, sense * opening), unturned = std::conj(link_axis_);
  const auto seen = [&](const Place& place) -> OpeningJoint {
    const Complex of_p = place.a * VA_, of_q = place.b * VB_;
    const Complex moving = unturned * turn * (link_along_p_ ? of_q : of_p);
    const Complex at = unturned * (link_along_p_ ? of_p : of_q) + moving;
    const double speed = link_along_p_ ? place.q_size : place.p_size;
    return {at,
            Complex(-sense * moving.imag(), sense * moving.real()),
            size_of(at),
            speed,
            0.5 * half_opening * half_opening * speed,
            half_opening * speed};
  };
  OpeningJoints over{half_opening, {}};
  for (std::size_t i = 0; i < 6; ++i) over.joints[i] = seen(places_[i]);
  for (const Place& point : points_) over.points.push_back(seen(point));
  return over;
}

OpeningJoints LinkageMotion::over_openings(double opening, double half_opening) const {
  if (seen_from_link_) return over_openings_from_link(opening, half_opening);
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
  const auto seen = [&](const Place& place) -> OpeningJoint {
    const Complex of_p = place.a * p;
    const Complex at = of_p + place.b * q;
    const Complex unturned_slope = here * at - of_p;  // (here - 1) of_p + here of_q
    const Complex by_opening(-unturned_slope.imag(), unturned_slope.real());
    const double p_size = place.p_size, q_size = place.q_size;
    const double speed = size_of(by_opening);
    const double bowed =
        0.5 * half_opening * half_opening * (p_size * (bend + f1 * f1) + q_size * (bend + g1 * g1));
    const double reach = std::min(half_opening * (f1 * p_size + g1 * q_size), half_opening * speed + bowed);
    return {at, by_opening, size_of(at), speed, bowed, reach};
  };
  for (std::size_t i = 0; i < 6; ++i) over.joints[i] = seen(places_[i]);
  for (const Place& point : points_) over.points.push_back(seen(point));
  return over;
}

MovingJoints LinkageMotion::turned(const OpeningJoints& over, Complex turn, double half_bearing) {
  MovingJoints joints;
  const auto moving = [&](const OpeningJoint& joint) -> MovingJoint {
    const auto& [at, by_opening, far, speed, bowed, reach] = joint;
    const double rest =
        bowed + 0.5 * far * half_bearing * half_bearing + half_bearing * (speed * over.half_opening + bowed);
    return {rotated(at, turn),
            rotated(by_opening, turn),
            far,
            speed,
            rest,
            std::min(far * half_bearing, 2 * far) + reach};
  };
  for (std::size_t i = 0; i < 6; ++i) joints[i] = moving(over.joints[i]);
  for (const OpeningJoint& point : over.points) joints.points.push_back(moving(point));
  return joints;
}

}  // namespace kempe
