#include "synthesis/certificate/part_points.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "synthesis/certificate/slack.hpp"

namespace kempe::certificate {
namespace {

constexpr std::array<Joint, 4> pins{Joint::A, Joint::B, Joint::C, Joint::V};
constexpr std::array<Joint, 3> posts{Joint::V, Joint::X, Joint::Y};

template <std::size_t size>
std::uint8_t place_in(const std::array<Joint, size>& joints, Joint joint) {
  return static_cast<std::uint8_t>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
}

bool is_link(PartName part) { return part.number < 4; }
bool is_plate(PartName part) { return part.number == 2 || part.number == 3; }

/// A plate's point as first joint + t side + u other side, in units of one direction: the sides are 1 and s, or s and 1.
PartPoint on_plate(PartName part, Complex from_first, Complex side, Complex other, PlateStyle plate) {
  // On a bar of a bent plate, or the whole of a straight one, one of the shares is 0.
  const Complex along = from_first / side, along_other = from_first / other;
  const double off = std::abs(along.imag()) * std::abs(side),
               off_other = std::abs(along_other.imag()) * std::abs(other);
  const PartPoint on_side{part, std::clamp(along.real(), 0.0, 1.0), 0};
  const PartPoint on_other{part, 0, std::clamp(along_other.real(), 0.0, 1.0)};
  const auto miss = [&](const PartPoint& point) {
    return std::abs(point.t * side + point.u * other - from_first);
  };
  const double turn = cross(side, other);
  if (plate == PlateStyle::bent || std::abs(turn) < slack::flat_plate * std::abs(side) * std::abs(other) ||
      std::min(off, off_other) < slack::on_side)
    return miss(on_side) <= miss(on_other) ? on_side : on_other;
  const double t = cross(from_first, other) / turn;
  const double u = cross(side, from_first) / turn;
  PartPoint point{part, std::max(0.0, t), std::max(0.0, u)};
  const double sum = point.t + point.u;
  if (sum > slack::inside_plate)
    point = {part, point.t / sum * slack::inside_plate, point.u / sum * slack::inside_plate};
  return point;
}

}  // namespace

std::string text(PartName part) {
  if (is_link(part)) return std::string(name(all_links[part.number]));
  if (part.number < 8) return std::string("pin ") + letter(pins[part.number - 4U]);
  return std::string("post ") + letter(posts[part.number - 8U]);
}

PartName name_of(const Part& part) {
  if (part.kind == Part::Kind::link) return {static_cast<std::uint8_t>(part.link)};
  if (part.kind == Part::Kind::pin) return {static_cast<std::uint8_t>(4 + place_in(pins, part.joint))};
  return {static_cast<std::uint8_t>(8 + place_in(posts, part.joint))};
}

Part part_of(PartName name) {
  Part part;
  if (is_link(name)) {
    part.link = all_links[name.number];
  } else {
    part.kind = name.number < 8 ? Part::Kind::pin : Part::Kind::tracer_post;
    part.joint = name.number < 8 ? pins[name.number - 4U] : posts[name.number - 8U];
  }
  return part;
}

FilledLayers::FilledLayers(const CopyingLinkage& any, const LayerAssignment& layers) {
  lowest_.fill(1);
  highest_.fill(0);
  for (const Part& part : parts_of(any, layers)) {
    lowest_[name_of(part).number] = part.lowest_layer;
    highest_[name_of(part).number] = part.highest_layer;
  }
}

bool FilledLayers::share(PartName one, PartName other) const {
  return std::max(lowest_[one.number], lowest_[other.number]) <=
         std::min(highest_[one.number], highest_[other.number]);
}

bool FilledLayers::share(PartName part, int lowest, int highest) const {
  return std::max(lowest_[part.number], lowest) <= std::min(highest_[part.number], highest);
}

PartPoint part_point(PartName part, const bounding::MaterialPoint& at, Complex shape, PlateStyle plate) {
  if (part.number == 0) return {part, std::clamp(at.of_a.real(), 0.0, 1.0), 0};
  if (part.number == 1) return {part, std::clamp((at.of_b / shape).real(), 0.0, 1.0), 0};
  if (part.number == 2) return on_plate(part, at.of_b, shape, 1.0, plate);  // A + t (C - A) + u (X - A)
  if (part.number == 3) return on_plate(part, at.of_a, 1.0, shape, plate);  // B + t (C - B) + u (Y - B)
  return {part, 0, 0};
}

bounding::MaterialPoint material_point(const PartPoint& point, Complex shape) {
  const PartName part = point.part;
  if (part.number == 0) return {point.t, 0};
  if (part.number == 1) return {0, point.t * shape};
  if (part.number == 2) return {1, point.t * shape + point.u};
  if (part.number == 3) return {point.t + point.u * shape, shape};
  return bounding::material_point(part_of(part).joint, shape);
}

std::vector<std::array<PartPoint, 2>> sides_of(PartName part, PlateStyle plate) {
  if (!is_link(part)) return {};
  const PartPoint corner{part, 0, 0}, one{part, 1, 0}, other{part, 0, 1};
  std::vector<std::array<PartPoint, 2>> sides{{corner, one}};
  if (is_plate(part)) sides.push_back({corner, other});
  if (is_plate(part) && plate == PlateStyle::triangle) sides.push_back({one, other});
  return sides;
}

PartPoint on_side(const std::array<PartPoint, 2>& side, double share) {
  const bool between_tips = side[0].t + side[0].u > 0;
  const double whole = between_tips ? slack::inside_plate : 1;
  return {side[0].part, whole * ((1 - share) * side[0].t + share * side[1].t),
          whole * ((1 - share) * side[0].u + share * side[1].u)};
}

bool is_copied(const PartPoint& point) {
  if (is_link(point.part)) return is_plate(point.part) ? point.t == 0 && point.u == 1 : point.t == 0;
  const Joint joint = part_of(point.part).joint;
  return joint == Joint::V || joint == Joint::X || joint == Joint::Y;
}

Joint copied_joint(const PartPoint& point) {
  if (!is_link(point.part)) return part_of(point.part).joint;
  if (!is_plate(point.part)) return Joint::V;
  return has_joint(part_of(point.part).link, Joint::X) ? Joint::X : Joint::Y;
}

std::vector<PartPoint> points_along(PartName part, PlateStyle plate) {
  if (!is_link(part)) return {{part, 0, 0}};
  constexpr int pieces = 8;
  std::vector<PartPoint> points;
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    points.push_back({part, share, 0});
    if (!is_plate(part)) continue;
    points.push_back({part, 0, share});
    if (plate == PlateStyle::triangle) points.push_back({part, share, 1 - share});
  }
  if (is_plate(part) && plate == PlateStyle::triangle) points.push_back({part, 0.333, 0.333});
  return points;
}

}  // namespace kempe::certificate
