// kempe/trace.hpp.

#include "kempe/trace.hpp"

#include <algorithm>
#include <cmath>

#include "library/workings.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/drawing_trace.hpp"

namespace kempe {
namespace {

bool is_finite(const Polyline& line) {
  return std::all_of(line.begin(), line.end(), [](const Point& point) { return point.allFinite(); });
}

std::vector<CopiedLine> copied(const std::vector<TracedLine>& lines) {
  std::vector<CopiedLine> copies;
  for (const TracedLine& line : lines) {
    copies.push_back({line.stroke, line.points});
    if (line.closed && !line.points.empty()) copies.back().points.push_back(line.points.front());
  }
  return copies;
}

}  // namespace

CopiedDrawing trace(const FinishedDesign& design, const std::vector<Polyline>& lines, double step) {
  if (!(step > 0) || !std::isfinite(step) || !std::all_of(lines.begin(), lines.end(), is_finite)) return {};
  std::vector<DrawnStroke> strokes;
  for (const Polyline& line : lines) strokes.push_back({line, false});
  const Design& inside = Workings::inside(design);
  const Trace found = trace_drawing({map_task(inside), inside.opening}, strokes, {.step = step});
  return {copied(found.drawn), copied(found.missing), found.drawn_length, found.missing_length,
          found.poses_tried,   found.poses_missed,    found.departure};
}

}  // namespace kempe
