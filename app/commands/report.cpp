// kempe report: everything that synthesize writes, from a design's file alone.

#include <memory>

#include "app/all_commands.hpp"
#include "app/broken_design.hpp"
#include "app/command.hpp"
#include "app/design_run.hpp"
#include "app/stopping.hpp"
#include "app/studio_page.hpp"
#include "reports/restored_design.hpp"
#include "specs/spec_check.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/design/assemble.hpp"

namespace kempe::app {
namespace {

struct ReportArguments {
  std::string design, folder;
  double time_limit = Deadline::unlimited;
  bool studio = false;
  Paper paper = Paper::A4;
};

/// The design's spec stands in no file; its text follows from the design.
LoadedSpec spec_in(const Design& design, const std::string& file) {
  const Spec spec = spec_of(design);
  return {file, spec_as_toml(spec), spec};
}

int run(const Session& session, const ReportArguments& arguments) {
  const auto text = read_text_file(arguments.design);
  if (!text) return fail(session, text.error());
  const auto stored = read_design(*text, arguments.design);
  if (!stored) return fail(session, stored.error());
  const auto found = audit(*stored, arguments.design);
  if (!found) return fail(session, found.error());
  if (!found->holds())
    return fail(
        session, verification_failed,
        broken_text(*found, arguments.design) + "\n  nothing is written of a design that does not hold");
  // What is not verified is not written, whatever the limit: until here Ctrl-C ends the program at once.
  const Stopping stopping{Deadline(arguments.time_limit)};
  const StopFlag to_map = stopping.flag(time_to_map(stopping.limit()));
  auto design = restored_design(*stored, arguments.design, to_map);
  if (!design) return fail(session, design.error());
  const LoadedSpec spec = spec_in(*design, arguments.design);
  const auto studio = studio_page_if(arguments.studio, spec);
  if (!studio) return fail(session, failed, studio.error());
  const TimeToFinish time{to_map, stopping.flag(time_to_write(stopping.limit()))};
  const int code = publish_design(session, *design, spec, arguments.folder, time, *studio, arguments.paper);
  return code == done && stopping.interrupted() ? interrupted : code;
}

}  // namespace

void add_report_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "report",
                                  "Write the report, drawings and parts of a design from its file alone",
                                  "kempe report out/front/07/design.json -o out/chosen");
  auto arguments = std::make_shared<ReportArguments>();
  command->add_option("DESIGN", arguments->design, "A design.json; it is verified first")->required();
  command->add_option("-o,--output", arguments->folder, "Folder for the design's files")->required();
  add_time_limit(
      *command, arguments->time_limit,
      "Seconds, from when the file is verified; then a coarser map, marked as such, and files are left out");
  add_studio_option(*command, arguments->studio);
  add_paper_option(*command, arguments->paper);
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
