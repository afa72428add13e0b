// Where things lie on the table, from its left and its front edge.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/drawings/bench_space.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/workshop/dimension.hpp"
#include "reports/workshop/sheets.hpp"
#include "reports/workshop/table.hpp"
#include "reports/workshop/words.hpp"
#include "specs/hardware.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe::workshop {
namespace {

/// A place to mark on the table.
struct Mark {
  std::string name;
  Point at;
};

void include(Box& box, const Box& other) {
  box.lower = box.lower.cwiseMin(other.lower);
  box.upper = box.upper.cwiseMax(other.upper);
}
void include(Box& box, const Region& region) {
  if (!region.empty()) include(box, bounding_box(region));
}

struct NamedRegion {
  std::string name;
  Region region;
};

/// Bodies where the drawn mechanism carries them.
std::vector<NamedRegion> bodies_of(const Design& design) {
  std::vector<NamedRegion> outlines;
  const Pose pose = assembly_pose(design);
  for (std::size_t i = 0; i < design.bodies.size(); ++i) {
    const std::variant<Disc, Polygon> shape = placed(design.bodies[i], design.linkage, pose);
    const auto* disc = std::get_if<Disc>(&shape);
    outlines.push_back({body_name(design.bodies, i), disc != nullptr
                                                         ? Region::circle(disc->centre, disc->radius)
                                                         : Region{{std::get<Polygon>(shape)}}});
  }
  return outlines;
}

/// The table's edges; without a table those of what a bench must hold: all that moves, the original, the copy, what stands in
/// the way.
Box edges_of(const Design& design, const Region& copy) {
  if (design.table) return bounding_box(Region{{*design.table}});
  const Point pole = design.linkage.pole();
  Box box{pole, pole};
  if (const auto swept = swept_box(design)) include(box, *swept);
  for (const Region& region : {design.region, copy}) include(box, region);
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    include(box, flattened(ArcRegion{link_outline(link, pose, design.style)}, 0.1, Flatten::grows));
  for (const Obstacle& obstacle : design.obstacles) include(box, Region{{obstacle.shape}});
  for (const NamedRegion& body : bodies_of(design)) include(box, body.region);
  return box;
}

std::vector<Mark> marks_of(const Design& design, const Region& copy) {
  std::vector<Mark> marks{
      {fmt::format("pole {}", letter(design.linkage.pole_joint())), design.linkage.pole()}};
  const auto corners = [&](const std::string& name, const Region& region) {
    if (region.empty()) return;
    const Box box = bounding_box(region);
    marks.push_back({name + ", left and front", box.lower});
    marks.push_back({name + ", right and back", box.upper});
  };
  corners("original", design.region);
  corners("copy", copy);
  for (std::size_t i = 0; i < design.obstacles.size(); ++i)
    corners(obstacle_name(design.obstacles, i), Region{{design.obstacles[i].shape}});
  return marks;
}

void draw_region(Sheet& sheet, const View& view, const Region& region, Pen pen, Fill fill = Fill::none) {
  constexpr double detail = 0.05;  // mm on paper
  for (const Polygon& polygon : region.polygons) {
    std::vector<const Ring*> rings{&polygon.outer};
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
    for (const Ring* ring : rings) {
      ArcRing line;
      for (const Point& point : thinned(*ring, detail / view.scale)) line.push_back({view.at(point)});
      sheet.outline(line, pen, ring == &polygon.outer ? fill : fill == Fill::none ? Fill::none : Fill::paper);
    }
  }
}

constexpr double cross_half = 1.5;  ///< mm, of a mark

void draw_cross(Sheet& sheet, const Point& at) {
  sheet.line(at - Point(cross_half, cross_half), at + Point(cross_half, cross_half), Pen::thin);
  sheet.line(at - Point(cross_half, -cross_half), at + Point(cross_half, -cross_half), Pen::thin);
}

void draw_mechanism(Sheet& sheet, const Design& design, const View& view) {
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    sheet.outline(view.at(link_outline(link, pose, design.style).outer), Pen::thin);
  for (const Joint joint : all_joints)
    sheet.circle(view.at(pose[joint]), 0.5 * pin_at(design.style, design.hardware, joint) * view.scale,
                 Pen::thin);
}

Table places_table(const std::vector<Mark>& marks, const Box& edges) {
  Table table{"Places on the bench, mm",
              {{"No.", 11, Align::middle},
               {"What", 74},
               {"From the left edge", 42, Align::right},
               {"From the front edge", 42, Align::right}}};
  int number = 0;
  for (const Mark& mark : marks) {
    const Point from = mark.at - edges.lower;
    table.rows.push_back({fmt::format("{}", ++number), mark.name, figure(from.x()), figure(from.y())});
  }
  return table;
}

/// How the plan and its table share the paper.
struct BenchLayout {
  Orientation orientation = Orientation::portrait;
  bool table_below = true;  ///< else it has sheets of its own
  Box field{};              ///< of the plan, mm on paper
  double scale = 0;
};

constexpr double above_places = 4;  ///< mm, of plan and table

/// The largest scale of those that fit; the table stands below the plan unless a sheet of its own makes the plan larger.
BenchLayout bench_layout(const Task& task, const Point& extent, const Table& table) {
  const Point before(16, 16), behind(12, 12);  // for dimensions, mm
  BenchLayout best;
  for (const bool table_below : {true, false})
    for (const Orientation orientation : {Orientation::portrait, Orientation::landscape}) {
      Box field = room_of(sheet_size(task.paper, orientation));
      if (table_below) field.lower.y() += table.height(task.lettering) + above_places;
      field.lower += before;
      field.upper -= behind;
      const Point room = field.upper - field.lower;
      if (!(room.y() > 0)) continue;
      const double scale = fitting_scale(extent, room);
      if (scale > best.scale) best = {orientation, table_below, field, scale};
    }
  return best;
}

/// All that the plan shows.
struct Plan {
  const Task& task;
  Region copy;
  std::vector<NamedRegion> bodies;
  Box edges;
  std::vector<Mark> marks;
  View view;
  Box on_paper() const { return {view.at(edges.lower), view.at(edges.upper)}; }
};

void draw_things(Sheet& sheet, const Plan& plan) {
  const Design& design = plan.task.design;
  const View& view = plan.view;
  draw_region(sheet, view, design.footprint, Pen::hatch, Fill::shade);
  draw_region(sheet, view, design.region, Pen::outline, Fill::paper);
  draw_region(sheet, view, plan.copy, Pen::outline, Fill::paper);
  for (const Obstacle& obstacle : design.obstacles)
    draw_region(sheet, view, Region{{obstacle.shape}}, Pen::phantom);
  for (const NamedRegion& body : plan.bodies) draw_region(sheet, view, body.region, Pen::phantom);
  // The circle of a body that turns may reach beyond the table, which the body does not.
  sheet.marks.emplace_back(ClipBegin{plan.on_paper()});
  for (const Body& body : design.bodies) draw_region(sheet, view, swept_outline(design, body), Pen::phantom);
  sheet.marks.emplace_back(ClipEnd{});
  draw_mechanism(sheet, design, view);
  if (design.table) draw_region(sheet, view, Region{{*design.table}}, Pen::outline);
  sheet.rectangle(plan.on_paper(), design.table ? Pen::thin : Pen::outline);
}

/// Words keep clear of every line of the plan.
void avoid_lines(Words& words, const Plan& plan) {
  const Design& design = plan.task.design;
  const View& view = plan.view;
  const Region frame = Region::rectangle(plan.edges.lower, plan.edges.upper - plan.edges.lower);
  for (const Region* region : {&design.region, &plan.copy, &design.footprint, &frame})
    words.avoid_edges(view, *region);
  if (design.table) words.avoid_edges(view, Region{{*design.table}});
  for (const Obstacle& obstacle : design.obstacles) words.avoid_edges(view, Region{{obstacle.shape}});
  for (const NamedRegion& body : plan.bodies) words.avoid_edges(view, body.region);
  for (const Body& body : design.bodies) words.avoid_edges(view, swept_outline(design, body));
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    words.avoid_edges(view,
                      flattened(ArcRegion{link_outline(link, pose, design.style)}, 0.1, Flatten::grows));
  const Point pole = view.at(design.linkage.pole()), corner = plan.on_paper().lower;
  words.placer().avoid({corner.x(), pole.y()}, pole, 0.3);
  words.placer().avoid({pole.x(), corner.y()}, pole, 0.3);
  for (const Joint joint : all_joints) {
    const double radius = 0.5 * pin_at(design.style, design.hardware, joint) * view.scale;
    words.placer().avoid(PictureBox{view.at(pose[joint]), Point(radius, radius)});
  }
  for (const Mark& mark : plan.marks)
    words.placer().avoid(PictureBox{view.at(mark.at), Point(cross_half, cross_half)});
}

/// Names first, those that may need a leader before those that it must not strike through: numbers find room beside their crosses,
/// names only where the regions have it.
void write_words(Sheet& sheet, const Plan& plan) {
  Words words(sheet, plan.task.lettering, plan.on_paper());
  avoid_lines(words, plan);
  for (const NamedRegion& body : plan.bodies) words.write_in(body.name, plan.view, body.region, text_height);
  words.write_in("original", plan.view, plan.task.design.region, text_height);
  words.write_in("copy", plan.view, plan.copy, text_height);
  constexpr std::size_t most_numbers = 200;  // on a plan with more nothing could be read
  int number = 0;
  for (const Mark& mark : plan.marks) {
    draw_cross(sheet, plan.view.at(mark.at));
    if (plan.marks.size() <= most_numbers)
      words.write(fmt::format("{}", ++number), plan.view.at(mark.at), cross_half, heading_height);
  }
}

void draw_bench_dimensions(Sheet& sheet, const Plan& plan) {
  const Lettering& lettering = plan.task.lettering;
  const Box on_paper = plan.on_paper();
  const Point place = plan.task.design.linkage.pole(), pole = plan.view.at(place);
  const Point from_edges = place - plan.edges.lower, extent = plan.edges.upper - plan.edges.lower;
  dimension_along_x(sheet, on_paper.lower, pole, on_paper.lower.y() - dimension_step - 2,
                    figure(from_edges.x()), lettering, true);
  dimension_along_y(sheet, on_paper.lower, pole, on_paper.lower.x() - dimension_step - 2,
                    figure(from_edges.y()), lettering, true);
  // The edges' names stand at the ends that are farther from the pole's dimensions.
  const Point middle = 0.5 * (on_paper.lower + on_paper.upper);
  const bool pole_right = pole.x() > middle.x(), pole_back = pole.y() > middle.y();
  sheet.text("front edge", {pole_right ? on_paper.lower.x() : on_paper.upper.x(), on_paper.lower.y() - 4},
             text_height, pole_right ? Align::left : Align::right);
  sheet.text("left edge", {on_paper.lower.x() - 1.5, pole_back ? on_paper.lower.y() : on_paper.upper.y()},
             text_height, pole_back ? Align::left : Align::right, 0.5 * pi);
  dimension_along_x(sheet, {on_paper.lower.x(), on_paper.upper.y()}, on_paper.upper,
                    on_paper.upper.y() + dimension_step, figure(extent.x()), lettering);
  dimension_along_y(sheet, {on_paper.upper.x(), on_paper.lower.y()}, on_paper.upper,
                    on_paper.upper.x() + dimension_step, figure(extent.y()), lettering);
}

/// The table on sheets of its own.
void append_table(std::vector<Sheet>& sheets, const Task& task, const Table& table) {
  const Point size = sheet_size(task.paper, Orientation::portrait);
  const Box room = room_of(size);
  for (std::size_t row = 0; row < table.rows.size();) {
    sheets.push_back({size, {"Bench plan, places", "-", "-"}});
    const std::size_t last = table.fitting_rows(row, room.upper.y() - room.lower.y(), task.lettering);
    table.draw(sheets.back(), {room.lower.x(), room.upper.y()}, task.lettering, row, last);
    row = last;
  }
}

}  // namespace

std::vector<Sheet> bench_sheets(const Task& task) {
  const Design& design = task.design;
  const Region copy = similar_image(design.region, design.linkage.k(), design.linkage.pole());
  const Box edges = edges_of(design, copy);
  const auto marks = marks_of(design, copy);
  const Table table = places_table(marks, edges);
  const BenchLayout layout = bench_layout(task, edges.upper - edges.lower, table);
  const View view{layout.scale, 0.5 * (layout.field.lower + layout.field.upper) -
                                    0.5 * layout.scale * (edges.lower + edges.upper)};
  const Point size = sheet_size(task.paper, layout.orientation);
  std::vector<Sheet> sheets{{size, {"Bench plan, seen from above", "-", scale_text(layout.scale)}}};
  const Plan plan{task, copy, bodies_of(design), edges, marks, view};
  draw_things(sheets.front(), plan);
  write_words(sheets.front(), plan);
  draw_bench_dimensions(sheets.front(), plan);
  const Box room = room_of(size);
  if (layout.table_below)
    table.draw(sheets.front(), {room.lower.x(), room.lower.y() + table.height(task.lettering)},
               task.lettering);
  else
    append_table(sheets, task, table);
  return sheets;
}

}  // namespace kempe::workshop
