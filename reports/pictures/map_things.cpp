#include "reports/pictures/map_things.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "kinematics/overloaded.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Half a line of the small words (report.css), mm.
Point half_of_small_words(const std::string& words, double unit) {
  return Point(0.5 * 0.62 * 0.8 * letter_size * static_cast<double>(characters_in(words)),
               0.5 * letter_size) *
         unit;
}

/// Where a sheet's name may stand: inside, under the middle of a side, the uppermost side first.
std::vector<PictureBox> places_in(const FittingSheet& sheet, const Point& half, double inset) {
  const Ring ring = corners(sheet);
  std::vector<Point> middles;
  for (std::size_t i = 0; i < ring.size(); ++i)
    middles.push_back(0.5 * (ring[i] + ring[(i + 1) % ring.size()]));
  std::stable_sort(middles.begin(), middles.end(),
                   [](const Point& a, const Point& b) { return a.y() > b.y(); });
  std::vector<PictureBox> places;
  for (const double deep : {1.0, 2.5, 4.0, 5.5})
    for (const Point& middle : middles)
      places.push_back({middle + deep * inset * (sheet.centre - middle).normalized(), half});
  return places;
}

/// Circles about the pole, each with its level where there is room for it on the line, the way to the region's other side first.
std::string contours(const MapScene& scene, const std::vector<ContourCircle>& circles, LabelPlacer& placer,
                     const std::function<std::string(const ContourCircle&)>& words) {
  const Point pole = scene.design.linkage.pole();
  const double bearing = std::arg(as_complex(scene.tracer - pole)) + 0.75 * pi;
  constexpr int bearings = 24;
  std::string lines, figures;
  for (const ContourCircle& circle : circles) {
    lines += svg_disc("contour", pole, circle.radius).line();
    const std::string level = words(circle);
    std::vector<PictureBox> places;
    for (int i = 0; i < bearings; ++i) {
      const int step = i % 2 == 0 ? (i + 1) / 2 : -(i + 1) / 2;
      const double turn = 2 * pi * step / bearings;
      places.push_back({pole + as_point(std::polar(circle.radius, bearing + turn)),
                        half_of_small_words(level, scene.view.unit)});
    }
    if (const auto at = placer.place_if_clear(places)) figures += map_words("small", *at, level);
  }
  return lines + figures;
}

/// Bodies where their points stand; a script moves them with the joint that `data-joint` numbers, from `data-x`, `data-y` (of the picture),
/// and turns one that is fixed to a link with the direction to the joint `data-toward`, from `data-bearing` (degrees, of the picture).
std::string bodies(const MapScene& scene) {
  std::string all;
  for (const Body& body : scene.design.bodies) {
    const Joint joint = joint_of(body.at, scene.design.linkage);
    const Point& at = scene.pose[joint];
    SvgElement element = std::visit(
        Overloaded{
            [&](const Disc& disc) { return svg_disc("thing", disc.centre, disc.radius); },
            [&](const Polygon& polygon) { return svg_shape("thing", svg_path(polygon, scene.detail)); }},
        placed(body, scene.design.linkage, scene.pose));
    element.with("data-joint", static_cast<double>(joint)).at("data-x", "data-y", {at.x(), -at.y()});
    if (body.turns_with) {
      const Joint toward = nearest_to_end(*body.turns_with, scene.design.linkage.shape());
      element.with("data-toward", static_cast<double>(toward))
          .with("data-bearing", -degrees(bearing_of(body, scene.design.linkage, scene.pose)));
    }
    all += element.line();
  }
  return all;
}

}  // namespace

std::string map_things(const MapScene& scene, std::vector<MapLayer>& layers, LabelPlacer& placer) {
  std::string obstacles, sheets, tightest;
  for (const Obstacle& obstacle : scene.design.obstacles)
    obstacles += map_path("thing", svg_path(obstacle.shape, scene.detail));
  for (const FittingSheet& sheet : scene.design.map.largest_sheets) {
    const Point size(sheet.width, sheet.height);
    const std::string words = fmt::format("{}, {} × {}", sheet.name, figure_text(size.maxCoeff(), 0),
                                          figure_text(size.minCoeff(), 0));
    sheets += map_path("sheet", svg_path(Polygon{corners(sheet), {}}, 0));
    const double unit = scene.view.unit;
    if (const auto at = placer.place_if_clear(places_in(sheet, half_of_small_words(words, unit), 10 * unit)))
      sheets += map_words("small", *at, html_escaped(words));
  }
  if (std::isfinite(scene.design.map.clearance_min) && !scene.design.map.clearance_min_parts.empty()) {
    const Point at = scene.design.map.clearance_min_at, a(5 * scene.view.unit, 5 * scene.view.unit),
                b(a.x(), -a.y());
    tightest = map_path("tight", svg_line({at - a, at + a}) + svg_line({at - b, at + b}));
  }
  const auto add = [&](const char* id, const char* label, const std::string& inside, std::string figure,
                       bool shown = true) {
    if (!inside.empty()) layers.push_back({id, label, std::move(figure), "things", shown});
    return map_group(id, inside);
  };
  std::string svg = add("obstacles", "Obstacles", obstacles, count_text(scene.design.obstacles.size()));
  svg += add("bodies", "Bodies", bodies(scene), count_text(scene.design.bodies.size()));
  const auto& table = scene.design.table;
  svg += add("table", "Table", table ? map_path("edge", svg_path(*table, scene.detail)) : std::string(),
             table ? area_text(signed_area(table->outer)) : std::string());
  svg += add("sheets", "Largest sheets", sheets, count_text(scene.design.map.largest_sheets.size()), false);
  const auto outline = [&](const Region& region) {
    return region.empty() ? std::string() : map_path("outline", svg_path(region, scene.detail));
  };
  svg += add("region", "Region to trace", outline(scene.design.region),
             scene.areas.text(area(scene.design.region)));
  svg += add("copy", "Its copy", outline(scene.copy), scene.areas.text(area(scene.copy)));
  svg += add("footprint", "Footprint", outline(scene.design.footprint),
             scene.areas.text(scene.design.quality.footprint), false);
  svg += add("angle-lines", "Transmission angle",
             contours(scene, transmission_circles(scene.design.linkage), placer,
                      [](const ContourCircle& circle) { return angle_text(circle.level, 0); }),
             "10° steps", false);
  const auto lengths = [&](const std::vector<ContourCircle>& circles, int decimals) {
    const double step = step_of_levels(circles);
    return contours(scene, circles, placer,
                    [&](const ContourCircle& circle) { return level_text(circle, step, decimals); });
  };
  svg +=
      add("error-lines", "Copy error, worst", lengths(copy_error_circles(scene.design), 3), "lines", false);
  svg += add("load-lines", "Load error of the links", lengths(load_error_circles(scene.design), 5), "lines",
             false);
  svg += add("tightest", "Tightest place", tightest, length_text(scene.design.map.clearance_min, 2), false);
  return svg;
}

}  // namespace kempe
