#include "synthesis/verification/drive.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "synthesis/verification/slack.hpp"

namespace kempe {
namespace {

/// One plate as its drawing gives it: the first side, the sides from its two ends, the side of the third joint, and the
/// angle at the first side's beginning, which only a nearly flat plate needs.
struct DrawnPlate {
  const char* name;
  double base, from_first, from_second;
  Side turn;
  std::optional<double> angle;
};

Point by_angle(const DrawnPlate& plate) {
  return plate.from_first * Point(std::cos(*plate.angle), std::sin(*plate.angle));
}

/// By the first side's angle and two lengths. The error says how the rest of the drawing disagrees.
tl::expected<Point, std::string> corner_by_angle(const DrawnPlate& plate) {
  const Point corner = by_angle(plate);
  const double third = (corner - Point(plate.base, 0)).norm();
  if (!(std::abs(third - plate.from_second) <= slack::in_line * (plate.base + plate.from_first)))
    return tl::unexpected(
        fmt::format("the three lengths of plate {} do not close a triangle of its shape", plate.name));
  if (plate.turn == Side::on_line && std::abs(corner.y()) > slack::in_line * plate.from_first)
    return tl::unexpected(fmt::format("the three joints of plate {} are not in line", plate.name));
  if (sign(plate.turn) * corner.y() < 0)
    return tl::unexpected(fmt::format("plate {} is turned to the other side than its shape", plate.name));
  return corner;
}

/// The third corner of a plate whose first side lies along the x axis. The error names the plate that does not close.
tl::expected<Point, std::string> third_corner(const DrawnPlate& plate) {
  const double f = plate.from_first, g = plate.from_second;
  const double along = 0.5 * plate.base + (f - g) * (f + g) / (2 * plate.base);
  const double height_squared = (f - along) * (f + along);
  if (height_squared < -slack::in_line * f * f)
    return tl::unexpected(fmt::format("the three lengths of plate {} do not close a triangle", plate.name));
  if (plate.angle && height_squared < slack::lengths_suffice * slack::lengths_suffice * f * f)
    return corner_by_angle(plate);
  if (plate.turn == Side::on_line && height_squared > slack::in_line * f * f)
    return tl::unexpected(fmt::format("the three joints of plate {} are not in line", plate.name));
  const Point corner(along, sign(plate.turn) * std::sqrt(std::max(0.0, height_squared)));
  if (plate.angle && !((corner - by_angle(plate)).norm() <= slack::in_line * (plate.base + f)))
    return tl::unexpected(
        fmt::format("the three lengths of plate {} do not close a triangle of its shape", plate.name));
  return corner;
}

struct Plates {
  Point X, Y;  // in the frames A-C and B-C
};

tl::expected<Plates, std::string> plates_of(const DrawnMechanism& m) {
  const LinkLengths& l = m.lengths;
  for (const double length : l.values())
    if (!std::isfinite(length) || length <= 0) return tl::unexpected(std::string("a length is not positive"));
  const std::optional<double> bend = m.shape ? std::optional(std::arg(*m.shape)) : std::nullopt;
  const std::optional<double> back = bend ? std::optional(-*bend) : std::nullopt;
  const auto X = third_corner({"ACX", l.AC, l.AX, l.CX, m.sides.plate_ACX, back});
  if (!X) return tl::unexpected(X.error());
  const auto Y = third_corner({"BCY", l.BC, l.BY, l.CY, m.sides.plate_BCY, bend});
  if (!Y) return tl::unexpected(Y.error());
  return Plates{*X, *Y};
}

/// Where two circles about A and B meet, on the side of the line A-B that `turn` names; the nearest place if they miss.
Point corner_C(const Point& A, const Point& B, double AC, double BC, Side turn) {
  const Point across = B - A;
  const double apart = across.norm();
  const double along = (AC * AC - BC * BC + apart * apart) / (2 * apart);
  const double height = std::sqrt(std::max(0.0, AC * AC - along * along));
  const Point normal(-across.y(), across.x());
  return A + across / apart * along + normal / apart * (height * sign(turn));
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
  linkage.add(Revolute{joint(m.pole), {PlanarLinkage::ground, origin}}, "pole");

  // A first position by compass: V at the origin, VA along x, C on the far side of A-B.
  const double opening = m.opening.middle();
  const Point A(l.VA, 0), B = l.VB * Point(std::cos(opening), std::sin(opening));
  const Point C = corner_C(A, B, l.AC, l.BC, cross(B - A, -A) > 0 ? Side::right : Side::left);
  PlanarPosition guess{{}, {origin, 0}, {origin, opening}, {A, direction(A, C)}, {B, direction(B, C)}};
  const Point pole = place(guess, joint(m.pole)), tracer = place(guess, joint(m.tracer));
  const double turn = direction(origin, towards) - direction(pole, tracer);
  guess = moved(guess, pole, turn, -pole);

  linkage.drive_point(joint(m.tracer), "tracer");
  const Point start = place(guess, joint(m.tracer));
  auto path = PlanarPath::from(linkage, guess, {start.x(), start.y()});
  if (!path)
    return tl::unexpected("the linkage does not assemble from its lengths: " +
                          std::string(name(path.error().why)));
  return Drive(std::move(*path), on, start.norm());
}

tl::expected<void, std::string> Drive::go_to(const Point& tracer) {
  PlanarPath before = path_;
  if (path_.advance({tracer.x(), tracer.y()})) return {};
  path_ = before;  // a stop leaves it at a singular position, a bad place to start from
  auto arrived = around_the_pole(tracer);
  if (!arrived) path_ = std::move(before);
  return arrived;
}

namespace {

/// Along a circle about the origin, the shorter way, as far as the bearing of another place.
DriverCurve arc(const Point& from, const Point& towards) {
  const double radius = from.norm(), bearing = direction(Point::Zero(), from);
  const double turn = std::remainder(direction(Point::Zero(), towards) - bearing, 2 * pi);
  DriverCurve curve;
  curve.values_at = [=](double share, std::vector<double>& values) {
    values = {radius * std::cos(bearing + turn * share), radius * std::sin(bearing + turn * share)};
    if (share <= 0) values = {from.x(), from.y()};
  };
  curve.slopes_at = [=](double share, std::vector<double>& slopes) {
    const double at = bearing + turn * share;
    slopes = {-turn * radius * std::sin(at), turn * radius * std::cos(at)};
  };
  const double speed = std::abs(turn) * radius, bend = turn * turn * radius;
  curve.fastest = {speed, speed};
  curve.most_bent = {bend, bend};
  return curve;
}

tl::expected<void, std::string> told(const tl::expected<void, PathStop>& arrived) {
  if (arrived) return {};
  return tl::unexpected("the linkage stops at a " + std::string(name(arrived.error().end)));
}

}  // namespace

/// Radially to the distance at which the middle of the opening stands, around the pole there, and radially to the target:
/// all of it is within reach, and the turn is made far from dead and change points.
tl::expected<void, std::string> Drive::around_the_pole(const Point& tracer) {
  const Point from(path_.values()[0], path_.values()[1]);
  const Point half_way = from * (turning_radius_ / from.norm());
  if (const auto arrived = path_.advance({half_way.x(), half_way.y()}); !arrived) return told(arrived);
  if (const auto arrived = path_.follow(arc(half_way, tracer)); !arrived) return told(arrived);
  return told(path_.advance({tracer.x(), tracer.y()}));
}

Pose Drive::pose() const {
  return {path_.at(points_.V), path_.at(points_.A), path_.at(points_.B),
          path_.at(points_.C), path_.at(points_.X), path_.at(points_.Y)};
}

}  // namespace kempe
