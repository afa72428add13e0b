#include "reports/drawings/design_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "geometry/fixed_text.hpp"
#include "geometry/stated_angle.hpp"
#include "kinematics/overloaded.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "reports/pictures/shown_place.hpp"
#include "specs/hardware.hpp"
#include "specs/text/printable.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

constexpr double row_height = 6, text_height = 3.5;  ///< mm, of the title block

const DrawingLayer assembly_layer{"ASSEMBLY", 8, "#777", false};
const DrawingLayer bodies_layer{"BODIES", 6, "#a0408a", false};
const DrawingLayer table_layer{"TABLE", 3, "#2c7a2c", false};
const DrawingLayer region_layer{"REGION", 4, "#0a8a8a", false};
const DrawingLayer copy_layer{"COPY", 2, "#b08900", false};
const DrawingLayer title_layer{"TITLE", 7, "#000", false};

/// At most four decimals, none that are zero.
std::string figure(double value) {
  constexpr int decimals = 4;
  return short_text(value, decimals);
}

/// Shapes on one layer, written at a place that moves down row by row.
class Block {
 public:
  Block(Drawing& drawing, const Point& top_left) : drawing_(drawing), at_(top_left) {}

  void row(const std::string& text, double height = text_height) {
    at_.y() -= height / text_height * row_height;
    drawing_.shapes.push_back(TextShape{title_layer.name, text, at_, height, 0, Anchor::left});
  }
  void columns(const std::vector<std::string>& cells, double step) {
    at_.y() -= row_height;
    for (std::size_t i = 0; i < cells.size(); ++i)
      drawing_.shapes.push_back(TextShape{title_layer.name, cells[i],
                                          at_ + Point(step * static_cast<double>(i), 0), text_height, 0,
                                          Anchor::left});
  }
  void gap() { at_.y() -= 0.5 * row_height; }

 private:
  Drawing& drawing_;
  Point at_;
};

OutlineShape frame(const std::string& layer, const Box& box) {
  return {layer,
          {{box.lower}, {{box.upper.x(), box.lower.y()}}, {box.upper}, {{box.lower.x(), box.upper.y()}}},
          true};
}

OutlineShape straight_outline(const std::string& layer, const Ring& ring) {
  OutlineShape shape{layer, {}, true};
  for (const Point& point : ring) shape.ring.push_back({point, 0});
  return shape;
}

/// Regions are there to look at: corners that no eye tells apart would only burden the program that opens the file.
void add_region(Drawing& drawing, const DrawingLayer& layer, const Region& region) {
  drawing.layers.push_back(layer);
  if (region.empty()) return;
  const Box box = bounding_box(region);
  const double detail = std::min(0.01, 1e-4 * (box.upper - box.lower).norm());
  for (const Polygon& polygon : region.polygons) {
    drawing.shapes.push_back(straight_outline(layer.name, thinned(polygon.outer, detail)));
    for (const Ring& hole : polygon.holes)
      drawing.shapes.push_back(straight_outline(layer.name, thinned(hole, detail)));
  }
}

std::string role(const Design& design, Joint joint) {
  if (joint == design.linkage.pole_joint()) return " pole";
  if (joint == design.linkage.tracer_joint()) return " tracer";
  if (joint == design.linkage.pen_joint()) return " pen";
  return "";
}

void add_bodies(Drawing& drawing, const Design& design, const Pose& pose) {
  if (design.bodies.empty()) return;
  drawing.layers.push_back(bodies_layer);
  for (std::size_t i = 0; i < design.bodies.size(); ++i) {
    const Body& body = design.bodies[i];
    const Point& at = pose[joint_of(body.at, design.linkage)];
    std::visit(
        Overloaded{[&](const Disc& disc) {
                     drawing.shapes.push_back(CircleShape{bodies_layer.name, disc.centre, disc.radius});
                   },
                   [&](const Polygon& polygon) {
                     drawing.shapes.push_back(straight_outline(bodies_layer.name, polygon.outer));
                   }},
        placed(body, design.linkage, pose));
    drawing.shapes.push_back(TextShape{bodies_layer.name, body_name(design.bodies, i),
                                       at - Point(0, design.style.width + text_height), text_height});
  }
}

/// The mechanism as it stands on the table, with region, copy, bodies and the table's edge.
Drawing assembly_mode(const Design& design) {
  Drawing drawing{{assembly_layer}, {}};
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    drawing.shapes.push_back(
        OutlineShape{assembly_layer.name, link_outline(link, pose, design.style).outer, true});
  for (const Joint joint : all_joints) {
    const double radius = 0.5 * pin_at(design.style, design.hardware, joint);
    drawing.shapes.push_back(CircleShape{assembly_layer.name, pose[joint], radius});
    const Point beside = pose[joint] + Point(0.5 * design.style.width + 1, 0.5 * design.style.width);
    drawing.shapes.push_back(
        TextShape{assembly_layer.name, letter(joint) + role(design, joint), beside, text_height});
  }
  add_bodies(drawing, design, pose);
  if (design.table) add_region(drawing, table_layer, Region{{*design.table}});
  add_region(drawing, region_layer, design.region);
  add_region(drawing, copy_layer, similar_image(design.region, design.linkage.k(), design.linkage.pole()));
  return drawing;
}

std::string stack_text(const LayerAssignment& layers) {
  std::string text;
  for (int layer = 1; layer <= layers.highest(); ++layer) {
    text += fmt::format("{}{} =", layer > 1 ? ", " : "", layer);
    for (const Link link : all_links)
      if (layers[link] == layer) text += fmt::format(" {}", name(link));
    if (!layers.has_links_in(layer)) text += " empty";
  }
  return text;
}

