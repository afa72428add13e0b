#include "reports/page/error_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/region.hpp"
#include "geometry/region_reach.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/picture_extent.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "synthesis/loads/load_error.hpp"

namespace kempe {
namespace {

constexpr int shades = 40;

struct Errors {
  LoadErrorProfile profile;
  const CopyingLinkage& linkage;

  /// mm, where the tracer is `radius` from the pole.
  double at(double radius) const {
    const auto opening = linkage.opening_at(radius);
    return opening ? profile.at({linkage.VA(), linkage.VB()}, *opening).worst : 0;
  }
};

/// Discs about the pole, the largest first, each as dark as the ring that it leaves to be seen is soft.
std::string rings(const Errors& errors, const DistanceRange& range) {
  std::vector<double> radii, values;
  for (int i = 0; i < shades; ++i) {
    radii.push_back(range.farthest - (range.farthest - range.nearest) * i / shades);
    values.push_back(errors.at(radii.back() - 0.5 * (range.farthest - range.nearest) / shades));
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  std::string all;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double share = *most > *least ? (values[i] - *least) / (*most - *least) : 0.5;
    const Point at(errors.linkage.pole().x(), -errors.linkage.pole().y());
    all += SvgElement("circle")
               .at("cx", "cy", at)
               .with("r", radii[i] * (i == 0 ? 1.001 : 1))
               .with("fill", fmt::format("hsl(18 {:.0f}% {:.0f}%)", 30 + 50 * share, 95 - 45 * share))
               .line();
  }
  return all;
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

/// A contour's words where it crosses the line from the pole to the region's middle, if that lies well inside the region and away from the
/// words `before`.
std::string circle_words(const ContourCircle& circle, const Design& design, const Point& middle, double unit,
                         std::vector<Point>& before) {
  const Point toward = (middle - design.linkage.pole()).normalized();
  const Point at = design.linkage.pole() + circle.radius * toward, below = at - Point(0, 5 * unit);
  const double apart = 22 * unit;
  for (const double side : {-14.0, 14.0})
    if (!contains(design.region, at + Point(0, side * unit))) return {};
  for (const Point& other : before)
    if ((other - at).norm() < apart) return {};
  before.push_back(at);
  return SvgElement("text")
      .with("class", "load-words")
      .at("x", "y", {below.x(), -below.y()})
      .saying(length_text(circle.level, 5))
      .line();
}

}  // namespace

std::string error_pictures(const Design& design) {
  if (!design.quality.loads || !design.load || !design.material) return {};
  const CopyingLinkage& linkage = design.linkage;
  const Errors errors{
      {linkage.k(), linkage.grounding(), design.style, *design.material, design.load->pen_force}, linkage};
  PictureExtent extent;
  extent.add(design.region);
  const PictureBox box = extent.box();
  const double margin = 0.04 * box.half.maxCoeff(), unit = box.half.maxCoeff() / 220;
  std::string inside = rings(errors, distance_range(design.region, linkage.pole()));
  std::string words;
  std::vector<Point> placed;
  for (const ContourCircle& circle : load_error_circles(design)) {
    inside += circle_line(circle, linkage.pole(), unit);
    words += circle_words(circle, design, box.centre, unit, placed);
  }
  const std::string outline = svg_path(design.region, unit);
  const std::string clip =
      SvgElement("clipPath")
          .with("id", "load-region")
          .holding(SvgElement("path").with("d", outline).with("clip-rule", "evenodd").text())
          .line();
  const std::string svg =
      SvgElement("svg")
          .with("class", "chart")
          .with("role", "img")
          .with("aria-label", "Load error over the region")
          .with("viewBox",
                view_box(box.centre.x() - box.half.x() - margin, -box.centre.y() - box.half.y() - margin,
                         2 * (box.half.x() + margin), 2 * (box.half.y() + margin)))
          .with("font-size", 14 * unit, 4)
          .holding(
              "\n" + clip +
              SvgElement("g").with("clip-path", "url(#load-region)").holding("\n" + inside + words).line() +
              SvgElement("path")
                  .with("d", outline)
                  .with("fill", "none")
                  .with("stroke", "#5a1f0c")
                  .with("stroke-width", 1.5 * unit)
                  .line())
          .line();
  return "<figure class=\"chart-figure\">" + svg +
         "<figcaption>Load error with the tracer at each place of the region, worst direction; darker is "
         "softer. It depends on the "
         "distance from the pole alone.</figcaption></figure>\n";
}

}  // namespace kempe
