#include "reports/drawings/copied_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/regions/region_checks.hpp"
#include "reports/drawings/trace_forces.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/sag.hpp"

namespace kempe {
namespace {

Box box_of(const std::vector<DrawnStroke>& strokes) {
  Box box{strokes.front().points.front(), strokes.front().points.front()};
  for (const DrawnStroke& stroke : strokes)
    for (const Point& point : stroke.points) {
      box.lower = box.lower.cwiseMin(point);
      box.upper = box.upper.cwiseMax(point);
    }
  return box;
}

/// By how much the drawing is enlarged to fill the region's box as far as it can.
double enlargement(const std::vector<DrawnStroke>& strokes, const Region& region) {
  const Box drawing = box_of(strokes), room = bounding_box(region);
  const Point size = (drawing.upper - drawing.lower).cwiseMax(1e-9);
  return (room.upper - room.lower).cwiseQuotient(size).minCoeff();
}

/// What is left out of the options: a hundredth and half a millimetre, or shares of a small region.
void fill_in(DrawingOptions& options, const StoredDesign& design, const CopyingLinkage& linkage) {
  double size = linkage.size();
  if (!design.region.empty()) {
    const Box box = bounding_box(design.region);
    size = std::min(size, (box.upper - box.lower).norm());
  }
  if (!options.tolerance) options.tolerance = std::min(0.01, 1e-3 * size);
  if (!options.step) options.step = std::min(0.5, 0.05 * size);
}

/// The drawing as its file has it. Curves are followed so closely that the tolerance holds on the table, after
/// the drawing has been enlarged.
tl::expected<StrokeDrawing, InputError> read_drawing(std::string_view svg, const std::string& file,
                                                     const DrawingOptions& options, const Region& region) {
  const auto read = [&](double scale) {
    return read_svg(svg, file, {.tolerance = *options.tolerance / std::max(1.0, scale)});
  };
  auto drawing = read(options.scale.value_or(1));
  if (!drawing || !options.fit || drawing->strokes.empty() || region.empty()) return drawing;
  const double scale = enlargement(drawing->strokes, region);
  return scale > 1 ? read(scale) : drawing;
}

void place(std::vector<DrawnStroke>& strokes, double scale, const Point& move) {
  for (DrawnStroke& stroke : strokes)
    for (Point& point : stroke.points) point = scale * point + move;
}

/// The drawing on the table: where the options put its page, or in the middle of the region's box, as large
/// as fits.
void place_on_table(std::vector<DrawnStroke>& strokes, const DrawingOptions& options, const Region& region) {
  if (strokes.empty()) return;
  if (!options.fit || region.empty())
    return place(strokes, options.scale.value_or(1), options.at.value_or(Point(0, 0)));
  const Box drawing = box_of(strokes), room = bounding_box(region);
  const double scale = enlargement(strokes, region);
  place(strokes, scale, 0.5 * (room.lower + room.upper) - 0.5 * scale * (drawing.lower + drawing.upper));
}

/// What the hand feels, or why the file cannot tell.
tl::expected<HandWork, InputError> hand_work_of(const StoredDesign& design, const CopyingLinkage& linkage,
                                                const std::string& file) {
  if (design.material && design.load) {
    Spec spec;
    spec.links.style = design.style;
    spec.links.hardware = design.hardware;
    spec.material = design.material;
    spec.load = design.load;
    spec.tolerance = design.tolerance;
    return HandWork(linkage, design.style, design.hardware, *design.material, *design.load,
                    pin_compliance(linkage.grounding(), design.layers, design.style, design.hardware),
                    LayeredErrorProfile(linkage.k(), linkage.grounding(), sag_conditions(spec, design.layers),
                                        design.load->pen_force));
  }
  return tl::unexpected(InputError{file, 0, design.material ? "load" : "material", "a design without it",
                                   "one of a spec with [material] and [load]"});
}

TraceTask trace_task(const StoredDesign& design, const CopyingLinkage& linkage) {
  return {map_task(design, linkage), design.mechanism.opening};
}

}  // namespace

tl::expected<DrawingCopy, InputError> copy_drawing(const StoredDesign& design, const std::string& design_file,
                                                   std::string_view svg, const std::string& drawing_file,
                                                   const DrawingOptions& wanted) {
  DrawingOptions options = wanted;
  const auto linkage = linkage_of(design, design_file);
  if (!linkage) return tl::unexpected(linkage.error());
  fill_in(options, design, *linkage);
  auto drawing = read_drawing(svg, drawing_file, options, design.region);
  if (!drawing) return tl::unexpected(drawing.error());
  if (drawing->strokes.empty())
    return tl::unexpected(
        InputError{drawing_file, 0, "", "a drawing without lines",
                   "paths, lines or shapes" + (drawing->remark().empty() ? "" : "; " + drawing->remark())});
  place_on_table(drawing->strokes, options, design.region);
  if (const double poses = poses_along(drawing->strokes, *options.step); !(poses <= most_traced_poses))
    return tl::unexpected(InputError{"", 0, "step_mm",
                                     fmt::format("{:g} mm, which makes {:.3g} poses", *options.step, poses),
                                     fmt::format("at most {:.0f} poses", most_traced_poses)});
  TraceOptions how;
  how.step = *options.step;
  how.stop = options.stop;
  how.keep_poses = options.keep_joints || options.keep_forces;
  if (options.load || options.keep_forces) {
    auto work = hand_work_of(design, *linkage, design_file);
    if (!work) return tl::unexpected(work.error());
    how.work = std::move(*work);
    how.keep_hand = options.keep_forces;
    how.gives_way = options.load;
  }
  if (options.instrument)
    how.made = TraceOptions::Made{*options.instrument, design.tolerance.value_or(Tolerance{})};
  Trace trace = trace_drawing(trace_task(design, *linkage), drawing->strokes, how);
  return DrawingCopy{std::move(*drawing), std::move(trace), std::move(how.work)};
}

std::string causes(const Trace& trace) {
  std::string text;
  for (std::size_t i = 0; i < all_not_reached.size(); ++i)
    if (trace.missed_by_cause[i] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", trace.missed_by_cause[i],
                          name(all_not_reached[i]));
  return text;
}

std::string drawing_copy_json(const DrawingCopy& copy, const DrawingOptions& options,
                              const std::string& file) {
  const auto& [drawing, trace, work] = copy;
  nlohmann::ordered_json by_cause = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < all_not_reached.size(); ++i)
    if (trace.missed_by_cause[i] > 0)
      by_cause[std::string(name(all_not_reached[i]))] = trace.missed_by_cause[i];
  nlohmann::ordered_json object;
  if (!file.empty()) object["copy"] = file;
  object.update({{"strokes", drawing.strokes.size()},
                 {"lines_drawn", trace.drawn.size()},
                 {"poses", trace.poses_tried},
                 {"drawn_mm", trace.drawn_length},
                 {"departure_max_mm", trace.departure},
                 {"left_out", trace.poses_missed},
                 {"left_out_lines", trace.missing.size()},
                 {"left_out_mm", trace.missing_length},
                 {"left_out_by_cause", by_cause},
                 {"texts", drawing.texts},
                 {"images", drawing.images},
                 {"references", drawing.references}});
  if (!trace.complete) object["complete"] = false;
  if (options.load) object["without_layers"] = trace.without_layers;
  const HandForces forces = hand_forces(trace);
  if (forces.any()) {
    object["hand_min_N"] = forces.least;
    object["hand_max_N"] = forces.most;
  }
  if (forces.dead_points > 0) object["dead_points"] = forces.dead_points;
  return object.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string copy_title(const std::string& drawing_file) {
  return std::filesystem::path(drawing_file).filename().string() + ", copied";
}

}  // namespace kempe
