// kempe workspace: the map of a mechanism whose lengths the spec gives.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/design_run.hpp"
#include "app/stopping.hpp"
#include "app/studio_page.hpp"
#include "geometry/regions/region_checks.hpp"
#include "reports/data/design_json.hpp"
#include "specs/file_kind.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"

namespace kempe::app {
namespace {

struct WorkspaceArguments {
  std::string spec_file, folder;
  std::vector<double> why;  // x, y
  double map_tolerance = MapOptions{}.map_tolerance;
  double time_limit = Deadline::unlimited;
  bool studio = false;
  Paper paper = Paper::A4;
};

int tell_why(const Session& session, const MapTask& task, const Point& tracer) {
  const Verdict verdict = verdict_at(task, tracer);
  nlohmann::ordered_json object{
      {"tracer_mm", {tracer.x(), tracer.y()}}, {"free", verdict.free}, {"uncertain", verdict.uncertain}};
  if (verdict.cause) object["cause"] = std::string(name(*verdict.cause));
  object["parts"] = verdict.parts;
  object["sentence"] = verdict.sentence;
  answer(session, fmt::format("({:.6g}, {:.6g}): {}\n", tracer.x(), tracer.y(), verdict.sentence),
         json_text(object));
  return done;
}

/// The place seen by the design that a file holds.
int tell_why_of_design(const Session& session, const std::string& text, const std::string& file,
                       const Point& tracer) {
  const auto design = read_design(text, file);
  if (!design) return fail(session, design.error());
  const auto linkage = linkage_of(*design, file);
  return linkage ? tell_why(session, map_task(*design, *linkage), tracer) : fail(session, linkage.error());
}

int run(const Session& session, const WorkspaceArguments& arguments) {
  const Deadline deadline(arguments.time_limit);
  const std::optional<Point> place =
      arguments.why.empty() ? std::nullopt : std::optional(Point(arguments.why[0], arguments.why[1]));
  const auto text = input_text(session, arguments.spec_file);
  if (!text) return fail(session, text.error());
  if (place && recognised_kind(*text) == FileKind::design)
    return tell_why_of_design(session, *text, arguments.spec_file, *place);
  const auto loaded = spec_of_text(*text, arguments.spec_file);
  if (!loaded) return fail(session, loaded.error());
  const auto studio = studio_page_if(arguments.studio, *loaded);
  if (!studio) return fail(session, failed, studio.error());
  const auto linkage = given_linkage(loaded->spec, loaded->file);
  const SpecUnit unit = loaded->unit();
  if (!linkage) return fail(session, as_in_file(linkage.error(), unit));
  if (const auto none = pole_blocked(loaded->spec, unit)) return tell_no_design(session, *none, unit);
  const Stopping stopping(deadline);
  Design design = assemble_given(loaded->spec, *linkage,
                                 {.map_tolerance = arguments.map_tolerance, .stop = stopping.flag()});
  if (place) return tell_why(session, map_task(design), *place);
  const TimeToFinish time{stopping.flag(time_to_map(stopping.limit())),
                          stopping.flag(time_to_write(stopping.limit()))};
  const int code = publish_design(session, design, *loaded, arguments.folder, time, *studio, arguments.paper);
  return code == done && stopping.interrupted() ? interrupted : code;
}

}  // namespace

void add_workspace_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "workspace", "Map a mechanism whose lengths the spec gives ([mechanism])",
                  "kempe workspace specs/examples/report-mechanism.toml -o out/report-mechanism");
  auto arguments = std::make_shared<WorkspaceArguments>();
  command
      ->add_option("SPEC", arguments->spec_file,
                   "The spec (TOML; see docs/spec.md); with --why also a design.json")
      ->required();
  auto* folder = command->add_option("-o,--output", arguments->folder, "Folder for the map's files");
  auto* why = command
                  ->add_option("--why", arguments->why,
                               "Say why the tracer can or cannot stand at X,Y (mm); no file is written")
                  ->delimiter(',')
                  ->check(number_between(-largest_coordinate, largest_coordinate))
                  ->expected(2);
  command
      ->add_option("--map-tolerance", arguments->map_tolerance,
                   "Share of the free workspace that may stay uncertain")
      ->check(number_between(1e-5, 0.5))
      ->capture_default_str();
  add_time_limit(*command, arguments->time_limit, "Seconds; then the map as fine as it is, marked as such");
  add_studio_option(*command, arguments->studio);
  add_paper_option(*command, arguments->paper);
  command->callback([&session, arguments, folder, why] {
    if (folder->empty() && why->empty()) throw CLI::RequiredError("--output or --why");
    session.chosen = [&session, arguments] { return run(session, *arguments); };
  });
}

}  // namespace kempe::app
