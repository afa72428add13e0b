#include "synthesis/verification_drive.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace kempe {
namespace {

/// The third corner of a plate whose first side lies along the x axis: from the two other sides and the turn (0: in
/// line). The error names the sides that do not meet.
tl::expected<Point, std::string> third_corner(double base, double from_first, double from_second, int turn,
                                              const char* plate) {
  const double along = (base * base + from_first * from_first - from_second * from_second) / (2 * base);
  const double height_squared = (from_first - along) * (from_first + along);
  constexpr double in_line = 1e-9;  // of the side: what rounding of the three lengths may leave
  if (height_squared < -in_line * from_first * from_first)
    return tl::unexpected(fmt::format("the three lengths of plate {} do not close a triangle", plate));
  if (turn == 0 && height_squared > in_line * from_first * from_first)
    return tl::unexpected(fmt::format("the three joints of plate {} are not in line", plate));
  return Point(along, turn * std::sqrt(std::max(0.0, height_squared)));
}

struct Plates {
  Point X, Y;  // in the frames A-C and B-C
};

tl::expected<Plates, std::string> plates_of(const DrawnMechanism& m) {
  const LinkLengths& l = m.lengths;
  for (const double length : l.values())
    if (!std::isfinite(length) || length <= 0) return tl::unexpected(std::string("a length is not positive"));
  const auto X = third_corner(l.AC, l.AX, l.CX, m.orientation.plate_ACX, "ACX");
  if (!X) return tl::unexpected(X.error());
  const auto Y = third_corner(l.BC, l.BY, l.CY, m.orientation.plate_BCY, "BCY");
  if (!Y) return tl::unexpected(Y.error());
  return Plates{*X, *Y};
}

/// Where two circles about A and B meet, on the side of the line A-B that `turn` names; the nearest place if they miss.
Point corner_C(const Point& A, const Point& B, double AC, double BC, int turn) {
  const Point across = B - A;
  const double apart = across.norm();
  const double along = (AC * AC - BC * BC + apart * apart) / (2 * apart);
  const double height = std::sqrt(std::max(0.0, AC * AC - along * along));
  const Point normal(-across.y(), across.x());
  return A + across / apart * along + normal / apart * (height * turn);
}

double direction(const Point& from, const Point& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

/// The position turned about `centre` and then shifted.
PlanarPosition moved(PlanarPosition position, const Point& centre, double turn, const Point& shift) {
  const Eigen::Rotation2Dd rotation(turn);
  for (std::size_t body = 1; body < position.size(); ++body) {
    position[body].at = centre + rotation * (position[body].at - centre) + shift;
    position[body].angle += turn;
  }
  return position;
}

}  // namespace

tl::expected<Drive, std::string> Drive::make(const DrawnMechanism& m, const Point& towards) {
  const auto plates = plates_of(m);
  if (!plates) return tl::unexpected(plates.error());
  const LinkLengths& l = m.lengths;
  PlanarLinkage linkage;
  const int VA = linkage.add_body("VA"), VB = linkage.add_body("VB");
  const int ACX = linkage.add_body("ACX"), BCY = linkage.add_body("BCY");
  const Point origin = Point::Zero();
  const Points on{{VA, origin},     {VA, {l.VA, 0}},  {VB, {l.VB, 0}},
                  {ACX, {l.AC, 0}}, {ACX, plates->X}, {BCY, plates->Y}};
  linkage.add(Revolute{on.V, {VB, origin}}, "joint V");
  linkage.add(Revolute{on.A, {ACX, origin}}, "joint A");
  linkage.add(Revolute{on.B, {BCY, origin}}, "joint B");
  linkage.add(Revolute{on.C, {BCY, {l.BC, 0}}}, "joint C");
  const auto joint = [&](Joint which) -> const BodyPoint& {
    return which == Joint::V ? on.V : which == Joint::X ? on.X : on.Y;
  };
  linkage.add(Revolute{joint(m.pole), {PlanarLinkage::ground, m.pole_position}}, "pole");

  // A first position by compass: V at the origin, VA along x, C on the far side of A-B.
  const double opening = m.opening.middle();
  const Point A(l.VA, 0), B = l.VB * Point(std::cos(opening), std::sin(opening));
  const Point C = corner_C(A, B, l.AC, l.BC, cross(B - A, -A) > 0 ? -1 : 1);
  PlanarPosition guess{{}, {origin, 0}, {origin, opening}, {A, direction(A, C)}, {B, direction(B, C)}};
  const Point pole = place(guess, joint(m.pole)), tracer = place(guess, joint(m.tracer));
  const double turn = direction(m.pole_position, towards) - direction(pole, tracer);
  guess = moved(guess, pole, turn, m.pole_position - pole);

  linkage.drive_point(joint(m.tracer), "tracer");
  const Point start = place(guess, joint(m.tracer));
  auto path = PlanarPath::from(linkage, guess, {start.x(), start.y()});
  if (!path)
    return tl::unexpected("the linkage does not assemble from its lengths: " +
                          std::string(name(path.error().why)));
  return Drive(std::move(*path), on, m.pole_position);
}

tl::expected<void, std::string> Drive::go_to(const Point& tracer) {
  PlanarPath before = path_;
  if (path_.advance({tracer.x(), tracer.y()})) return {};
  path_ = std::move(before);  // a stop leaves it at a singular position, a bad place to start from
  return around_the_pole(tracer);
}

tl::expected<void, std::string> Drive::around_the_pole(const Point& tracer) {
  const Point from(path_.values()[0], path_.values()[1]);
  const double r0 = (from - pole_).norm(), r1 = (tracer - pole_).norm();
  const double bearing = direction(pole_, from);
  const double turn = std::remainder(direction(pole_, tracer) - bearing, 2 * pi);
  const int pieces = 1 + static_cast<int>(std::abs(turn) / radians(5));
  for (int i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces, r = r0 + (r1 - r0) * share;
    const double at = bearing + turn * share;
    const Point next = i == pieces ? tracer : Point(pole_ + r * Point(std::cos(at), std::sin(at)));
    if (const auto arrived = path_.advance({next.x(), next.y()}); !arrived)
      return tl::unexpected("the linkage stops at a " + std::string(name(arrived.error().end)));
  }
  return {};
}

Pose Drive::pose() const {
  return {path_.at(points_.V), path_.at(points_.A), path_.at(points_.B),
          path_.at(points_.C), path_.at(points_.X), path_.at(points_.Y)};
}

}  // namespace kempe
