// kempe/trace.hpp.

#include "kempe/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/regions/region_checks.hpp"
#include "library/workings.hpp"
#include "reports/data/design_json.hpp"
#include "reports/drawings/copied_drawing.hpp"
#include "reports/drawings/trace_files.hpp"
#include "reports/drawings/trace_forces.hpp"
#include "specs/text/text_file.hpp"
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

CopiedDrawing copied(const Trace& found) {
  return {copied(found.drawn), copied(found.missing), found.drawn_length, found.missing_length,
          found.poses_tried,   found.poses_missed,    found.departure,    found.complete};
}

/// A number out of its range.
std::optional<InputError> out_of_range(const char* key, const std::optional<double>& number,
                                       const OptionRange& range) {
  if (!number || (*number >= range.lowest && *number <= range.highest)) return std::nullopt;
  return InputError{"", 0, key, fmt::format("{}", *number),
                    fmt::format("{:g} to {:g}", range.lowest, range.highest)};
}

std::optional<InputError> fault_in(const DrawingOptions& options) {
  if (options.fit && (options.at || options.scale))
    return InputError{"", 0, "fit", options.at ? "with at" : "with scale", "one of them"};
  if (options.at && !(options.at->cwiseAbs().maxCoeff() <= largest_coordinate && options.at->allFinite()))
    return InputError{"", 0, "at", fmt::format("({}, {})", options.at->x(), options.at->y()),
                      fmt::format("finite numbers of at most {:g}, mm", largest_coordinate)};
  if (auto fault = out_of_range("scale", options.scale, drawing_scales)) return fault;
  if (auto fault = out_of_range("tolerance_mm", options.tolerance, drawing_tolerances)) return fault;
  return out_of_range("step_mm", options.step, drawing_steps);
}

}  // namespace

std::variant<CopiedDrawing, InputError> trace(const FinishedDesign& design,
                                              const std::vector<Polyline>& lines, double step,
                                              const std::function<bool()>& stop) {
  if (const auto fault = fault_in(lines, step)) return *fault;
  std::vector<DrawnStroke> strokes;
  for (const Polyline& line : lines) strokes.push_back({line, false});
  if (const double poses = poses_along(strokes, step); !(poses <= most_traced_poses))
    return InputError{"", 0, "step", fmt::format("{:g} mm, which makes {:.3g} poses", step, poses),
                      fmt::format("at most {:.0f} poses", most_traced_poses)};
  const Design& inside = Workings::inside(design);
  const Trace found =
      trace_drawing({map_task(inside), inside.opening}, strokes, {.step = step, .stop = stop});
  return copied(found);
}

std::variant<TracedDrawing, InputError> trace_svg(const FinishedDesign& design, std::string_view drawing,
                                                  const DrawingOptions& options, const std::string& name) {
  if (const auto fault = fault_in(options)) return *fault;
  // As its file states it, so that the copy is that of the command.
  const auto stored = read_design(design.json(), "");
  if (!stored) return stored.error();
  const auto copy = copy_drawing(*stored, "", drawing, name, options);
  if (!copy) return copy.error();
  TracedDrawing traced{copied(copy->trace),
                       drawing_copy_json(*copy, options, ""),
                       copy_svg(copy->trace, copy_title(name.empty() ? "drawing" : name)),
                       {},
                       {}};
  if (options.keep_joints) traced.joints_csv = poses_csv(copy->trace);
  if (options.keep_forces) traced.forces_csv = forces_csv(copy->trace, *copy->work);
  return traced;
}

std::variant<TracedDrawing, InputError> trace_svg_file(const FinishedDesign& design,
                                                       const std::filesystem::path& drawing,
                                                       const DrawingOptions& options) {
  const auto text = read_text_file(drawing);
  if (!text) return text.error();
  return trace_svg(design, *text, options, drawing.string());
}

}  // namespace kempe
