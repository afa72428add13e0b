// The mechanism from above, with hidden edges and the numbers of its parts.

#include <algorithm>
#include <cmath>

#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/workshop/dimension.hpp"
#include "reports/workshop/sheets.hpp"
#include "reports/workshop/words.hpp"
#include "specs/hardware.hpp"

namespace kempe::workshop {
namespace {

/// A part that a balloon points at, on the sheet.
struct Pointed {
  int item;
  Point target;
};

struct Assembly {
  const Task& task;
  Pose pose;
  View view;
};

ArcRing outline_of(const Assembly& assembly, Link link) {
  return assembly.view.at(link_outline(link, assembly.pose, assembly.task.design.style).outer);
}

std::vector<Link> from_below(const LayerAssignment& layers) {
  std::vector<Link> links(all_links.begin(), all_links.end());
  std::stable_sort(links.begin(), links.end(), [&](Link a, Link b) { return layers[a] < layers[b]; });
  return links;
}

/// Each link hides what is below it; then every edge once more, dashed: it shows where it is hidden, and vanishes in its own
/// full line elsewhere.
void draw_links(Sheet& sheet, const Assembly& assembly) {
  const auto links = from_below(assembly.task.design.layers);
  for (const Link link : links) sheet.outline(outline_of(assembly, link), Pen::outline, Fill::paper);
  for (const Link link : links) sheet.outline(outline_of(assembly, link), Pen::hidden);
}

/// The pole: two opposite quarters of its pin filled.
void draw_pole(Sheet& sheet, const Point& at, double radius) {
  const double quarter_bulge = std::tan(pi / 8);
  for (const Complex start : {Complex(1, 0), Complex(-1, 0)}) {
    const Point from = at + radius * as_point(start), to = at + radius * as_point(start * Complex(0, 1));
    sheet.marks.emplace_back(
        SheetPath{{{at}, {from, quarter_bulge}, {to}}, true, Pen::thin, Fill::ink, false});
  }
}

void draw_joints(Sheet& sheet, const Assembly& assembly) {
  const Design& design = assembly.task.design;
  const auto radius_at = [&](Joint joint) {
    return 0.5 * pin_at(design.style, design.hardware, joint) * assembly.view.scale;
  };
  for (const Joint joint : all_joints) {
    const double radius = radius_at(joint);
    const Point at = assembly.view.at(assembly.pose[joint]);
    sheet.circle(at, radius, Pen::outline, Fill::paper);
    draw_hole_axes(sheet, at, radius);
  }
  draw_pole(sheet, assembly.view.at(design.linkage.pole()), radius_at(design.linkage.pole_joint()));
}

/// How far a place is from everything that could hide it, mm: upper links and joints.
double room_at(const Assembly& assembly, const Point& at, const std::vector<Polygon>& above) {
  const LinkStyle& style = assembly.task.design.style;
  double room = 2 * style.width;
  for (const Joint joint : all_joints)
    room = std::min(room, (assembly.pose[joint] - at).norm() - 0.5 * style.pin_diameter);
  for (const Polygon& one : above) room = std::min(room, distance(Region{{one}}, at));
  return room;
}

/// A place on the link's axis that no upper link hides and that is far from its joints, on the sheet.
Point visible_place(const Assembly& assembly, Link link) {
  constexpr int places = 40;
  constexpr double detail = 0.1;  // mm
  const Design& design = assembly.task.design;
  std::vector<Polygon> above;
  for (const Link other : all_links)
    if (design.layers[other] > design.layers[link])
      above.push_back(flattened(link_outline(other, assembly.pose, design.style), detail, Flatten::grows));
  Point best = assembly.pose[joints_of(link).joints[0]];
  double best_room = -1;
  const auto line = body_line(link);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int k = 1; k < places; ++k) {
      const double share = static_cast<double>(k) / places;
      const Point at = (1 - share) * assembly.pose[line[i]] + share * assembly.pose[line[i + 1]];
      const double room = room_at(assembly, at, above);
      if (room <= best_room) continue;
      best_room = room;
      best = at;
    }
  return assembly.view.at(best);
}

std::vector<Pointed> pointed_parts(const Assembly& assembly) {
  const Task& task = assembly.task;
  std::vector<Pointed> parts;
  for (const Link link : all_links)
    parts.push_back({item_number(task.bill, name(link)), visible_place(assembly, link)});
  for (const JointStack& stack : joint_stacks(task.design))
    parts.push_back({item_number(task.bill, stack.name), assembly.view.at(assembly.pose[stack.joint])});
  return parts;
}

/// Heights for balloons beside the drawing: those wanted, moved apart as little as it takes, the highest first.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double lower, double upper) {
  std::vector<double> heights = wanted;
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = std::min(heights[i], i == 0 ? upper : heights[i - 1] - apart);
  for (std::size_t i = heights.size(); i-- > 0;)
    heights[i] = std::max(heights[i], i + 1 == heights.size() ? lower : heights[i + 1] + apart);
  return heights;
}

