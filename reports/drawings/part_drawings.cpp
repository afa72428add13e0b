#include "reports/drawings/part_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// Ways with room, the longest first.
std::vector<FreeWay> free_ways(Link link, const Pose& pose, const LinkStyle& style, double hole) {
  std::vector<FreeWay> ways;
  for (const JointPair& pair : pairs_of(link))
    if (const double length = free_way(link, pose, pair, style, hole); length > 0)
      ways.push_back({pair, length});
  std::stable_sort(ways.begin(), ways.end(),
                   [](const FreeWay& a, const FreeWay& b) { return a.length > b.length; });
  return ways;
}

/// What a text covers.
struct TextBox {
  Point middle, along, half;  ///< `along`: of size 1; `half`: along it and across
  explicit TextBox(const TextShape& text)
      : middle(text.at + 0.5 * text.height * as_point(std::polar(1.0, text.turn + pi / 2))),
        along(as_point(std::polar(1.0, text.turn))), half(0.5 * text_width(text), 0.5 * text.height) {}

  Point across() const { return {-along.y(), along.x()}; }
  double reach(const Point& direction) const {
    return half.x() * std::abs(along.dot(direction)) + half.y() * std::abs(across().dot(direction));
  }
};

bool are_apart(const TextBox& one, const TextBox& other) {
  const Point way = other.middle - one.middle;
  const Point axes[] = {one.along, one.across(), other.along, other.across()};
  return std::any_of(std::begin(axes), std::end(axes), [&](const Point& axis) {
    return std::abs(way.dot(axis)) > one.reach(axis) + other.reach(axis);
  });
}

bool are_apart(const TextBox& box, const CutPart::Hole& hole) {
  const Point way = hole.centre - box.middle;
  const Point outside =
      (Point(way.dot(box.along), way.dot(box.across())).cwiseAbs() - box.half).cwiseMax(0.0);
  return outside.norm() > 0.5 * hole.diameter + 0.2 * box.half.y();
}

/// Engraves a link in letters of one height.
class Engraving {
 public:
  Engraving(const CutPart& part, const Pose& pose, const std::vector<FreeWay>& ways, double hole,
            double height)
      : part_(part), pose_(pose), ways_(ways), hole_(hole), height_(height) {}

  /// The name in the middle of the longest way that has room for it, else beside the middle, each joint's letter beside its hole; of the
  /// places of the name the first that leaves room for every letter, or for the most. Empty where the name has no room.
  std::vector<TextShape> labels() const {
    std::vector<TextShape> most;
    for (const FreeWay& way : ways_)
      for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7}) {
        const Point &start = pose_[way.pair.from], &end = pose_[way.pair.to];
        const TextShape name = text_along(part_.name, start + share * (end - start), end - start, height_);
        if (!has_room(name, {})) continue;
        std::vector<TextShape> labels{name};
        for (const CutPart::Hole& hole : part_.holes) add_letter(hole.joint, labels);
        if (labels.size() > most.size()) most = std::move(labels);
        if (is_complete(most)) return most;
      }
    return most;
  }

  bool is_complete(const std::vector<TextShape>& labels) const {
    return labels.size() == 1 + part_.holes.size();
  }

 private:
  void add_letter(Joint joint, std::vector<TextShape>& labels) const {
    for (const FreeWay& way : ways_) {
      if ((way.pair.from != joint && way.pair.to != joint) || way.length < 3 * height_) continue;
      const Point along =
          (pose_[way.pair.from == joint ? way.pair.to : way.pair.from] - pose_[joint]).normalized();
      const TextShape text = text_along(std::string(1, letter(joint)),
                                        pose_[joint] + (0.5 * hole_ + 0.9 * height_) * along, along, height_);
      if (has_room(text, labels)) return labels.push_back(text);
    }
  }

  bool has_room(const TextShape& text, const std::vector<TextShape>& labels) const {
    const TextBox box(text);
    return std::all_of(part_.holes.begin(), part_.holes.end(),
                       [&](const CutPart::Hole& hole) { return are_apart(box, hole); }) &&
           std::all_of(labels.begin(), labels.end(),
                       [&](const TextShape& other) { return are_apart(box, TextBox(other)); });
  }

  const CutPart& part_;
  const Pose& pose_;
  const std::vector<FreeWay>& ways_;
  double hole_, height_;
};

/// Name and letters, as large as they fit; letters that have no room in letters a third as high are left out.
std::vector<TextShape> engraving(const CutPart& part, Link link, const Pose& pose, const LinkStyle& style) {
  const double hole = widest_hole(part);
  const auto ways = free_ways(link, pose, style, hole);
  if (ways.empty()) return {};
  const double characters = static_cast<double>(part.name.size()) + 5;  // two letters and the gaps between
  const double largest = std::min(0.4 * style.width, ways.front().length / (0.85 * characters));
  std::vector<TextShape> most;
  for (double height = largest; height > 0.3 * largest; height *= 0.8) {
    const Engraving engraved(part, pose, ways, hole, height);
    std::vector<TextShape> labels = engraved.labels();
    if (labels.size() > most.size()) most = std::move(labels);
    if (engraved.is_complete(most)) break;
  }
  return most;
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
  part.labels = engraving(part, link, lying, style);
  return part;
}

std::array<CutPart, 4> cut_parts(const Design& design, const CuttingSpec& cutting) {
  std::array<CutPart, 4> parts;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = cut_part(design, all_links[i], cutting);
  return parts;
}

CuttingSpec finished(CuttingSpec cutting) {
  cutting.kerf = 0;
  return cutting;
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
