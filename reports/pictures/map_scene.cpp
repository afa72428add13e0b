#include "reports/pictures/map_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/picture_extent.hpp"
#include "reports/pictures/round_step.hpp"
#include "reports/pictures/shown_place.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Nominal width of the picture on a screen, px: what text sizes and line widths are measured against.
constexpr double nominal_width = 760;
/// Strips for the frame's figures and the scale bar, nominal px.
constexpr double least_left_strip = 40, bottom_strip = 28, margin = 24;
/// Width over height of the drawing: mechanism and controls fit a laptop's screen together.
constexpr double drawing_shape = 1.6;
/// Widest a character of the frame's figures gets, nominal px: on a phone (report.css).
constexpr double figure_width = 12.1;
/// Of a number's text, nominal px.
double width_of_figure(double value) {
  return figure_width * static_cast<double>(characters_in(number_text(value, 6)));
}

double grid_step(const MapScene& scene) { return round_step(2 * scene.drawing.half.x() / 9); }

/// Values with a line across and a figure in the strip. A line at the very top would have no room for its figure.
std::vector<double> heights(const MapScene& scene) {
  return multiples_within(grid_step(scene), scene.drawing.lower().y(),
                          scene.drawing.upper().y() - 7 * scene.view.unit);
}

/// Nominal px.
double widest_figure_beside(const MapScene& scene) {
  double widest = 0;
  for (const double y : heights(scene)) widest = std::max(widest, width_of_figure(y));
  return widest;
}

/// The linkage where it stands, with the bodies that it carries.
void add_linkage(const MapScene& scene, PictureExtent& extent) {
  for (const Joint joint : all_joints) extent.add(scene.pose[joint], scene.design.style.width / 2);
  for (const Body& body : scene.design.bodies)
    extent.add(scene.pose[joint_of(body.at, scene.design.linkage)], farthest(body));
}

/// All that the map knows.
PictureBox whole_extent(const MapScene& scene) {
  PictureExtent extent;
  const Design& design = scene.design;
  extent.add(design.map.reachable);
  extent.add(design.map.collision_free);
  for (const LostArea& lost : design.map.lost) extent.add(lost.area);
  extent.add(design.region);
  extent.add(scene.copy);
  for (const Obstacle& obstacle : design.obstacles) extent.add(obstacle.shape.outer);
  if (design.table) extent.add(design.table->outer);
  add_linkage(scene, extent);
  return extent.box();
}

/// What the work on the region takes: what the links sweep, original and copy. Without a region, all.
PictureBox job_extent(const MapScene& scene) {
  if (scene.design.region.empty()) return whole_extent(scene);
  PictureExtent extent;
  extent.add(scene.design.region);
  extent.add(scene.copy);
  extent.add(scene.design.footprint);
  if (scene.design.table) extent.add(scene.design.table->outer);
  add_linkage(scene, extent);
  return extent.box();
}

/// The least upright box of this shape (width over height) with the same centre that holds a box.
PictureBox of_shape(PictureBox box, double shape) {
  box.half = box.half.cwiseMax(1e-3);
  box.half.x() = std::max(box.half.x(), box.half.y() * shape);
  box.half.y() = box.half.x() / shape;
  return box;
}

}  // namespace

MapScene::MapScene(const Design& shown, double coarseness)
    : design(shown), tracer(place_to_show(shown)),
      copy(similar_image(shown.region, shown.linkage.k(), shown.linkage.pole())) {
  if (auto found = design.linkage.pose_with_tracer_at(tracer)) pose = *found;
  frame();
  areas = AreaUnit(std::max({area(design.map.reachable), area(design.region), area(copy)}));
  detail = coarseness * view.unit;
}

void MapScene::frame() {
  job = job_extent(*this);
  whole = whole_extent(*this);
  const PictureBox box = of_shape(job, drawing_shape);
  // A wider strip makes the drawing a little smaller, which may change the figures.
  double strip = least_left_strip;
  for (int pass = 0; pass < 3; ++pass) {
    fit_drawing(box, strip);
    strip = std::max(strip, widest_figure_beside(*this) + 8);
  }
  fit_drawing(box, strip);
  const double u = view.unit;
  view.left = drawing.lower().x() - strip * u;
  view.top = -drawing.upper().y();
  view.width = 2 * drawing.half.x() + strip * u;
  view.height = 2 * drawing.half.y() + bottom_strip * u;
}

/// The unit and the drawing of a box beside a strip of so many nominal px.
void MapScene::fit_drawing(const PictureBox& box, double strip) {
  view.unit = 2 * box.half.x() / (nominal_width - strip - 2 * margin);
  drawing = {box.centre, box.half + Point::Constant(margin * view.unit)};
}

