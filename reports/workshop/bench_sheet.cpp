// Where things lie on the table, from its left and its front edge.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "geometry/edge_tree.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/pictures/picture_labels.hpp"
#include "reports/workshop/dimension.hpp"
#include "reports/workshop/sheets.hpp"
#include "reports/workshop/table.hpp"
#include "specs/hardware.hpp"
#include "workspace/obstructions.hpp"

namespace kempe::workshop {
namespace {

/// A place to mark on the table.
struct Mark {
  std::string name;
  Point at;
};

void include(Box& box, const Region& region) {
  if (region.empty()) return;
  const Box other = bounding_box(region);
  box.lower = box.lower.cwiseMin(other.lower);
  box.upper = box.upper.cwiseMax(other.upper);
}

/// Bodies where the drawn mechanism carries them.
std::vector<Region> bodies_of(const Design& design) {
  std::vector<Region> outlines;
  const Pose pose = assembly_pose(design);
  for (const Body& body : design.bodies) {
    const std::variant<Disc, Polygon> shape = placed(body, design.linkage, pose);
    if (const auto* disc = std::get_if<Disc>(&shape))
      outlines.push_back(Region::circle(disc->centre, disc->radius));
    else
      outlines.push_back(Region{{std::get<Polygon>(shape)}});
  }
  return outlines;
}

/// The table's edges; without a table those of what a bench must hold: all that moves, the original, the copy, what stands in
/// the way.
Box edges_of(const Design& design, const Region& copy) {
  if (design.table) return bounding_box(Region{{*design.table}});
  const Point pole = design.linkage.pole();
  Box box{pole, pole};
  for (const Region& region : {design.footprint, design.region, copy}) include(box, region);
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    include(box, flattened(ArcRegion{link_outline(link, pose, design.style)}, 0.1, Flatten::grows));
  for (const Obstacle& obstacle : design.obstacles) include(box, Region{{obstacle.shape}});
  for (const Region& body : bodies_of(design)) include(box, body);
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
  constexpr std::size_t most = 6;  // rows that the sheet has room for
  for (std::size_t i = 0; i < std::min(most, design.obstacles.size()); ++i) {
    const Obstacle& obstacle = design.obstacles[i];
    corners(obstacle.name.empty() ? "obstacle" : obstacle.name, Region{{obstacle.shape}});
  }
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

Region on_paper_of(const View& view, Region region) {
  const auto put = [&](Ring& ring) {
    for (Point& point : ring) point = view.at(point);
  };
  for (Polygon& polygon : region.polygons) {
    put(polygon.outer);
    for (Ring& hole : polygon.holes) put(hole);
  }
  return region;
}

/// Keeps labels clear of a region's edges, as far as few edges can say it.
void avoid_edges(LabelPlacer& labels, const View& view, const Region& region) {
  constexpr double detail = 2;  // mm on paper
  for (const Polygon& polygon : region.polygons) {
    const Ring ring = thinned(polygon.outer, detail / view.scale);
    for (std::size_t i = 0; i < ring.size(); ++i)
      labels.avoid(view.at(ring[i]), view.at(ring[(i + 1) % ring.size()]), 0.3);
  }
}

constexpr double cross_half = 1.5;  ///< mm, of a mark

void draw_cross(Sheet& sheet, const Point& at) {
  sheet.line(at - Point(cross_half, cross_half), at + Point(cross_half, cross_half), Pen::thin);
  sheet.line(at - Point(cross_half, -cross_half), at + Point(cross_half, -cross_half), Pen::thin);
}

/// A word where it is clear of all that was placed before.
class Words {
 public:
  Words(Sheet& sheet, const Lettering& lettering, const Box& field)
      : sheet_(sheet), lettering_(lettering),
        placer_({0.5 * (field.lower + field.upper), 0.5 * (field.upper - field.lower)}, 0.3) {}

  LabelPlacer& placer() { return placer_; }
  void write(const std::string& text, const Point& anchor, double radius, double height) {
    const Point half = Point(0.5 * lettering_(text, height), 0.5 * height);
    const Point room = half + Point(0.2, 0.2);
    std::vector<PictureBox> near;
    for (const double away : {0.5, 1.0, 1.7, 2.5, 3.5, 5.0})
      for (const int turn : {1, 7, 3, 5, 0, 2, 4, 6}) {  // of a circle's eighths; corners first
        const Point direction = as_point(std::polar(1.0, turn * pi / 4));
        near.push_back(
            {anchor + (radius + away) * direction + room.cwiseProduct(direction.cwiseSign()), room});
      }
    constexpr double apart = 0.25;  // mm, from any line
    const auto clear = placer_.place_if_apart(near, apart);
    const Point place = clear ? *clear : placer_.place_around(anchor, radius, room, Point(1, 1));
    sheet_.text(text, place - Point(0, half.y()), height, Align::middle);
  }

  /// In a region, given on paper, where it is clear there, nearest to its middle; else beside it.
  void write_in(const std::string& text, const Region& region, double height) {
    const Point half(0.5 * lettering_(text, height), 0.5 * height);
    const Box box = bounding_box(region);
    const Point middle = 0.5 * (box.lower + box.upper);
    const EdgeTree edges(region, Point::Zero());
    constexpr int steps = 24;  // each way
    std::vector<PictureBox> places;
    for (int i = 1; i < steps; ++i)
      for (int j = 1; j < steps; ++j) {
        const Point share(static_cast<double>(i) / steps, static_cast<double>(j) / steps);
        const Point at = box.lower + share.cwiseProduct(box.upper - box.lower);
        if (edges.winds_around(at)) places.push_back({at, half + Point(0.4, 0.8)});
      }
    std::stable_sort(places.begin(), places.end(), [&](const PictureBox& a, const PictureBox& b) {
      return (a.centre - middle).norm() < (b.centre - middle).norm();
    });
    constexpr double apart = 0.2;  // mm, from any line
    const auto clear = placer_.place_if_apart(places, apart);
    const Point place =
        clear ? *clear
              : placer_.place_beside({middle, 0.5 * (box.upper - box.lower)}, half + Point(0.4, 0.8));
    sheet_.text(text, place - Point(0, half.y()), height, Align::middle);
  }

 private:
  Sheet& sheet_;
  const Lettering& lettering_;
  LabelPlacer placer_;
};

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

}  // namespace

Sheet bench_sheet(const Task& task) {
  const Design& design = task.design;
  const Region copy = similar_image(design.region, design.linkage.k(), design.linkage.pole());
  const Box edges = edges_of(design, copy);
  const auto marks = marks_of(design, copy);
  const Table table = places_table(marks, edges);
  const Point size = sheet_size(task.paper, Orientation::portrait);
  Box field = room_of(size);
  field.lower.y() += table.height(task.lettering) + 4;
  const Point extent = edges.upper - edges.lower;
  const Point beside(22, 20);  // for dimensions
  const double scale = fitting_scale(extent, field.upper - field.lower - 2 * beside);
  Sheet sheet{size, {"Bench plan, seen from above", "-", scale_text(scale)}};
  const View view{scale, 0.5 * (field.lower + field.upper) - 0.5 * scale * (edges.lower + edges.upper)};
  const Box on_paper{view.at(edges.lower), view.at(edges.upper)};
  draw_region(sheet, view, design.footprint, Pen::hatch, Fill::shade);
  draw_region(sheet, view, design.region, Pen::outline, Fill::paper);
  draw_region(sheet, view, copy, Pen::outline, Fill::paper);
  for (const Obstacle& obstacle : design.obstacles)
    draw_region(sheet, view, Region{{obstacle.shape}}, Pen::phantom);
  for (const Region& body : bodies_of(design)) draw_region(sheet, view, body, Pen::phantom);
  draw_mechanism(sheet, design, view);
  sheet.rectangle(on_paper, Pen::outline);
  Words words(sheet, task.lettering, on_paper);
  const Region table_edges = Region::rectangle(edges.lower, extent);
  for (const Region* region : {&design.region, &copy, &design.footprint, &table_edges})
    avoid_edges(words.placer(), view, *region);
  for (const Obstacle& obstacle : design.obstacles)
    avoid_edges(words.placer(), view, Region{{obstacle.shape}});
  for (const Region& body : bodies_of(design)) avoid_edges(words.placer(), view, body);
  const Pose pose = assembly_pose(design);
  for (const Link link : all_links)
    avoid_edges(words.placer(), view,
                flattened(ArcRegion{link_outline(link, pose, design.style)}, 0.1, Flatten::grows));
  const Point pole = view.at(design.linkage.pole());
  words.placer().avoid({on_paper.lower.x(), pole.y()}, pole, 0.3);
  words.placer().avoid({pole.x(), on_paper.lower.y()}, pole, 0.3);
  for (const Mark& mark : marks)
    words.placer().avoid(PictureBox{view.at(mark.at), Point(cross_half, cross_half)});
  // Names first: numbers find room beside their crosses, names only where the regions have it.
  const auto name_region = [&](const std::string& text, const Region& region) {
    if (!region.empty()) words.write_in(text, on_paper_of(view, region), text_height);
  };
  name_region("original", design.region);
  name_region("copy", copy);
  int number = 0;
  for (const Mark& mark : marks) {
    draw_cross(sheet, view.at(mark.at));
    words.write(fmt::format("{}", ++number), view.at(mark.at), cross_half, heading_height);
  }
  const Point from_edges = design.linkage.pole() - edges.lower;
  dimension_along_x(sheet, on_paper.lower, pole, on_paper.lower.y() - dimension_step - 2,
                    figure(from_edges.x()), task.lettering, true);
  dimension_along_y(sheet, on_paper.lower, pole, on_paper.lower.x() - dimension_step - 2,
                    figure(from_edges.y()), task.lettering, true);
  // The edges' names stand at the ends that are farther from the pole's dimensions.
  const Point middle = 0.5 * (on_paper.lower + on_paper.upper);
  const bool pole_right = pole.x() > middle.x(), pole_back = pole.y() > middle.y();
  sheet.text("front edge", {pole_right ? on_paper.lower.x() : on_paper.upper.x(), on_paper.lower.y() - 4},
             text_height, pole_right ? Align::left : Align::right);
  sheet.text("left edge", {on_paper.lower.x() - 1.5, pole_back ? on_paper.lower.y() : on_paper.upper.y()},
             text_height, pole_back ? Align::left : Align::right, 0.5 * pi);
  dimension_along_x(sheet, {on_paper.lower.x(), on_paper.upper.y()}, on_paper.upper,
                    on_paper.upper.y() + dimension_step, figure(extent.x()), task.lettering);
  dimension_along_y(sheet, {on_paper.upper.x(), on_paper.lower.y()}, on_paper.upper,
                    on_paper.upper.x() + dimension_step, figure(extent.y()), task.lettering);
  table.draw(sheet, {field.lower.x(), field.lower.y() - 4}, task.lettering);
  return sheet;
}

}  // namespace kempe::workshop
