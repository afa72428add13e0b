#include "kinematics/copying_linkage.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "kinematics/slack.hpp"

namespace kempe {
std::string_view name(Unreachable why) {
  switch (why) {
    case Unreachable::too_far: return "beyond the outer reach";
    case Unreachable::too_near: return "inside the inner reach";
    case Unreachable::beyond_change_point: return "beyond the change point";
  }
  return "";
}

std::string_view name(LinkageFault fault) {
  switch (fault) {
    case LinkageFault::ratio_not_finite: return "the copy ratio is not a finite number";
    case LinkageFault::ratio_zero: return "a copy ratio of 0 copies everything onto one point";
    case LinkageFault::ratio_one: return "scale 1 without rotation is a translation, which has no pole";
    case LinkageFault::length_not_positive: return "a link length is not a positive finite number";
    case LinkageFault::no_such_assembly_mode: return "the linkage has no assembly mode of this number";
  }
  return "";
}

const Point& Pose::operator[](Joint joint) const { return const_cast<Pose&>(*this)[joint]; }

Point& Pose::operator[](Joint joint) {
  switch (joint) {
    case Joint::V: return V;
    case Joint::A: return A;
    case Joint::B: return B;
    case Joint::C: return C;
    case Joint::X: return X;
    case Joint::Y: break;
  }
  return Y;
}

tl::expected<CopyingLinkage, LinkageFault> CopyingLinkage::make(Complex k, Grounding grounding, double VA,
                                                                double VB, int assembly_mode,
                                                                const Point& pole) {
  if (!std::isfinite(k.real()) || !std::isfinite(k.imag()))
    return tl::unexpected(LinkageFault::ratio_not_finite);
  if (std::abs(k) == 0) return tl::unexpected(LinkageFault::ratio_zero);
  const Complex s = shape_of(k, grounding);
  if (std::abs(1.0 - k) < slack::straight_plates || std::abs(s) == 0)
    return tl::unexpected(LinkageFault::ratio_one);
  const auto positive = [](double length) { return std::isfinite(length) && length > 0; };
  if (!positive(VA) || !positive(VB)) return tl::unexpected(LinkageFault::length_not_positive);
  const std::vector<AssemblyMode> modes = assembly_modes(s);
  if (assembly_mode < 0 || static_cast<std::size_t>(assembly_mode) >= modes.size())
    return tl::unexpected(LinkageFault::no_such_assembly_mode);
  return CopyingLinkage(k, grounding, VA, VB, modes[static_cast<std::size_t>(assembly_mode)], pole);
}

CopyingLinkage::CopyingLinkage(Complex k, Grounding grounding, double VA, double VB,
                               const AssemblyMode& assembly_mode, const Point& pole)
    : k_(k), grounding_(grounding), VA_(VA), VB_(VB), assembly_mode_(assembly_mode), pole_(pole),
      s_(shape_of(k, grounding)) {}

LinkLengths lengths_of_links(Complex shape, double VA, double VB) {
  const double scale = std::abs(shape);
  const double turn = std::abs(1.0 - shape);
  return {.VA = VA,
          .VB = VB,
          .AC = VB,
          .BC = VA,
          .AX = VB / scale,
          .CX = VB * turn / scale,
          .BY = VA * scale,
          .CY = VA * turn};
}

double CopyingLinkage::size() const {
  const LinkLengths l = lengths();
  return l.VA + l.VB + 0.5 * (l.AC + l.AX + l.CX) + 0.5 * (l.BC + l.BY + l.CY);
}

double CopyingLinkage::transmission_angle(double opening) const {
  return std::min(std::asin(std::min(1.0, std::abs(std::sin(opening - std::arg(s_))))),
                  std::asin(std::min(1.0, std::abs(std::sin(opening)))));
}

double CopyingLinkage::radius_at(double opening) const {
  // |p + q/s| with p = VA and q = VB e^{id}; hypot of the components keeps digits near the folded dead point.
  return std::abs(VA_ + std::polar(VB_, opening) / s_) / chain_length_per_tracer(k_, grounding_);
}

double CopyingLinkage::radius_slope_at(double opening) const {
  const double a = VA_, b = VB_ / std::abs(s_);
  const double scale = chain_length_per_tracer(k_, grounding_);
  const double radius = radius_at(opening) * scale;
  return radius > 0 ? -a * b * std::sin(opening - std::arg(s_)) / radius / scale : 0;
}

bool CopyingLinkage::radius_grows_with_opening() const {
  return std::sin(assembly_mode_.openings.middle() - std::arg(s_)) < 0;
}

tl::expected<double, Unreachable> CopyingLinkage::opening_at(double radius) const {
  const double a = VA_, b = VB_ / std::abs(s_);
  const double chain = radius * chain_length_per_tracer(k_, grounding_);
  if (!(chain > 0)) return tl::unexpected(Unreachable::too_near);
  // tan^2(e/2) = ((a+b)^2 - w^2) / (w^2 - (a-b)^2) keeps full precision at both dead points, unlike acos.
  const double outer = (a + b - chain) * (a + b + chain);
  const double inner = (chain - std::abs(a - b)) * (chain + std::abs(a - b));
  const double slack = slack::cosine_slack * (a + b) * (a + b);
  if (outer < -slack) return tl::unexpected(Unreachable::too_far);
  if (inner < -slack) return tl::unexpected(Unreachable::too_near);
  const double elbow = 2 * std::atan2(std::sqrt(std::max(0.0, outer)), std::sqrt(std::max(0.0, inner)));
  const double side = radius_grows_with_opening() ? -1 : 1;
  double opening = side * elbow + std::arg(s_);
  const double middle = assembly_mode_.openings.middle();
  opening -= 2 * pi * std::round((opening - middle) / (2 * pi));
  if (opening < assembly_mode_.openings.lower - slack::opening_rounding ||
      opening > assembly_mode_.openings.upper + slack::opening_rounding)
    return tl::unexpected(Unreachable::beyond_change_point);
  return std::clamp(opening, assembly_mode_.openings.lower, assembly_mode_.openings.upper);
}

CopyingLinkage::RadiusRange CopyingLinkage::radii_over(const OpeningInterval& openings) const {
  const double a = radius_at(openings.lower), b = radius_at(openings.upper);
  return {std::min(a, b), std::max(a, b)};
}

Pose CopyingLinkage::pose_from_vectors(Complex p, Complex q) const {
  const Complex A = p, B = q, C = p + q, X = p + q / s_, Y = q + s_ * p;  // V at the origin
  const Complex ground = pole_joint() == Joint::V ? Complex{} : X;
  const auto place = [&](Complex z) { return Point(pole_ + as_point(z - ground)); };
  return {place(0), place(A), place(B), place(C), place(X), place(Y)};
}

tl::expected<Pose, Unreachable> CopyingLinkage::pose_with_tracer_at(const Point& tracer) const {
  const Complex reach = as_complex(tracer - pole_);
  return opening_at(std::abs(reach)).map([&](double opening) {
    Pose pose = pose_at(opening, std::arg(reach));
    return pose;
  });
}

Pose CopyingLinkage::pose_at(double opening, double bearing) const {
  const Complex unturned = (VA_ + std::polar(VB_, opening) / s_) / chain_per_tracer(k_, grounding_);
  const Complex turn = std::polar(1.0, bearing) * std::abs(unturned) / unturned;
  return pose_from_vectors(VA_ * turn, std::polar(VB_, opening) * turn);
}

Point CopyingLinkage::tracer_at(double opening, double bearing) const {
  return pole_ + as_point(std::polar(radius_at(opening), bearing));
}

namespace {

/// Real u, v with u a + v b = c; nothing if a and b are parallel.
tl::expected<std::array<double, 2>, Unreachable> resolve(Complex a, Complex b, Complex c) {
  const double det = cross(a, b);
  if (std::abs(det) <= slack::parallel * std::abs(a) * std::abs(b))
    return tl::unexpected(Unreachable::too_far);
  return std::array{cross(c, b) / det, cross(a, c) / det};
}

}  // namespace

LinkagePoint linkage_point(Joint joint, Complex shape) {
  switch (joint) {
    case Joint::V: return {0, 0};
    case Joint::A: return {1, 0};
    case Joint::B: return {0, 1};
    case Joint::C: return {1, 1};
    case Joint::X: return {1, 1.0 / shape};
    case Joint::Y: break;
  }
  return {shape, 1};
}

tl::expected<Pose, Unreachable> CopyingLinkage::velocities(const Pose& pose,
                                                           const Point& tracer_velocity) const {
  // chain w = p + q/s turns as w' = i alpha' p + i beta' q/s, alpha and beta the directions of p and q.
  const Complex p = as_complex(pose.A - pose.V), q = as_complex(pose.B - pose.V);
  const Complex chain = as_complex(tracer_velocity) * chain_per_tracer(k_, grounding_);
  return resolve(i_unit * p, i_unit * q / s_, chain).map([&](const std::array<double, 2>& rate) {
    CopyingLinkage at_rest = *this;
    at_rest.pole_ = Point::Zero();
    return at_rest.pose_from_vectors(i_unit * rate[0] * p, i_unit * rate[1] * q);
  });
}

tl::expected<Pose, Unreachable> CopyingLinkage::accelerations(const Pose& pose, const Point& tracer_velocity,
                                                              const Point& tracer_acceleration) const {
  const Complex p = as_complex(pose.A - pose.V), q = as_complex(pose.B - pose.V);
  const auto rate =
      resolve(i_unit * p, i_unit * q / s_, as_complex(tracer_velocity) * chain_per_tracer(k_, grounding_));
  if (!rate) return tl::unexpected(rate.error());
  const double alpha1 = (*rate)[0], beta1 = (*rate)[1];
  // w'' = (i alpha'' - alpha'^2) p + (i beta'' - beta'^2) q/s
  const Complex centripetal = -alpha1 * alpha1 * p - beta1 * beta1 * q / s_;
  const Complex chain = as_complex(tracer_acceleration) * chain_per_tracer(k_, grounding_);
  return resolve(i_unit * p, i_unit * q / s_, chain - centripetal)
      .map([&](const std::array<double, 2>& second) {
        CopyingLinkage at_rest = *this;
        at_rest.pole_ = Point::Zero();
        return at_rest.pose_from_vectors((i_unit * second[0] - alpha1 * alpha1) * p,
                                         (i_unit * second[1] - beta1 * beta1) * q);
      });
}

}  // namespace kempe
