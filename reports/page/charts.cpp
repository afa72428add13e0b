#include "reports/page/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/pictures/axis.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

constexpr double chart_width = 420, chart_height = 260;
constexpr double left = 70, right = 24, top = 14, bottom = 46;

/// From one tick to another, with room for a single value.
Axis whole_axis(double lower, double upper, double from, double to) {
  const double span = upper > lower ? upper - lower : std::max(1e-6, std::abs(upper)) * 0.2;
  const double step = round_step(span / 5);
  return {std::floor(lower / step) * step, std::ceil((upper > lower ? upper : lower + span) / step) * step,
          step, from, to};
}

std::string text(double x, double y, std::string_view css, const std::string& words) {
  return SvgElement("text").with("class", css).at("x", "y", {x, y}, 1).saying(words).line();
}

std::string frame(const Axis& x, const Axis& y, const std::string& x_name, const std::string& y_name) {
  std::string lines, figures;
  for (const double value : x.ticks()) {
    lines += fmt::format("M{:.1f},{:.1f}V{:.1f}", x.at(value), y.from, y.to);
    figures += text(x.at(value), y.from + 16, "tick", multiple_text(value, x.step, 6));
  }
  for (const double value : y.ticks()) {
    lines += fmt::format("M{:.1f},{:.1f}H{:.1f}", x.from, y.at(value), x.to);
    figures += text(x.from - 6, y.at(value) + 4, "tick end", multiple_text(value, y.step, 4));
  }
  const std::string beside = fmt::format("translate(12,{:.1f}) rotate(-90)", y.to);
  return svg_shape("grid-line", lines).line() + figures + text(x.to, y.from + 36, "tick end", x_name) +
         SvgElement("text").with("class", "tick end").with("transform", beside).saying(y_name).line();
}

std::string svg_chart(std::string_view title, const std::string& inside) {
  return SvgElement("svg")
      .with("class", "chart")
      .with("role", "img")
      .with("aria-label", title)
      .with("viewBox", view_box(0, 0, chart_width, chart_height))
      .with("font-size", "12")
      .holding("\n" + inside)
      .line();
}

template <class Value>
std::string curve(const std::vector<CopyErrorChart::Row>& rows, const Axis& x, const Axis& y,
                  std::string_view css, Value value) {
  std::string data;
  for (const CopyErrorChart::Row& row : rows)
    data += fmt::format("{}{:.1f},{:.1f}", data.empty() ? "M" : "L", x.at(degrees(row.opening)),
                        y.at(value(row)));
  return svg_shape(fmt::format("curve {}", css), data).line();
}

std::string used_openings(const OpeningInterval& used, const Axis& x) {
  const double from = x.at(degrees(used.lower)), to = x.at(degrees(used.upper));
  return SvgElement("rect")
      .with("class", "used")
      .with("x", fmt::format("{:.1f}", from))
      .with("y", fmt::format("{:.1f}", top))
      .with("width", fmt::format("{:.1f}", to - from))
      .with("height", fmt::format("{:.1f}", chart_height - bottom - top))
      .line();
}

}  // namespace

std::string share_bar(double share) {
  const std::string width = fmt::format("{:.1f}", 100 * std::clamp(share, 0.0, 1.0));
  return SvgElement("svg")
      .with("class", "bar")
      .with("viewBox", view_box(0, 0, 100, 8))
      .with("preserveAspectRatio", "none")
      .with("aria-hidden", "true")
      .holding(SvgElement("rect").with("width", width).with("height", "8").text())
      .text();
}

std::string copy_error_chart(const CopyErrorChart& chart) {
  const auto& rows = chart.rows;
  if (rows.size() < 2) return {};
  double most = 0;
  for (const CopyErrorChart::Row& row : rows) most = std::max({most, row.worst, row.rss});
  const Axis x =
      axis_over(degrees(rows.front().opening), degrees(rows.back().opening), 6, left, chart_width - right);
  const Axis y = whole_axis(0, most, chart_height - bottom, top);
  std::string inside;
  if (!chart.used.empty()) inside += used_openings(chart.used, x);
  inside += frame(x, y, "opening, °", chart.y_name);
  if (chart.limit && *chart.limit <= y.upper)
    inside += svg_shape("curve limit", fmt::format("M{:.1f},{:.1f}H{:.1f}", x.from, y.at(*chart.limit), x.to))
                  .line();
  inside += curve(rows, x, y, "worst", [](const CopyErrorChart::Row& r) { return r.worst; });
  inside += curve(rows, x, y, "rss", [](const CopyErrorChart::Row& r) { return r.rss; });
  return "<figure class=\"chart-figure\">" + svg_chart(chart.title, inside) +
         fmt::format("<figcaption><span class=\"key-worst\">{}</span> <span class=\"key-rss\">{}</span> ",
                     chart.worst_name, chart.rss_name) +
         (chart.limit ? fmt::format("<span class=\"key-limit\">{}</span> ", chart.limit_name) : "") +
         "<span class=\"key-used\">openings that the region uses</span></figcaption></figure>\n";
}

std::string report_of(const ParetoRow& row) { return row.name + "/report.html"; }

std::string pareto_chart(const ParetoFront& front) {
  const auto by_first = [](const ParetoRow& a, const ParetoRow& b) { return a.first < b.first; };
  const auto by_second = [](const ParetoRow& a, const ParetoRow& b) { return a.second < b.second; };
  const auto [left_most, right_most] = std::minmax_element(front.rows.begin(), front.rows.end(), by_first);
  const auto [lowest, highest] = std::minmax_element(front.rows.begin(), front.rows.end(), by_second);
  const Axis x = whole_axis(left_most->first, right_most->first, left, chart_width - right);
  const Axis y = whole_axis(lowest->second, highest->second, chart_height - bottom, top);
  std::vector<ParetoRow> sorted = front.rows;
  std::stable_sort(sorted.begin(), sorted.end(), by_first);
  std::string line, marks;
  for (const ParetoRow& row : sorted) {
    line += fmt::format("{}{:.1f},{:.1f}", line.empty() ? "M" : "L", x.at(row.first), y.at(row.second));
    const SvgElement dot = SvgElement("circle")
                               .with("class", row.is_this_design ? "dot this" : "dot")
                               .at("cx", "cy", {x.at(row.first), y.at(row.second)}, 1)
                               .with("r", row.is_this_design ? 6 : 4)
                               .holding(SvgElement("title").saying(row.name).text());
    marks += SvgElement("a").with("href", report_of(row)).holding(dot.text()).line();
  }
  return svg_chart(
      "The front between the two objectives",
      frame(x, y, front.first_name + ", " + front.first_unit, front.second_name + ", " + front.second_unit) +
          svg_shape("curve front", line).line() + marks);
}

}  // namespace kempe
