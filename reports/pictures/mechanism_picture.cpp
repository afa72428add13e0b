#include "reports/pictures/mechanism_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"

namespace kempe {
namespace {

std::string link_svg(Link link, const Design& design, const Pose& pose, double unit) {
  std::vector<Point> axis;
  for (const Joint joint : body_line(link)) axis.push_back(pose[joint]);
  std::string path = svg_line(axis);
  const bool filled = design.style.plate == PlateStyle::triangle && axis.size() == 3;
  if (filled) path += "Z";
  const double width = drawn_width(design.style, unit);
  const std::string css =
      fmt::format("link layer-{} {}", design.layers.rank(link), filled ? "filled" : "open");
  const SvgElement title =
      SvgElement("title").saying(fmt::format("link {}, layer {}", name(link), design.layers[link]));
  return SvgElement("g")
      .with("class", css)
      .holding(title.text() + rim_and_face(path, width, width - std::min(2.4 * unit, 0.5 * width)))
      .line();
}

std::string joint_svg(const CopyingLinkage& linkage, Joint joint, const Point& at, double radius) {
  const std::string_view what = role(linkage, joint);
  if (what.empty()) return svg_disc("pin", at, radius).line();
  std::string svg = svg_disc(fmt::format("mark {}", what), at, 1.55 * radius).text() +
                    svg_disc(fmt::format("core {}", what), at, 0.6 * radius).text();
  if (what == "pole") {  // fixed to the table: a cross in the disc
    const double arm = 1.55 * radius;
    svg += svg_shape("cross", svg_line({at - Point(arm, 0), at + Point(arm, 0)}) +
                                  svg_line({at - Point(0, arm), at + Point(0, arm)}))
               .text();
  }
  return svg + "\n";
}

}  // namespace

std::string rim_and_face(const std::string& axis, double rim, double face) {
  return svg_shape("rim", axis).with("stroke-width", rim).text() +
         svg_shape("face", axis).with("stroke-width", face).text();
}

std::string_view role(const CopyingLinkage& linkage, Joint joint) {
  if (joint == linkage.pole_joint()) return "pole";
  if (joint == linkage.tracer_joint()) return "tracer";
  if (joint == linkage.pen_joint()) return "pen";
  return "";
}

std::vector<Joint> body_line(Link link) {
  switch (link) {
    case Link::VA: return {Joint::V, Joint::A};
    case Link::VB: return {Joint::V, Joint::B};
    case Link::ACX: return {Joint::C, Joint::A, Joint::X};
    case Link::BCY: break;
  }
  return {Joint::C, Joint::B, Joint::Y};
}

double drawn_width(const LinkStyle& style, double unit) { return std::max(style.width, 3 * unit); }

double drawn_pin_radius(const LinkStyle& style, double unit) {
  return std::max(style.pin_diameter / 2, 3.2 * unit);
}

Ring corners(const FittingSheet& sheet) {
  const Complex turn = std::polar(1.0, sheet.turn);
  Ring ring;
  for (const Complex corner : {Complex{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    ring.push_back(sheet.centre + as_point(turn * Complex(corner.real() * sheet.width / 2,
                                                          corner.imag() * sheet.height / 2)));
  return ring;
}

std::string mechanism_svg(const Design& design, const Pose& pose, double unit) {
  std::array<Link, 4> upward = all_links;
  std::stable_sort(upward.begin(), upward.end(),
                   [&](Link a, Link b) { return design.layers[a] < design.layers[b]; });
  std::string svg = "\n";
  for (const Link link : upward) svg += link_svg(link, design, pose, unit);
  const double radius = drawn_pin_radius(design.style, unit);
  for (const Joint joint : all_joints) svg += joint_svg(design.linkage, joint, pose[joint], radius);
  return SvgElement("g").with("class", "m-mechanism").holding(svg).line();
}

}  // namespace kempe