std::string cutting_text(const CuttingSpec& cutting) {
  if (cutting.kerf == 0) return "Outlines as designed: no kerf taken into account";
  return fmt::format("Outlines grown, holes shrunk for a kerf of {} mm", figure(cutting.kerf));
}

std::string copy_text(const Design& design) {
  return fmt::format("Copying linkage, scale {}, rotation {} deg", figure(design.scale),
                     figure(stated_degrees(design.rotation)));
}

void add_figures(Block& block, const Design& design, const CuttingSpec& cutting) {
  const CopyingLinkage& linkage = design.linkage;
  std::array<double, 6> pins{}, holes{};
  for (std::size_t i = 0; i < all_joints.size(); ++i) {
    pins[i] = pin_at(design.style, design.hardware, all_joints[i]);
    holes[i] =
        std::max(0.0, hole_diameter(design.style, design.hardware, all_joints[i], cutting) - cutting.kerf);
  }
  block.row(drawing_title(design), 5);
  if (!design.title.empty()) block.row(copy_text(design));
  block.gap();
  block.row(fmt::format("Pole {} at ({}, {}), tracer {}, pen {}", letter(linkage.pole_joint()),
                        figure(linkage.pole().x()), figure(linkage.pole().y()),
                        letter(linkage.tracer_joint()), letter(linkage.pen_joint())));
  block.row(design.opening.empty() ? "No opening keeps the transmission angle and the clearance asked for"
                                   : fmt::format("Angle from bar VA to bar VB kept within {} .. {} deg",
                                                 figure(stated_degrees(design.opening.lower)),
                                                 figure(stated_degrees(design.opening.upper))));
  block.row("Layers from the table up: " + stack_text(design.layers));
  block.row(fmt::format("Stock {} mm thick, links {} mm wide, pins {} mm, holes {} mm as drawn",
                        figure(design.style.thickness), figure(design.style.width), by_joint(pins, figure),
                        by_joint(holes, figure)));
  block.row(cutting_text(cutting));
  if (const auto fault = parts_fault(design, cutting)) block.row("The links cannot be cut: " + fault->note);
  block.row("Units mm, scale 1:1, seen from above");
}

void add_lengths(Block& block, const LinkLengths& lengths) {
  block.row("Between joints, mm");
  const auto values = lengths.values();
  for (std::size_t i = 0; i < values.size(); i += 2)
    block.columns({fmt::format("{} = {}", LinkLengths::names[i], figure(values[i])),
                   fmt::format("{} = {}", LinkLengths::names[i + 1], figure(values[i + 1]))},
                  45);
}

Drawing title_block(const Design& design, const CuttingSpec& cutting) {
  Drawing drawing{{title_layer}, {}};
  Block block(drawing, Point::Zero());
  add_figures(block, design, cutting);
  block.gap();
  add_lengths(block, design.linkage.lengths());
  Box box = bounding_box(drawing);
  box.lower -= Point(4, 4);
  box.upper += Point(4, 4);
  drawing.shapes.push_back(frame(title_layer.name, box));
  return drawing;
}

/// Drawings set beside each other in rows no wider than `width`, the next row below.
class Rows {
 public:
  Rows(Drawing& sheet, double width, double gap) : sheet_(sheet), width_(width), gap_(gap) {}

  void add(const Drawing& drawing) {
    const Box box = bounding_box(drawing);
    const Point size = box.upper - box.lower;
    if (x_ > 0 && x_ + size.x() > width_) next_row();
    append(sheet_, drawing, {Point(x_, y_ - size.y()) - box.lower, 0});
    x_ += size.x() + gap_;
    depth_ = std::max(depth_, size.y());
  }
  void next_row() {
    y_ -= depth_ + gap_;
    x_ = depth_ = 0;
  }

 private:
  Drawing& sheet_;
  double width_, gap_;
  double x_ = 0, y_ = 0, depth_ = 0;
};

double width_of(const Drawing& drawing) {
  const Box box = bounding_box(drawing);
  return box.upper.x() - box.lower.x();
}

}  // namespace

Pose assembly_pose(const Design& design) {
  const CopyingLinkage& linkage = design.linkage;
  Point middle = place_to_show(design);
  if (!design.region.empty()) {
    const Box box = bounding_box(design.region);
    middle = 0.5 * (box.lower + box.upper);
    const auto pose = linkage.pose_with_tracer_at(middle);
    if (pose && design.opening.contains(*linkage.opening_at((middle - linkage.pole()).norm()))) return *pose;
  }
  const Point towards = middle - linkage.pole();
  return linkage.pose_at(openings_to_show(design).middle(), std::atan2(towards.y(), towards.x()));
}

std::string drawing_title(const Design& design) {
  constexpr std::size_t most = 60;  // bytes: what stands in a line of the block
  return design.title.empty() ? copy_text(design) : printable(design.title, most);
}

Drawing design_drawing(const Design& design, const CuttingSpec& cutting) {
  std::vector<Drawing> links;
  for (const CutPart& part : cut_parts(design, cutting)) links.push_back(part_drawing(part));
  const Drawing assembled = assembly_mode(design), title = title_block(design, cutting);
  const double gap = std::max(cutting.gap, 0.5 * design.style.width);
  double width = width_of(assembled) + gap + width_of(title);
  for (const Drawing& link : links) width = std::max(width, width_of(link));
  Drawing sheet;
  Rows rows(sheet, width + 1e-9, gap);
  for (const Drawing& link : links) rows.add(link);
  rows.next_row();
  rows.add(assembled);
  rows.add(title);
  return sheet;
}

}  // namespace kempe