std::string map_path(std::string_view css, const std::string& data) {
  return data.empty() ? std::string() : svg_shape(css, data).line();
}

std::string map_group(std::string_view id, const std::string& inside) {
  if (inside.empty()) return {};
  return SvgElement("g").with("class", fmt::format("m-{}", id)).holding("\n" + inside).line();
}

std::string map_words(std::string_view css, const Point& at, const std::string& inside) {
  return svg_words(css, at).holding(inside).line();
}

std::string map_hatches(const PictureView& view) {
  struct Hatch {
    std::string_view id;
    int turn;
    double step, stroke;  ///< nominal px
  };
  static constexpr std::array<Hatch, 7> hatches{{{"change", 45, 7, 2.2},
                                                 {"transmission", -45, 7, 2.2},
                                                 {"contact", 0, 6, 3},
                                                 {"obstructed", 90, 6, 3},
                                                 {"overlap", 20, 9, 2},
                                                 {"uncertain", 60, 4, 2},
                                                 {"thing", -45, 5, 1.6}}};
  const auto pattern = [](const Hatch& hatch, std::string_view prefix, double unit) {
    const std::string step = coordinate(hatch.step * unit, 5);
    return SvgElement("pattern")
        .with("id", fmt::format("{}-{}", prefix, hatch.id))
        .with("class", fmt::format("hatch-{}", hatch.id))
        .with("width", step)
        .with("height", step)
        .with("patternUnits", "userSpaceOnUse")
        .with("patternTransform", fmt::format("rotate({})", hatch.turn))
        .holding(SvgElement("rect").with("width", step).with("height", step).with("class", "ground").text())
        .holding(
            SvgElement("path").with("d", "M0,0V" + step).with("stroke-width", hatch.stroke * unit, 5).text())
        .line();
  };
  std::string patterns;
  for (const Hatch& hatch : hatches)
    patterns += pattern(hatch, "hatch", view.unit) + pattern(hatch, "swatch", 0.8);
  return SvgElement("defs").holding("\n" + patterns).line();
}

std::string map_grid(const MapScene& scene) {
  const double u = scene.view.unit;
  const Point lower = scene.drawing.lower(), upper = scene.drawing.upper();
  std::string lines, figures;
  for (const double x : multiples_within(grid_step(scene), lower.x(), upper.x())) {
    lines += svg_line({{x, lower.y()}, {x, upper.y()}});
    if (x + 0.5 * width_of_figure(x) * u > upper.x()) continue;  // it would be cut
    figures += map_words("tick", {x, lower.y() - 10 * u}, number_text(x, 6));
  }
  for (const double y : heights(scene)) {
    lines += svg_line({{lower.x(), y}, {upper.x(), y}});
    figures += map_words("tick end", {lower.x() - 6 * u, y}, number_text(y, 6));
  }
  return map_group("grid", map_path("grid-line", lines) + figures);
}

namespace {

struct ScaleBar {
  double length;
  Point left, right;
};
ScaleBar scale_bar(const MapScene& scene) {
  const double u = scene.view.unit, length = round_step(2 * scene.drawing.half.x() / 12);
  const Point right(scene.drawing.upper().x() - 8 * u, scene.drawing.lower().y() + 14 * u);
  return {length, right - Point(length, 0), right};
}
std::string scale_words(const ScaleBar& bar) { return number_text(bar.length, 6) + "\u00a0mm"; }

}  // namespace

PictureBox scale_bar_box(const MapScene& scene) {
  const ScaleBar bar = scale_bar(scene);
  const Point words(figure_width * static_cast<double>(characters_in(scale_words(bar))) * scene.view.unit, 0);
  const Point high(0, letter_size / 2 * scene.view.unit);
  const Point lower = bar.left - words - high, upper = bar.right + high;
  return {0.5 * (lower + upper), 0.5 * (upper - lower)};
}

std::string map_scale_bar(const MapScene& scene) {
  const double u = scene.view.unit;
  const ScaleBar bar = scale_bar(scene);
  const Point tick(0, 4 * u);
  const std::string line = svg_line({bar.left + tick, bar.left - tick}) + svg_line({bar.left, bar.right}) +
                           svg_line({bar.right + tick, bar.right - tick});
  return map_group("scale", map_path("scale-bar", line) +
                                map_words("tick end strong", bar.left - Point(8 * u, 0), scale_words(bar)));
}

}  // namespace kempe
