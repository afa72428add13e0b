#include "reports/page/error_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/region.hpp"
#include "geometry/region_reach.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/picture_extent.hpp"
#include "reports/pictures/round_step.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe {
namespace {

constexpr int shades = 40;
/// Of a contour's words, in units of the picture (report.css).
constexpr double level_letter_width = 10;

/// An error where the tracer is at evenly spaced distances from the pole, the farthest first.
struct Course {
  std::vector<double> radii, errors;  ///< mm
  double least() const { return *std::min_element(errors.begin(), errors.end()); }
  double most() const { return *std::max_element(errors.begin(), errors.end()); }
};

/// Over an opening.
using ErrorPart = std::function<double(double)>;

Course course_of(const Design& design, const ErrorPart& part) {
  const DistanceRange range = distance_range(design.region, design.linkage.pole());
  Course course;
  for (int i = 0; i <= shades; ++i) {
    const double radius = range.farthest - (range.farthest - range.nearest) * i / shades;
    const auto opening = design.linkage.opening_at(radius);
    if (!opening) continue;
    course.radii.push_back(radius);
    course.errors.push_back(part(*opening));
  }
  return course;
}

/// Discs about the pole, the largest first, each as dark as the ring that it leaves to be seen is wrong.
std::string rings(const Course& course, const Point& pole) {
  const double least = course.least(), most = course.most();
  std::string all;
  for (std::size_t i = 0; i + 1 < course.radii.size(); ++i) {
    const double error = 0.5 * (course.errors[i] + course.errors[i + 1]);
    const double share = most > least ? (error - least) / (most - least) : 0.5;
    all += SvgElement("circle")
               .at("cx", "cy", {pole.x(), -pole.y()})
               .with("r", course.radii[i] * (i == 0 ? 1.001 : 1))
               .with("fill", fmt::format("hsl(18 {:.0f}% {:.0f}%)", 30 + 50 * share, 95 - 45 * share))
               .line();
  }
  return all;
}

/// Where the error is a round number: about six levels.
std::vector<ContourCircle> circles_of(const Course& course) {
  std::vector<ContourCircle> circles;
  const double least = course.least(), most = course.most();
  if (!(most > least * (1 + 1e-9))) return circles;
  for (const double level : multiples_within(round_step((most - least) / 6), least, most))
    for (std::size_t i = 1; i < course.radii.size(); ++i) {
      const double before = course.errors[i - 1], after = course.errors[i];
      if ((before < level) != (after < level))
        circles.push_back(
            {level, std::lerp(course.radii[i - 1], course.radii[i], (level - before) / (after - before))});
    }
  return circles;
}

std::string circle_line(const ContourCircle& circle, const Point& pole, double unit) {
  return SvgElement("circle")
      .at("cx", "cy", {pole.x(), -pole.y()})
      .with("r", circle.radius)
      .with("fill", "none")
      .with("stroke", "#5a1f0c")
      .with("stroke-width", unit)
      .line();
}

/// A contour's level where it crosses the line from the pole to the region's middle, if that lies well inside the region, the words in the
/// picture's box and away from those `before`.
std::string circle_words(const ContourCircle& circle, const std::string& level, const Design& design,
                         const PictureBox& box, double unit, std::vector<Point>& before) {
  const Point toward = (box.centre - design.linkage.pole()).normalized();
  const Point at = design.linkage.pole() + circle.radius * toward, below = at - Point(0, 5 * unit);
  const double apart = 22 * unit,
               half = 0.5 * level_letter_width * unit * static_cast<double>(characters_in(level));
  if (std::abs(at.x() - box.centre.x()) + half > box.half.x()) return {};
  for (const double side : {-14.0, 14.0})
    if (!contains(design.region, at + Point(0, side * unit))) return {};
  for (const Point& other : before)
    if (std::abs(other.y() - at.y()) < apart && std::abs(other.x() - at.x()) < 2 * half) return {};
  before.push_back(at);
  return SvgElement("text")
      .with("class", "load-words")
      .at("x", "y", {below.x(), -below.y()})
      .saying(level)
      .line();
}

std::string range_text(const Course& course) {
  const std::string least = error_length(course.least()), most = error_length(course.most());
  return least == most ? most + " everywhere" : least + " to " + most;
}

struct Panel {
  std::string id, title;
  ErrorPart part;
};

/// Empty where the error is nowhere more than rounding, or not everywhere known.
std::string panel_figure(const Design& design, const Panel& panel) {
  const Course course = course_of(design, panel.part);
  const bool is_known = std::all_of(course.errors.begin(), course.errors.end(),
                                    [](double each) { return std::isfinite(each); });
  if (course.errors.size() < 2 || !is_known || !(course.most() > no_drop)) return {};
  const Point pole = design.linkage.pole();
  PictureExtent extent;
  extent.add(design.region);
  const PictureBox box = extent.box();
  const double margin = 0.04 * box.half.maxCoeff(), unit = box.half.maxCoeff() / 220;
  std::string inside = rings(course, pole), words;
  std::vector<Point> placed;
  const std::vector<ContourCircle> circles = circles_of(course);
  const double step = step_of_levels(circles);
  for (const ContourCircle& circle : circles) {
    inside += circle_line(circle, pole, unit);
    words += circle_words(circle, level_text(circle, step, 5), design, box, unit, placed);
  }
  const std::string outline = svg_path(design.region, unit);
  const std::string clip =
      SvgElement("clipPath")
          .with("id", panel.id + "-region")
          .holding(SvgElement("path").with("d", outline).with("clip-rule", "evenodd").text())
          .line();
  const std::string svg =
      SvgElement("svg")
          .with("class", "chart")
          .with("role", "img")
          .with("aria-label", panel.title + " over the region")
          .with("viewBox",
                view_box(box.centre.x() - box.half.x() - margin, -box.centre.y() - box.half.y() - margin,
                         2 * (box.half.x() + margin), 2 * (box.half.y() + margin)))
          .with("font-size", 14 * unit, 4)
          .holding("\n" + clip +
                   SvgElement("g")
                       .with("clip-path", "url(#" + panel.id + "-region)")
                       .holding("\n" + inside + words)
                       .line() +
                   SvgElement("path")
                       .with("d", outline)
                       .with("fill", "none")
                       .with("stroke", "#5a1f0c")
                       .with("stroke-width", 1.5 * unit)
                       .line())
          .line();
  return "<figure class=\"chart-figure\">" + svg + "<figcaption><b>" + panel.title +
         "</b>: " + range_text(course) + "</figcaption></figure>\n";
}

}  // namespace

