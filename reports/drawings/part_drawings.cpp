#include "reports/drawings/part_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/drawings/blank.hpp"
#include "specs/hardware.hpp"

namespace kempe {
namespace {

struct JointPair {
  Joint from, to;
};

std::vector<JointPair> pairs_of(Link link) {
  const auto j = joints_of(link).joints;
  if (joints_of(link).count == 2) return {{j[0], j[1]}};
  return {{j[0], j[1]}, {j[0], j[2]}, {j[1], j[2]}};
}

/// How much of the way between two joints is free of holes, mm; 0 if the third joint's hole is in the way or
/// the way is not inside the plate.
double free_way(Link link, const Pose& pose, const JointPair& pair, const LinkStyle& style, double hole) {
  const Point way = pose[pair.to] - pose[pair.from];
  const LinkJoints joints = joints_of(link);
  for (int i = 0; i < joints.count; ++i) {
    const Joint third = joints.joints[static_cast<std::size_t>(i)];
    if (third == pair.from || third == pair.to) continue;
    const Point offset = pose[third] - pose[pair.from];
    const double along = offset.dot(way) / way.norm(), aside = std::abs(cross(way, offset)) / way.norm();
    const bool is_arm = style.plate == PlateStyle::triangle || third != joints.joints[0];
    if (!is_arm && aside > 0.25 * style.width) return 0;
    if (along > -hole && along < way.norm() + hole && aside < hole) return 0;
  }
  return std::max(0.0, way.norm() - hole);
}

/// A text centred on a point of a way, readable from below or from the right.
TextShape text_along(const std::string& text, const Point& middle, const Point& way, double height) {
  double turn = std::atan2(way.y(), way.x());
  if (turn > pi / 2 + 1e-9) turn -= pi;
  if (turn <= -pi / 2 + 1e-9) turn += pi;
  const Point up = as_point(std::polar(1.0, turn + pi / 2));
  return {std::string(label_layer), text, middle - 0.5 * height * up, height, turn, Anchor::middle};
}

struct FreeWay {
  JointPair pair;
  double length;
};

/// The longest free way that ends at `joint` (at any joint, if none is given).
std::optional<FreeWay> longest_way(const std::vector<FreeWay>& ways, std::optional<Joint> joint) {
  std::optional<FreeWay> best;
  for (const FreeWay& way : ways)
    if ((!joint || way.pair.from == *joint || way.pair.to == *joint) && way.length > 0 &&
        (!best || way.length > best->length))
      best = way;
  return best;
}

/// The name in the middle of the longest free way, each joint's letter beside its hole.
std::vector<TextShape> engraving(Link link, const Pose& pose, const LinkStyle& style, double hole) {
  std::vector<FreeWay> ways;
  for (const JointPair& pair : pairs_of(link))
    ways.push_back({pair, free_way(link, pose, pair, style, hole)});
  const auto main_way = longest_way(ways, std::nullopt);
  if (!main_way) return {};
  const std::string text(name(link));
  const double characters = static_cast<double>(text.size()) + 5;  // two letters and the gaps between
  const double height = std::min(0.4 * style.width, main_way->length / (0.85 * characters));
  const Point &start = pose[main_way->pair.from], &end = pose[main_way->pair.to];
  std::vector<TextShape> labels{text_along(text, 0.5 * (start + end), end - start, height)};
  const LinkJoints joints = joints_of(link);
  for (int i = 0; i < joints.count; ++i) {
    const Joint joint = joints.joints[static_cast<std::size_t>(i)];
    const auto way = longest_way(ways, joint);
    if (!way || way->length < 3 * height) continue;
    const Joint other = way->pair.from == joint ? way->pair.to : way->pair.from;
    const Point along = (pose[other] - pose[joint]).normalized();
    labels.push_back(text_along(std::string(1, letter(joint)),
                                pose[joint] + (0.5 * hole + 0.9 * height) * along, along, height));
  }
  return labels;
}

DrawingLayer cut_layer(const std::string& name) {
  // Links that share a layer of the mechanism differ in colour too.
  if (name == "VA") return {name, 5, "#1f5fa8", true};
  if (name == "VB") return {name, 3, "#1d7a3a", true};
  if (name == "ACX") return {name, 30, "#b35900", true};
  return {name, 6, "#8a2a8f", true};
}

double least_wall(const CutPart& part, double width) {
  double wall = 0.5 * (width - widest_hole(part));
  for (std::size_t i = 0; i < part.holes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      wall = std::min(wall, (part.holes[i].centre - part.holes[j].centre).norm() -
                                0.5 * (part.holes[i].diameter + part.holes[j].diameter));
  return wall;
}

}  // namespace

CutPart cut_part(const Design& design, Link link, const CuttingSpec& cutting) {
  const LinkStyle& style = design.style;
  LinkStyle as_cut = style;
  as_cut.width += cutting.kerf;
  const Pose lying = lying_pose(design, link);
  CutPart part;
  part.name = name(link);
  part.layer = design.layers[link];
  part.thickness = style.thickness;
  part.outline = link_outline(link, lying, as_cut).outer;
  const LinkJoints joints = joints_of(link);
  for (int i = 0; i < joints.count; ++i) {
    const Joint joint = joints.joints[static_cast<std::size_t>(i)];
    const double hole = hole_diameter(style, design.hardware, joint, cutting) - cutting.kerf;
    part.holes.push_back({joint, lying[joint], std::max(0.0, hole)});
  }
  part.wall = least_wall(part, as_cut.width);
  part.labels = engraving(link, lying, style, widest_hole(part));
  return part;
}

std::array<CutPart, 4> cut_parts(const Design& design, const CuttingSpec& cutting) {
  std::array<CutPart, 4> parts;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = cut_part(design, all_links[i], cutting);
  return parts;
}

double widest_hole(const CutPart& part) {
  double widest = 0;
  for (const CutPart::Hole& hole : part.holes) widest = std::max(widest, hole.diameter);
  return widest;
}

double area(const CutPart& part) {
  double holes = 0;
  for (const CutPart::Hole& hole : part.holes) holes += 0.25 * pi * hole.diameter * hole.diameter;
  return signed_area(part.outline) - holes;
}

Drawing part_drawing(const CutPart& part) {
  Drawing drawing{{cut_layer(part.name), {std::string(label_layer), 1, "#c00000", false}}, {}};
  drawing.shapes.push_back(OutlineShape{part.name, part.outline, true});
  for (const CutPart::Hole& hole : part.holes)
    if (hole.diameter > 0) drawing.shapes.push_back(CircleShape{part.name, hole.centre, 0.5 * hole.diameter});
  drawing.shapes.insert(drawing.shapes.end(), part.labels.begin(), part.labels.end());
  return drawing;
}

}  // namespace kempe
