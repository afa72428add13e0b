#include "reports/pictures/error_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/round_step.hpp"

namespace kempe {
namespace {

constexpr double width = 720, height = 420, left = 84, right = 24, top = 44, bottom = 58;

struct Axis {
  double lower, upper, from, to;  // values, pixels
  double at(double value) const { return from + (value - lower) / (upper - lower) * (to - from); }
};

std::string ticks(const Axis& x, const Axis& y) {
  std::string svg;
  const auto ticks_of = [](const Axis& axis) {
    return multiples_within(round_step((axis.upper - axis.lower) / 8), axis.lower, axis.upper);
  };
  for (const double value : ticks_of(x))
    svg += fmt::format(
        "<line x1='{0:.2f}' y1='{1}' x2='{0:.2f}' y2='{2}' class='grid'/><text x='{0:.2f}' y='{3}' "
        "text-anchor='middle'>{4:.6g}</text>\n",
        x.at(value), top, height - bottom, height - bottom + 18, value);
  for (const double value : ticks_of(y))
    svg += fmt::format(
        "<line x1='{0}' y1='{1:.2f}' x2='{2}' y2='{1:.2f}' class='{5}'/><text x='{3}' y='{1:.2f}' dy='4' "
        "text-anchor='end'>{4:.4g}</text>\n",
        left, y.at(value), width - right, left - 8, value, value == 0 ? "zero" : "grid");
  return svg;
}

}  // namespace

std::string error_plot_svg(const ErrorPlot& plot) {
  double largest = 0;
  for (const auto& [x, error] : plot.curve) largest = std::max(largest, std::abs(error));
  const double reach = largest > 0 ? 1.15 * largest : 1;
  const Axis x{plot.curve.front().first, plot.curve.back().first, left, width - right};
  const Axis y{-reach, reach, height - bottom, top};
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
      "font-family='sans-serif' "
      "font-size='12'>\n<style>.grid{{stroke:#ddd}}.zero{{stroke:#555}}text{{fill:#222}}</style>\n"
      "<rect width='100%' height='100%' fill='#fff'/>\n<text x='{2}' y='26' font-size='15' "
      "font-weight='bold'>{3}</text>\n",
      width, height, left, html_escaped(plot.title));
  svg += ticks(x, y);
  std::string points;
  for (const auto& [at, error] : plot.curve) points += fmt::format("{:.2f},{:.2f} ", x.at(at), y.at(error));
  svg += fmt::format("<polyline points='{}' fill='none' stroke='#1f5fa8' stroke-width='2'/>\n", points);
  for (const double at : plot.marked)
    svg +=
        fmt::format("<circle cx='{:.2f}' cy='{:.2f}' r='4' fill='#fff' stroke='#c0392b' stroke-width='2'/>\n",
                    x.at(at), y.at(0));
  svg += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{}</text>\n", (left + width - right) / 2,
                     height - 16, html_escaped(plot.x_label));
  svg += fmt::format(
      "<text transform='translate(18 {:.1f}) rotate(-90)' text-anchor='middle'>{}</text>\n</svg>\n",
      (top + height - bottom) / 2, html_escaped(plot.y_label));
  return svg;
}

}  // namespace kempe