/// Balloons in a column on either side, in the order of what they point at, so that their lines do not cross.
void draw_balloons(Sheet& sheet, std::vector<Pointed> parts, const Box& drawn, const Box& field,
                   LabelPlacer& labels) {
  constexpr double away = 14, apart = 2 * balloon_radius + 2;
  std::sort(parts.begin(), parts.end(),
            [](const Pointed& a, const Pointed& b) { return a.target.x() < b.target.x(); });
  const std::size_t half = parts.size() / 2;
  for (const bool left : {true, false}) {
    std::vector<Pointed> column(left ? parts.begin() : parts.begin() + static_cast<std::ptrdiff_t>(half),
                                left ? parts.begin() + static_cast<std::ptrdiff_t>(half) : parts.end());
    std::sort(column.begin(), column.end(),
              [](const Pointed& a, const Pointed& b) { return a.target.y() > b.target.y(); });
    std::vector<double> wanted;
    for (const Pointed& part : column) wanted.push_back(part.target.y());
    const auto heights =
        spread(wanted, apart, field.lower.y() + balloon_radius, field.upper.y() - balloon_radius);
    const double x = left ? drawn.lower.x() - away : drawn.upper.x() + away;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const Point at(x, heights[i]);
      draw_balloon(sheet, column[i].item, at, column[i].target);
      labels.avoid(at, column[i].target, 0.3);
      labels.avoid(PictureBox{at, Point(balloon_radius, balloon_radius)});
    }
  }
}

/// Letters of the joints and what they carry, clear of edges and of leaders.
void draw_letters(const Assembly& assembly, Words& words) {
  const Design& design = assembly.task.design;
  LabelPlacer& labels = words.placer();
  for (const Link link : all_links) {
    const ArcPolygon outline{outline_of(assembly, link), {}};
    const Ring ring = flattened(outline, 0.3, Flatten::grows).outer;
    for (std::size_t i = 0; i < ring.size(); ++i) labels.avoid(ring[i], ring[(i + 1) % ring.size()], 0.3);
  }
  const double radius = 0.5 * design.style.pin_diameter * assembly.view.scale + 2;
  Point middle = Point::Zero();
  for (const Joint joint : all_joints) {
    const Point at = assembly.view.at(assembly.pose[joint]);
    labels.avoid(PictureBox{at, Point(radius, radius)});
    middle += at / static_cast<double>(all_joints.size());
  }
  for (const Joint joint : all_joints) {
    const std::string_view task = role(design.linkage, joint);
    const std::string text = std::string(1, letter(joint)) + (task.empty() ? "" : " ") + std::string(task);
    const Point at = assembly.view.at(assembly.pose[joint]);
    words.write(text, at, radius, heading_height, at - middle);
  }
}

Box box_of(const Pose& pose, const LinkStyle& style) {
  Box box{pose.V, pose.V};
  for (const Link link : all_links) {
    const Box one = bounding_box(link_outline(link, pose, style).outer);
    box.lower = box.lower.cwiseMin(one.lower);
    box.upper = box.upper.cwiseMax(one.upper);
  }
  return box;
}

}  // namespace

Sheet assembly_sheet(const Task& task) {
  const Design& design = task.design;
  const Pose pose = assembly_pose(design);
  const Box box = box_of(pose, design.style);
  const Point extent = box.upper - box.lower;
  const Orientation orientation = extent.x() > extent.y() ? Orientation::landscape : Orientation::portrait;
  const Point size = sheet_size(task.paper, orientation);
  const Box field = room_of(size);
  const Point beside(26, 14);  // for balloons and letters
  const double scale = fitting_scale(extent, field.upper - field.lower - 2 * beside);
  Sheet sheet{size, {"Assembly, seen from above", stock_text(design), scale_text(scale)}};
  const Assembly assembly{
      task, pose, {scale, 0.5 * (field.lower + field.upper) - scale * 0.5 * (box.lower + box.upper)}};
  draw_links(sheet, assembly);
  draw_joints(sheet, assembly);
  Words words(sheet, task.lettering, field);
  const Box drawn{assembly.view.at(box.lower), assembly.view.at(box.upper)};
  draw_balloons(sheet, pointed_parts(assembly), drawn, field, words.placer());
  draw_letters(assembly, words);
  if (scale == 1 && drawn.lower.y() - 14 > field.lower.y() + ruler_room) draw_ruler(sheet);
  return sheet;
}

}  // namespace kempe::workshop
