#include "reports/pictures/error_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/pictures/axis.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

constexpr double width = 720, height = 420, left_margin = 84, right_margin = 24, top_margin = 44,
                 bottom_margin = 58;

SvgElement line(const Point& from, const Point& to, std::string_view css) {
  return SvgElement("line").at("x1", "y1", from, 2).at("x2", "y2", to, 2).with("class", css);
}

SvgElement words(const Point& at, std::string_view anchor, std::string_view text) {
  return SvgElement("text").at("x", "y", at, 2).with("text-anchor", anchor).saying(text);
}

std::string ticks(const Axis& x, const Axis& y) {
  constexpr double under = height - bottom_margin, beside = width - right_margin;
  std::string svg;
  for (const double value : x.ticks())
    svg += line({x.at(value), top_margin}, {x.at(value), under}, "grid").text() +
           words({x.at(value), under + 18}, "middle", fmt::format("{:.6g}", value)).line();
  for (const double value : y.ticks())
    svg += line({left_margin, y.at(value)}, {beside, y.at(value)}, value == 0 ? "zero" : "grid").text() +
           words({left_margin - 8, y.at(value) + 4}, "end", fmt::format("{:.4g}", value)).line();
  return svg;
}

/// Named along the bottom and, turned, along the left.
std::string labels(const ErrorPlot& plot) {
  const std::string beside =
      fmt::format("translate(18 {:.1f}) rotate(-90)", (top_margin + height - bottom_margin) / 2);
  return words({(left_margin + width - right_margin) / 2, height - 16}, "middle", plot.x_label).line() +
         SvgElement("text")
             .with("transform", beside)
             .with("text-anchor", "middle")
             .saying(plot.y_label)
             .line();
}

}  // namespace

std::string error_plot_svg(const ErrorPlot& plot) {
  double largest = 0;
  for (const auto& [x, error] : plot.curve) largest = std::max(largest, std::abs(error));
  const double reach = largest > 0 ? 1.15 * largest : 1;
  const Axis x =
      axis_over(plot.curve.front().first, plot.curve.back().first, 8, left_margin, width - right_margin);
  const Axis y = axis_over(-reach, reach, 8, height - bottom_margin, top_margin);
  std::string svg = SvgElement("style").holding(".grid{stroke:#ddd}.zero{stroke:#555}text{fill:#222}").line();
  svg += SvgElement("rect").with("width", "100%").with("height", "100%").with("fill", "#fff").line();
  svg += SvgElement("text")
             .at("x", "y", {left_margin, 26})
             .with("font-size", 15)
             .with("font-weight", "bold")
             .saying(plot.title)
             .line();
  svg += ticks(x, y);
  std::string points;
  for (const auto& [at, error] : plot.curve) points += fmt::format("{:.2f},{:.2f} ", x.at(at), y.at(error));
  svg += SvgElement("polyline")
             .with("points", points)
             .with("fill", "none")
             .with("stroke", "#1f5fa8")
             .with("stroke-width", 2)
             .line();
  for (const double at : plot.marked)
    svg += SvgElement("circle")
               .at("cx", "cy", {x.at(at), y.at(0)}, 2)
               .with("r", 4)
               .with("fill", "#fff")
               .with("stroke", "#c0392b")
               .with("stroke-width", 2)
               .line();
  return svg_root()
      .with("width", width)
      .with("height", height)
      .with("viewBox", view_box(0, 0, width, height))
      .with("font-family", "sans-serif")
      .with("font-size", 12)
      .holding("\n" + svg + labels(plot))
      .line();
}

}  // namespace kempe
