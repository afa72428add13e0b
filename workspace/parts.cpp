#include "workspace/parts.hpp"

#include <algorithm>

namespace kempe {

int LayerAssignment::highest() const { return *std::max_element(of.begin(), of.end()); }

namespace {

bool joined_apart(const LayerAssignment& layers) {
  return layers[Link::VA] != layers[Link::VB] && layers[Link::VA] != layers[Link::ACX] &&
         layers[Link::VB] != layers[Link::BCY] && layers[Link::ACX] != layers[Link::BCY];
}

}  // namespace

bool LayerAssignment::has_links_in(int layer) const {
  return std::find(of.begin(), of.end(), layer) != of.end();
}

int LayerAssignment::rank(Link link) const {
  int rank = 1;
  for (int layer = 1; layer < (*this)[link]; ++layer) rank += has_links_in(layer) ? 1 : 0;
  return rank;
}

bool LayerAssignment::is_stacked() const {
  for (int layer = 1; layer < highest(); ++layer)
    if (!has_links_in(layer)) return false;
  return true;
}

std::vector<LayerAssignment> layer_assignments(int layers) {
  std::vector<LayerAssignment> result;
  for (int VA = 1; VA <= layers; ++VA)
    for (int VB = 1; VB <= layers; ++VB)
      for (int ACX = 1; ACX <= layers; ++ACX)
        for (int BCY = 1; BCY <= layers; ++BCY)
          if (const LayerAssignment one{{VA, VB, ACX, BCY}}; joined_apart(one)) result.push_back(one);
  const auto order = [](const LayerAssignment& one) { return one.is_stacked() ? 0 : one.highest(); };
  std::stable_sort(result.begin(), result.end(),
                   [&](const LayerAssignment& a, const LayerAssignment& b) { return order(a) < order(b); });
  return result;
}

std::string name(const Part& part) {
  const std::string at(1, letter(part.joint));
  switch (part.kind) {
    case Part::Kind::link: return "link " + std::string(name(part.link));
    case Part::Kind::pin: return "pin " + at;
    case Part::Kind::pole_post: return "pole post " + at;
    case Part::Kind::tracer_post: return "tracer " + at;
    case Part::Kind::pen_post: break;
  }
  return "pen " + at;
}

std::vector<Part> parts_of(const CopyingLinkage& linkage, const LayerAssignment& layers) {
  std::vector<Part> parts;
  for (const Link link : all_links) parts.push_back({Part::Kind::link, link, {}, layers[link], layers[link]});
  const auto add_pin = [&](Joint joint, Link one, Link other) {
    const int low = std::min(layers[one], layers[other]), high = std::max(layers[one], layers[other]);
    if (high - low > 1) parts.push_back({Part::Kind::pin, {}, joint, low + 1, high - 1});
  };
  add_pin(Joint::V, Link::VA, Link::VB);
  add_pin(Joint::A, Link::VA, Link::ACX);
  add_pin(Joint::B, Link::VB, Link::BCY);
  add_pin(Joint::C, Link::ACX, Link::BCY);
  const auto add_post = [&](Part::Kind kind, Joint joint) {
    int lowest_link = layers.highest();
    for (const Link link : all_links)
      if (has_joint(link, joint)) lowest_link = std::min(lowest_link, layers[link]);
    parts.push_back({kind, {}, joint, 1, lowest_link - 1});
  };
  add_post(Part::Kind::pole_post, linkage.pole_joint());
  add_post(Part::Kind::tracer_post, linkage.tracer_joint());
  add_post(Part::Kind::pen_post, linkage.pen_joint());
  return parts;
}

double half_width(const Part& part, const LinkStyle& style) {
  return 0.5 * (part.kind == Part::Kind::link ? style.width : style.pin_diameter);
}

namespace {

/// A straight plate's outermost joints: `corner` at 0, `C` at 1 and `tip` at `place` along the plate.
JointHull straight_plate(Joint corner, Joint tip, double place) {
  if (place < 0) return {{tip, Joint::C, Joint::C}, 2};
  return {{corner, place > 1 ? tip : Joint::C, Joint::C}, 2};
}

std::vector<JointHull> plate_axis(Joint corner, Joint tip, PlateStyle plate) {
  if (plate == PlateStyle::triangle) return {{{corner, Joint::C, tip}, 3}};
  return {{{Joint::C, corner, corner}, 2}, {{corner, tip, tip}, 2}};
}

}  // namespace

std::vector<JointHull> axis_of(const Part& part, Complex shape, PlateStyle plate) {
  if (part.kind != Part::Kind::link) return {{{part.joint, part.joint, part.joint}, 1}};
  switch (part.link) {
    case Link::VA: return {{{Joint::V, Joint::A, Joint::A}, 2}};
    case Link::VB: return {{{Joint::V, Joint::B, Joint::B}, 2}};
    case Link::ACX:
      if (is_straight(shape)) return {straight_plate(Joint::A, Joint::X, (1.0 / shape).real())};
      return plate_axis(Joint::A, Joint::X, plate);
    case Link::BCY: break;
  }
  if (is_straight(shape)) return {straight_plate(Joint::B, Joint::Y, shape.real())};
  return plate_axis(Joint::B, Joint::Y, plate);
}

}  // namespace kempe
