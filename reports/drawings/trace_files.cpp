#include "reports/drawings/trace_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "reports/drawings/svg_writer.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

ArcRing as_ring(const Stroke& points) {
  ArcRing ring;
  ring.reserve(points.size());
  for (const Point& point : points) ring.push_back({point, 0});
  return ring;
}

std::string group(const std::vector<TracedLine>& lines, std::string_view attributes) {
  std::string text =
      fmt::format("<g {} fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n", attributes);
  for (const TracedLine& line : lines)
    text += fmt::format("<path d=\"{}\"/>\n", outline_path(as_ring(line.points), line.closed));
  return text + "</g>\n";
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
  const Point size = box.upper - box.lower + Point(2 * margin, 2 * margin);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"{2} {3} {0} {1}\">\n<title>{4}</title>\n",
      size.x(), size.y(), box.lower.x() - margin, -box.upper.y() - margin, html_escaped(title));
  text += group(trace.drawn, "id=\"copy\" stroke=\"#000\" stroke-width=\"0.25\"");
  if (!trace.missing.empty())
    text += group(trace.missing,
                  "id=\"left-out\" stroke=\"#e00000\" stroke-width=\"0.25\" stroke-dasharray=\"1 0.6\"");
  return text + "</svg>\n";
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
