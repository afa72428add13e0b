#include "synthesis/loads/moving_masses.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "kinematics/links.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/link_arms.hpp"

namespace kempe {
namespace {

LinkagePoint between(const LinkagePoint& a, const LinkagePoint& b, double share) {
  return {a.of_p + share * (b.of_p - a.of_p), a.of_q + share * (b.of_q - a.of_q)};
}

/// Gathers points of one linkage.
class Gathering {
 public:
  Gathering(const CopyingLinkage& linkage, const MovingMasses& masses)
      : linkage_(linkage), of_area_(masses.density * cubic_metres_per_mm3 * masses.style.thickness),
        width_(masses.style.width) {}

  void add(const LinkagePoint& at, double mass) { points_.push_back({at, mass}); }

  void add_link(Link link, PlateStyle plate) {
    const Complex s = linkage_.shape();
    const LinkJoints of_link = joints_of(link);
    if (of_link.count == 3 && plate == PlateStyle::triangle && !is_straight(s)) return add_triangle(of_link);
    const auto arms = arms_of(link, s);
    for (const LinkArm& arm : arms) add_rod(arm.from, arm.to, width_);
    for (const Joint end : ends_of(arms)) add(at(end), of_area_ * pi * width_ * width_ / 8);
  }

  std::vector<MassPoint> points() { return std::move(points_); }

 private:
  LinkagePoint at(Joint joint) const { return linkage_point(joint, linkage_.shape()); }
  Complex place(Joint joint) const {
    const LinkagePoint point = at(joint);
    return point.of_p * linkage_.VA() + point.of_q * std::polar(linkage_.VB(), openings().middle());
  }
  const OpeningInterval& openings() const { return linkage_.assembly_mode().openings; }

  /// Simpson's rule: the same mass, centre and moment of inertia as the rod's.
  void add_rod(Joint from, Joint to, double width) {
    const double mass = of_area_ * width * std::abs(place(to) - place(from));
    for (const auto& [share, part] : {std::pair(0.0, 1.0 / 6), {0.5, 4.0 / 6}, {1.0, 1.0 / 6}})
      add(between(at(from), at(to), share), part * mass);
  }

  /// The middles of a triangle's sides, a third of the mass each, have its centre and its moment of inertia.
  void add_triangle(const LinkJoints& of_link) {
    const auto& joints = of_link.joints;
    const double inside =
        0.5 * std::abs(cross(place(joints[1]) - place(joints[0]), place(joints[2]) - place(joints[0])));
    for (std::size_t i = 0; i < 3; ++i) {
      const Joint from = joints[i], to = joints[(i + 1) % 3];
      add(between(at(from), at(to), 0.5), of_area_ * inside / 3);
      add_rod(from, to, 0.5 * width_);
      add(at(from), of_area_ * pi * width_ * width_ / 12);
    }
  }

