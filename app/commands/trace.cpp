// kempe trace: a drawing copied through a design's mechanism, pose by pose.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/all_commands.hpp"
#include "app/output_check.hpp"
#include "geometry/regions/region_checks.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/data/design_json.hpp"
#include "reports/drawings/trace_files.hpp"
#include "reports/drawings/trace_forces.hpp"
#include "specs/drawings/svg_reader.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/verification/drawing_trace.hpp"

namespace kempe::app {
namespace {

struct TraceArguments {
  std::string design, drawing, copy, csv, forces;
  std::vector<double> at;
  double scale = 1;
  std::optional<double> tolerance, step;  // mm
  bool fit = false;
  std::optional<std::uint64_t> instrument;
  bool load = false;
  /// True if the design's [load] is asked for.
  bool needs_load() const { return load || !forces.empty(); }
};

tl::expected<StoredDesign, InputError> load_design(const std::string& file) {
  return read_text_file(file).and_then([&](const std::string& text) { return read_design(text, file); });
}

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
double fitting_scale(const std::vector<DrawnStroke>& strokes, const Region& region) {
  const Box drawing = box_of(strokes), room = bounding_box(region);
  const Point size = (drawing.upper - drawing.lower).cwiseMax(1e-9);
  return (room.upper - room.lower).cwiseQuotient(size).minCoeff();
}

/// What is left out of the arguments: a hundredth and half a millimetre, or shares of a small region.
void fill_in(TraceArguments& arguments, const StoredDesign& design, const CopyingLinkage& linkage) {
  double size = linkage.size();
  if (!design.region.empty()) {
    const Box box = bounding_box(design.region);
    size = std::min(size, (box.upper - box.lower).norm());
  }
  if (!arguments.tolerance) arguments.tolerance = std::min(0.01, 1e-3 * size);
  if (!arguments.step) arguments.step = std::min(0.5, 0.05 * size);
}

/// The drawing as its file has it. Curves are followed so closely that the tolerance holds on the table, after
/// the drawing has been enlarged.
tl::expected<StrokeDrawing, InputError> load_drawing(const TraceArguments& arguments, const Region& region) {
  const auto text = read_text_file(arguments.drawing);
  if (!text) return tl::unexpected(text.error());
  const auto read = [&](double scale) {
    return read_svg(*text, arguments.drawing, {.tolerance = *arguments.tolerance / std::max(1.0, scale)});
  };
  auto drawing = read(arguments.scale);
  if (!drawing || !arguments.fit || drawing->strokes.empty() || region.empty()) return drawing;
  const double scale = fitting_scale(drawing->strokes, region);
  return scale > 1 ? read(scale) : drawing;
}

void place(std::vector<DrawnStroke>& strokes, double scale, const Point& move) {
  for (DrawnStroke& stroke : strokes)
    for (Point& point : stroke.points) point = scale * point + move;
}

/// The drawing on the table: where the arguments put its page, or in the middle of the region's box, as large
/// as fits.
void place_on_table(std::vector<DrawnStroke>& strokes, const TraceArguments& arguments,
                    const Region& region) {
  if (strokes.empty()) return;
  if (!arguments.fit || region.empty())
    return place(strokes, arguments.scale,
                 arguments.at.size() == 2 ? Point(arguments.at[0], arguments.at[1]) : Point(0, 0));
  const Box drawing = box_of(strokes), room = bounding_box(region);
  const double scale = fitting_scale(strokes, region);
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

TraceTask task_of(const StoredDesign& design, const CopyingLinkage& linkage) {
  return {map_task(design, linkage), design.mechanism.opening};
}

std::string causes(const Trace& trace) {
  std::string text;
  for (std::size_t i = 0; i < all_not_reached.size(); ++i)
    if (trace.missed_by_cause[i] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", trace.missed_by_cause[i],
                          name(all_not_reached[i]));
  return text;
}

/// "1 line", "2 lines"
std::string lines(std::size_t count) { return fmt::format("{} line{}", count, count == 1 ? "" : "s"); }

std::string hand_lines(const Trace& trace) {
  const HandForces forces = hand_forces(trace);
  std::string text;
  if (forces.any())
    text = fmt::format("hand         {:.3g} to {:.3g} N at the tracer, friction included\n", forces.least,
                       forces.most);
  if (forces.dead_points > 0)
    text += fmt::format("dead points  {} positions where no force of the hand holds the pen\n",
                        forces.dead_points);
  return text;
}

std::string summary_text(const Trace& trace, const StrokeDrawing& drawing, const TraceArguments& arguments) {
  std::string text =
      fmt::format("drawn        {}, from {} in the drawing: {:.1f} mm of the original\n",
                  lines(trace.drawn.size()), lines(drawing.strokes.size()), trace.drawn_length);
  text += fmt::format("poses        {}, the pen at most {:.2g} mm from the exact image{}\n",
                      trace.poses_tried - trace.poses_missed, trace.departure,
                      arguments.load ? " under the load" : "");
  if (arguments.load && trace.without_layers > 0)
    text += fmt::format("layers       not counted at {} places, where their equations lose their digits\n",
                        trace.without_layers);
  if (trace.poses_missed > 0)
    text += fmt::format("left out     {}, {} positions, {:.1f} mm: {}\n", lines(trace.missing.size()),
                        trace.poses_missed, trace.missing_length, causes(trace));
  if (!drawing.remark().empty()) text += "remark       " + drawing.remark() + "\n";
  text += hand_lines(trace);
  return text + "written      " + printable(arguments.copy) +
         (arguments.csv.empty() ? "" : ", " + printable(arguments.csv)) +
         (arguments.forces.empty() ? "" : ", " + printable(arguments.forces)) + "\n";
}

std::string summary_json(const Trace& trace, const StrokeDrawing& drawing, const TraceArguments& arguments) {
  nlohmann::ordered_json by_cause = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < all_not_reached.size(); ++i)
    if (trace.missed_by_cause[i] > 0)
      by_cause[std::string(name(all_not_reached[i]))] = trace.missed_by_cause[i];
  nlohmann::ordered_json object{{"copy", arguments.copy},
                                {"strokes", drawing.strokes.size()},
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
                                {"references", drawing.references}};
  if (arguments.load) object["without_layers"] = trace.without_layers;
  const HandForces forces = hand_forces(trace);
  if (forces.any()) {
    object["hand_min_N"] = forces.least;
    object["hand_max_N"] = forces.most;
  }
  if (forces.dead_points > 0) object["dead_points"] = forces.dead_points;
  return json_text(object);
}

tl::expected<void, std::string> write(const Trace& trace, const TraceArguments& arguments,
                                      const std::optional<HandWork>& work) {
  const std::string title = std::filesystem::path(arguments.drawing).filename().string() + ", copied";
  return write_whole(arguments.copy, copy_svg(trace, title))
      .and_then([&]() -> tl::expected<void, std::string> {
        if (arguments.csv.empty()) return {};
        return write_whole(arguments.csv, poses_csv(trace));
      })
      .and_then([&]() -> tl::expected<void, std::string> {
        if (arguments.forces.empty()) return {};
        return write_whole(arguments.forces, forces_csv(trace, *work));
      });
}

int run(const Session& session, TraceArguments arguments) {
  if (const auto clash = output_clash({arguments.design, arguments.drawing},
                                      {arguments.copy, arguments.csv, arguments.forces}))
    return fail(session, *clash);
  const auto design = load_design(arguments.design);
  if (!design) return fail(session, design.error());
  const auto linkage = linkage_of(*design, arguments.design);
  if (!linkage) return fail(session, linkage.error());
  fill_in(arguments, *design, *linkage);
  auto drawing = load_drawing(arguments, design->region);
  if (!drawing) return fail(session, drawing.error());
  if (drawing->strokes.empty())
    return fail(session,
                {arguments.drawing, 0, "", "a drawing without lines",
                 "paths, lines or shapes" + (drawing->remark().empty() ? "" : "; " + drawing->remark())});
  place_on_table(drawing->strokes, arguments, design->region);
  TraceOptions options;
  options.step = *arguments.step;
  options.keep_poses = !arguments.csv.empty() || !arguments.forces.empty();
  if (arguments.needs_load()) {
    auto work = hand_work_of(*design, *linkage, arguments.design);
    if (!work) return fail(session, work.error());
    options.work = std::move(*work);
    options.keep_hand = !arguments.forces.empty();
    options.gives_way = arguments.load;
  }
  if (arguments.instrument)
    options.made = TraceOptions::Made{*arguments.instrument, design->tolerance.value_or(Tolerance{})};
  const Trace trace = trace_drawing(task_of(*design, *linkage), drawing->strokes, options);
  if (const auto written = write(trace, arguments, options.work); !written)
    return fail(session, cannot_write, written.error());
  answer(session, summary_text(trace, *drawing, arguments), summary_json(trace, *drawing, arguments));
  if (trace.poses_missed == 0) return done;
  return fail_told(verification_failed,
                   fmt::format("{}: {} positions cannot be reached and are left out ({}); they are red in {}",
                               printable(arguments.drawing), trace.poses_missed, causes(trace),
                               printable(arguments.copy)));
}

}  // namespace

void add_trace_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "trace", "Copy a drawing through a design's mechanism, pose by pose",
                  "kempe trace out/nameplate/design.json docs/pictures/letter.svg -o copy.svg --fit");
  auto arguments = std::make_shared<TraceArguments>();
  command->add_option("DESIGN", arguments->design, "A design.json")->required();
  command
      ->add_option("DRAWING", arguments->drawing,
                   "An SVG; its page's lower left corner lies at the table's origin")
      ->required();
  command->add_option("-o,--output", arguments->copy, "The copy, an SVG")->required();
  command->add_option("--csv", arguments->csv, "Also write every joint's place at every pose");
  command->add_option(
      "--forces", arguments->forces,
      "Also write what the hand feels at every pose, and colour the copy by it; needs a design "
      "with [load]");
  command->add_flag("--load", arguments->load,
                    "Draw as the loaded instrument would, whose pen gives way; needs a design with [load]");
  auto* at = command->add_option("--at", arguments->at, "Where the page's lower left corner lies instead, mm")
                 ->check(number_between(-largest_coordinate, largest_coordinate))
                 ->expected(2);
  auto* scale = command->add_option("--scale", arguments->scale, "Enlarge the drawing before it is traced")
                    ->check(number_between(1e-6, 1e6));
  command
      ->add_flag("--fit", arguments->fit,
                 "Place the drawing in the middle of the design's region, as large as fits its box")
      ->excludes(at)
      ->excludes(scale);
  command->add_option("--instrument", arguments->instrument,
                      "Draw with an instrument made within the design's tolerances, chosen by this seed");
  command
      ->add_option(
          "--tolerance", arguments->tolerance,
          "Curves are followed to this, mm; left out: 0.01, or a thousandth of the region's diagonal if less")
      ->check(number_between(1e-7, 10));
  command
      ->add_option("--step", arguments->step,
                   "Poses are at most this far apart, mm; left out: 0.5, or a twentieth of the region's "
                   "diagonal if less")
      ->check(number_between(1e-4, 1e3));
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
