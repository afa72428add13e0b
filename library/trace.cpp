// kempe/trace.hpp.

#include "kempe/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "library/workings.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/drawing_trace.hpp"

namespace kempe {
namespace {

bool is_finite(const Polyline& line) {
  return std::all_of(line.begin(), line.end(), [](const Point& point) { return point.allFinite(); });
}

std::optional<InputError> fault_in(const std::vector<Polyline>& lines, double step) {
  if (!(step > 0) || !std::isfinite(step))
    return InputError{"", 0, "step", fmt::format("{}", step), "a finite number > 0, mm"};
  const auto bad = std::find_if_not(lines.begin(), lines.end(), is_finite);
  if (bad == lines.end()) return std::nullopt;
  return InputError{"", 0, fmt::format("lines[{}]", bad - lines.begin()), "a point that is not finite",
                    "finite numbers, mm"};
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

std::variant<CopiedDrawing, InputError> trace(const FinishedDesign& design,
                                              const std::vector<Polyline>& lines, double step) {
  if (const auto fault = fault_in(lines, step)) return *fault;
  std::vector<DrawnStroke> strokes;
  for (const Polyline& line : lines) strokes.push_back({line, false});
  const Design& inside = Workings::inside(design);
  const Trace found = trace_drawing({map_task(inside), inside.opening}, strokes, {.step = step});
  return CopiedDrawing{copied(found.drawn), copied(found.missing), found.drawn_length, found.missing_length,
                       found.poses_tried,   found.poses_missed,    found.departure};
}

}  // namespace kempe