std::string error_pictures(const Design& design) {
  if (!design.quality.loads || !design.load || !design.material) return {};
  const ErrorCourse course(design);
  const auto tolerances = [&](double opening) { return course.tolerances(opening); };
  const auto give = [&](double opening) { return course.give(opening); };
  const bool weighs = gravity_along(design.load->tilt) > 0;
  std::vector<Panel> panels{
      {"give", weighs ? "Load, own weight, pins and layers" : "Load, pins and layers", give}};
  if (design.tolerance) {
    panels.insert(panels.begin(), {"made", "Lengths and play", tolerances});
    panels.push_back({"in-plane", "All in the plane",
                      [&](double opening) { return tolerances(opening) + give(opening); }});
  }
  panels.push_back({"sag", "Sag", [&](double opening) { return course.sag(opening); }});
  std::string figures;
  for (const Panel& panel : panels) figures += panel_figure(design, panel);
  const std::string own_weight = weighs ? "The links' own weight along the table pulls in the worst "
                                          "direction, whether the region uses that "
                                          "or not. "
                                        : "";
  return "<div class=\"panels\">" + figures +
         "</div>\n<p class=\"note\">The error with the tracer at each place of the region, in the worst "
         "direction; darker is more, each picture on its own scale. The load error is that of links, "
         "pins and layers. " +
         own_weight + "All depend on the distance from the pole alone.</p>\n";
}

}  // namespace kempe
