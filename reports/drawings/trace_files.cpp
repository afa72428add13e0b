#include "reports/drawings/trace_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/drawings/svg_writer.hpp"
#include "reports/drawings/trace_forces.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

ArcRing as_ring(const Stroke& points) {
  ArcRing ring;
  ring.reserve(points.size());
  for (const Point& point : points) ring.push_back({point, 0});
  return ring;
}

/// The lines in a group whose attributes so far are given.
std::string group(SvgElement element, const std::vector<TracedLine>& lines) {
  std::string paths;
  for (const TracedLine& line : lines)
    paths += SvgElement("path").with("d", outline_path(as_ring(line.points), line.closed)).line();
  return element.with("fill", "none")
      .with("stroke-linejoin", "round")
      .with("stroke-linecap", "round")
      .holding("\n" + paths)
      .line();
}

Box box_of(const Trace& trace) {
  Box box{Point::Constant(HUGE_VAL), Point::Constant(-HUGE_VAL)};
  for (const auto* lines : {&trace.drawn, &trace.missing})
    for (const TracedLine& line : *lines)
      for (const Point& point : line.points) {
        box.lower = box.lower.cwiseMin(point);
        box.upper = box.upper.cwiseMax(point);
      }
  return box.lower.x() <= box.upper.x() ? box : Box{Point::Zero(), Point::Zero()};
}

/// arg q - arg p in degrees, from the joints.
double opening_degrees(const Pose& pose) {
  const Point p = pose.A - pose.V, q = pose.B - pose.V;
  return degrees(std::atan2(cross(p, q), p.dot(q)));
}

}  // namespace

std::string copy_svg(const Trace& trace, std::string_view title) {
  const Box box = box_of(trace);
  const double margin = 5;
  const bool coloured = std::any_of(trace.drawn.begin(), trace.drawn.end(),
                                    [](const TracedLine& line) { return !line.hand.empty(); });
  const Point size =
      box.upper - box.lower + Point(2 * margin, 2 * margin + (coloured ? legend_height - margin : 0));
  const auto named = [](std::string_view id, std::string_view colour) {
    return SvgElement("g").with("id", id).with("stroke", colour).with("stroke-width", "0.25");
  };
  std::string inside = SvgElement("title").saying(title).line() +
                       (coloured ? coloured_by_hand(trace, box) : group(named("copy", "#000"), trace.drawn));
  if (!trace.missing.empty())
    inside += group(named("left-out", "#e00000").with("stroke-dasharray", "1 0.6"), trace.missing);
  return svg_file(svg_root()
                      .with("version", "1.1")
                      .with("width", fmt::format("{}mm", size.x()))
                      .with("height", fmt::format("{}mm", size.y()))
                      .with("viewBox", fmt::format("{} {} {} {}", box.lower.x() - margin,
                                                   -box.upper.y() - margin, size.x(), size.y()))
                      .holding("\n" + inside));
}

std::string poses_csv(const Trace& trace) {
  std::string text = "stroke,reached,tracer_x_mm,tracer_y_mm,opening_deg";
  for (const Joint joint : all_joints) text += fmt::format(",{0}_x_mm,{0}_y_mm", letter(joint));
  text += '\n';
  for (const TracedPose& row : trace.poses) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{}", row.stroke, row.pose ? 1 : 0, row.tracer.x(),
                   row.tracer.y());
    if (row.pose) {
      fmt::format_to(std::back_inserter(text), ",{}", opening_degrees(*row.pose));
      for (const Joint joint : all_joints)
        fmt::format_to(std::back_inserter(text), ",{},{}", (*row.pose)[joint].x(), (*row.pose)[joint].y());
    } else {
      text += std::string(13, ',');
    }
    text += '\n';
  }
  return text;
}

}  // namespace kempe