  const CopyingLinkage& linkage_;
  double of_area_, width_;
  std::vector<MassPoint> points_;
};

/// A point's place seen from the pole.
LinkagePoint from_pole(const LinkagePoint& point, const CopyingLinkage& linkage) {
  const LinkagePoint pole = linkage_point(linkage.pole_joint(), linkage.shape());
  return {point.of_p - pole.of_p, point.of_q - pole.of_q};
}

/// p and q in the table's frame.
struct Sides {
  Complex p, q;
};
Sides sides_of(const Pose& pose) { return {as_complex(pose.A - pose.V), as_complex(pose.B - pose.V)}; }

}  // namespace

std::optional<Eigen::Matrix2d> turning_by_tracer(const CopyingLinkage& linkage, const Pose& pose) {
  const LinkagePoint tracer = from_pole(linkage_point(linkage.tracer_joint(), linkage.shape()), linkage);
  const auto [p, q] = sides_of(pose);
  const Complex by_p = i_unit * tracer.of_p * p, by_q = i_unit * tracer.of_q * q;
  const double area = cross(by_p, by_q);
  if (!(std::abs(area) > least_usable_angle * std::abs(by_p) * std::abs(by_q))) return std::nullopt;
  Eigen::Matrix2d result;
  result << by_q.imag(), -by_q.real(), -by_p.imag(), by_p.real();
  return result / area;
}

std::vector<MassPoint> mass_points(const CopyingLinkage& linkage, const MovingMasses& masses) {
  Gathering gathering(linkage, masses);
  for (const Link link : all_links) gathering.add_link(link, masses.style.plate);
  gathering.add(linkage_point(linkage.pen_joint(), linkage.shape()), masses.pen);
  gathering.add(linkage_point(linkage.tracer_joint(), linkage.shape()), masses.tracer);
  return gathering.points();
}

MassMoments mass_moments(const CopyingLinkage& linkage, const std::vector<MassPoint>& points) {
  MassMoments moments;
  for (const MassPoint& point : points) {
    const LinkagePoint at = from_pole(point.at, linkage);
    moments.of_p += point.mass * at.of_p;
    moments.of_q += point.mass * at.of_q;
    moments.mass += point.mass;
  }
  return moments;
}

std::array<Counterweight, 2> counterweights(const CopyingLinkage& linkage, const MassMoments& moments) {
  const auto against = [&](Complex moment) {
    const double size = std::abs(moment);
    const bool none = !(size > 1e-6 * moments.mass);
    return std::pair(none ? Complex(-1) : -moment / size, none ? 0 : size);
  };
  const bool at_V = linkage.pole_joint() == Joint::V;
  const Joint first = at_V ? Joint::V : Joint::A;
  const auto [along_p, mass_p] = against(moments.of_p);
  const Complex carried = mass_p * from_pole(linkage_point(first, linkage.shape()), linkage).of_q;
  const auto [along_q, mass_q] = against(moments.of_q + carried);
  return {{{Link::VA, first, along_p, linkage.VA(), mass_p},
           {at_V ? Link::VB : Link::ACX, linkage.pole_joint(), along_q, linkage.VB(), mass_q}}};
}

std::optional<std::array<BalanceSpring, 2>> balance_springs(const CopyingLinkage& linkage,
                                                            const MassMoments& moments, double tilt) {
  if (linkage.pole_joint() != Joint::V) return std::nullopt;
  const auto spring = [&](Link link, Complex moment, double length) {
    const double size = std::abs(moment), half = 0.5 * length;
    return BalanceSpring{link, size > 0 ? moment / size : 1, half, half,
                         standard_gravity * std::sin(tilt) * size * length / (half * half)};
  };
  return std::array{spring(Link::VA, moments.of_p, linkage.VA()),
                    spring(Link::VB, moments.of_q, linkage.VB())};
}

std::optional<Point> hand_force_of_weight(const CopyingLinkage& linkage, const MassMoments& moments,
                                          const Pose& pose, double tilt) {
  const auto turning = turning_by_tracer(linkage, pose);
  if (!turning) return std::nullopt;
  const auto [p, q] = sides_of(pose);
  const double pull = standard_gravity * std::sin(tilt);
  // The height of the centre of mass, y, by the turns of p and q.
  const Eigen::RowVector2d slopes(pull * (i_unit * moments.of_p * p).imag(),
                                  pull * (i_unit * moments.of_q * q).imag());
  return Point((slopes * *turning).transpose());
}

std::optional<Eigen::Matrix2d> mass_felt(const CopyingLinkage& linkage, const std::vector<MassPoint>& points,
                                         const Pose& pose) {
  const auto turning = turning_by_tracer(linkage, pose);
  if (!turning) return std::nullopt;
  const auto [p, q] = sides_of(pose);
  Eigen::Matrix2d inertia = Eigen::Matrix2d::Zero();
  for (const MassPoint& point : points) {
    const LinkagePoint at = from_pole(point.at, linkage);
    const Complex by_p = at.of_p * p, by_q = at.of_q * q;
    const double mixed = point.mass * dot(by_p, by_q);
    Eigen::Matrix2d each;
    each << point.mass * std::norm(by_p), mixed, mixed, point.mass * std::norm(by_q);
    inertia += each;
  }
  return Eigen::Matrix2d(turning->transpose() * inertia * *turning);
}

}  // namespace kempe
