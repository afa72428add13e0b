// kempe trace: a drawing copied through a design's mechanism, pose by pose.

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/output_check.hpp"
#include "app/words.hpp"
#include "geometry/regions/region_checks.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/drawings/copied_drawing.hpp"
#include "reports/drawings/trace_files.hpp"
#include "reports/drawings/trace_forces.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

struct TraceArguments {
  std::string design, drawing, copy, csv, forces;
  std::vector<double> at;
  DrawingOptions options;
};

tl::expected<StoredDesign, InputError> load_design(const std::string& file) {
  return read_text_file(file).and_then([&](const std::string& text) { return read_design(text, file); });
}

std::string hand_lines(const Trace& trace) {
  const HandForces forces = hand_forces(trace);
  std::string text;
  if (forces.any())
    text = fmt::format("hand         {:.3g} to {:.3g} N at the tracer, friction included\n", forces.least,
                       forces.most);
  if (forces.dead_points > 0)
    text += fmt::format("dead points  {} where no force of the hand holds the pen\n",
                        counted(forces.dead_points, "position"));
  return text;
}

std::string summary_text(const DrawingCopy& copy, const TraceArguments& arguments) {
  const auto& [drawing, trace, work] = copy;
  std::string text = fmt::format("drawn        {}, from {} in the drawing: {} mm of the original\n",
                                 counted(trace.drawn.size(), "line"), counted(drawing.strokes.size(), "line"),
                                 shown(trace.drawn_length, 1));
  text += fmt::format("poses        {}, the pen at most {:.2g} mm from the exact image{}\n",
                      trace.poses_tried - trace.poses_missed, trace.departure,
                      arguments.options.load ? " under the load" : "");
  if (arguments.options.load && trace.without_layers > 0)
    text += fmt::format("layers       not counted at {}, where their equations lose their digits\n",
                        counted(trace.without_layers, "place"));
  if (trace.poses_missed > 0)
    text +=
        fmt::format("left out     {}, {}, {} mm: {}\n", counted(trace.missing.size(), "line"),
                    counted(trace.poses_missed, "position"), shown(trace.missing_length, 1), causes(trace));
  if (!drawing.remark().empty()) text += "remark       " + drawing.remark() + "\n";
  text += hand_lines(trace);
  return text + "written      " + printable(arguments.copy) +
         (arguments.csv.empty() ? "" : ", " + printable(arguments.csv)) +
         (arguments.forces.empty() ? "" : ", " + printable(arguments.forces)) + "\n";
}

tl::expected<void, std::string> write(const DrawingCopy& copy, const TraceArguments& arguments) {
  return write_whole(arguments.copy, copy_svg(copy.trace, copy_title(arguments.drawing)))
      .and_then([&]() -> tl::expected<void, std::string> {
        if (arguments.csv.empty()) return {};
        return write_whole(arguments.csv, poses_csv(copy.trace));
      })
      .and_then([&]() -> tl::expected<void, std::string> {
        if (arguments.forces.empty()) return {};
        return write_whole(arguments.forces, forces_csv(copy.trace, *copy.work));
      });
}

int run(const Session& session, TraceArguments arguments) {
  if (const auto clash = output_clash({arguments.design, arguments.drawing},
                                      {arguments.copy, arguments.csv, arguments.forces}))
    return fail(session, *clash);
  const auto design = load_design(arguments.design);
  if (!design) return fail(session, design.error());
  const auto svg = read_text_file(arguments.drawing);
  if (!svg) return fail(session, svg.error());
  DrawingOptions& options = arguments.options;
  if (arguments.at.size() == 2) options.at = Point(arguments.at[0], arguments.at[1]);
  options.keep_joints = !arguments.csv.empty();
  options.keep_forces = !arguments.forces.empty();
  const auto copy = copy_drawing(*design, arguments.design, *svg, arguments.drawing, options);
  if (!copy) return fail(session, copy.error());
  if (const auto written = write(*copy, arguments); !written)
    return fail(session, cannot_write, written.error());
  answer(session, summary_text(*copy, arguments), drawing_copy_json(*copy, options, arguments.copy));
  if (copy->trace.poses_missed == 0) return done;
  return fail_told(
      verification_failed,
      fmt::format("{}: {} cannot be reached and {} left out ({}), red in {}", printable(arguments.drawing),
                  counted(copy->trace.poses_missed, "position"), copy->trace.poses_missed == 1 ? "is" : "are",
                  causes(copy->trace), printable(arguments.copy)));
}

CLI::Validator number_in(const OptionRange& range) { return number_between(range.lowest, range.highest); }

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
  command->add_flag("--load", arguments->options.load,
                    "Draw as the loaded instrument would, whose pen gives way; needs a design with [load]");
  auto* at = command->add_option("--at", arguments->at, "Where the page's lower left corner lies instead, mm")
                 ->check(number_between(-largest_coordinate, largest_coordinate))
                 ->expected(2);
  auto* scale =
      command->add_option("--scale", arguments->options.scale, "Enlarge the drawing before it is traced")
          ->check(number_in(drawing_scales));
  command
      ->add_flag("--fit", arguments->options.fit,
                 "Place the drawing in the middle of the design's region, as large as fits its box")
      ->excludes(at)
      ->excludes(scale);
  command->add_option("--instrument", arguments->options.instrument,
                      "Draw with an instrument made within the design's tolerances, chosen by this seed");
  command
      ->add_option(
          "--tolerance", arguments->options.tolerance,
          "Curves are followed to this, mm; left out: 0.01, or a thousandth of the region's diagonal if less")
      ->check(number_in(drawing_tolerances));
  command
      ->add_option("--step", arguments->options.step,
                   "Poses are at most this far apart, mm; left out: 0.5, or a twentieth of the region's "
                   "diagonal if less")
      ->check(number_in(drawing_steps));
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
