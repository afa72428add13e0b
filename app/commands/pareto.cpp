// kempe pareto: the front between two objectives, a design a point.

#include "synthesis/search/pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/design_run.hpp"
#include "app/output_check.hpp"
#include "app/progress.hpp"
#include "app/stopping.hpp"
#include "app/words.hpp"
#include "reports/front_folder.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search_faults.hpp"

namespace kempe::app {
namespace {

struct ParetoArguments {
  std::string spec_file, folder;
  std::vector<std::string> between;
  int points = 15;
  std::uint64_t seed = 1;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  double time_limit = Deadline::unlimited;
};

ReportExtras extras_of(const LoadedSpec& loaded) {
  ReportExtras extras;
  extras.program_version = KEMPE_VERSION;
  extras.spec_name = shown_name(loaded.file);
  extras.spec_text = loaded.text;
  return extras;
}

/// Assembles, verifies and drafts every point; the error names the point that failed.
tl::expected<FrontFolder, std::string> draft_front(const std::vector<ParetoPoint>& points,
                                                   const LoadedSpec& loaded,
                                                   const std::filesystem::path& folder, Objective first,
                                                   Objective second, const TimeToFinish& time) {
  FrontFolder front(folder, first, second, points.size(), extras_of(loaded));
  for (const ParetoPoint& point : points) {
    Design design =
        assemble_design(loaded.spec, point.design, {.largest_sheets = false, .stop = time.enough});
    design.quality.proven_bound.reset();  // a bound of the spec's objective, not of this point's
    if (const auto added = front.add(std::move(design), point.a, point.b, time); !added)
      return tl::unexpected(added.error());
  }
  return front;
}

/// Why a front has fewer points than were asked for; empty where it has all, or was stopped.
std::string fewer_points(std::size_t found, int asked, bool complete) {
  if (!complete || found >= static_cast<std::size_t>(asked)) return "";
  return fmt::format(
      "{} searches gave {} that no other beats in both: the rest gave the same again, or worse ones", asked,
      counted(found, "different design"));
}

/// The two figures of every point; front.csv has all digits, and lengths and pole.
std::string summary_text(const ParetoFront& front, int asked, bool complete, const std::string& folder) {
  std::string text =
      fmt::format("{}front        {}: {} in {}, {} in {}\n",
                  complete ? "" : "STOPPED EARLY: the front so far\n", counted(front.rows.size(), "design"),
                  front.first_name, front.first_unit, front.second_name, front.second_unit);
  for (const ParetoRow& row : front.rows)
    text += fmt::format("  {} {:14.6g} {:14.6g}\n", row.name, row.first, row.second);
  if (const std::string why = fewer_points(front.rows.size(), asked, complete); !why.empty())
    text += "points       " + why + "\n";
  return text + fmt::format(
                    "written      {}: report.html front.csv, and all files of a design in a folder a point\n",
                    printable(folder));
}

int run(const Session& session, const ParetoArguments& arguments) {
  const Deadline deadline(arguments.time_limit);
  const auto loaded = load_spec(session, arguments.spec_file);
  if (!loaded) return fail(session, loaded.error());
  const auto first = objective_named(arguments.between.front()),
             second = objective_named(arguments.between.back());
  if (arguments.between.size() != 2 || !first || !second || *first == *second)
    return fail(session,
                {"", 0, "--between", fmt::format("{}", fmt::join(arguments.between, ",")),
                 "two of size, transmission, copy_error, footprint, load_error, mass, as size,copy_error"});
  if (auto fault = front_fault(loaded->spec, *first, *second)) {
    fault->file = loaded->file;
    return fail(session, as_in_file(*fault, loaded->unit()));
  }
  const Stopping stopping(deadline);
  tl::expected<std::vector<ParetoPoint>, NoDesign> front;
  {
    Progress progress(session.quiet);
    SearchOptions options;
    options.seed = arguments.seed;
    options.unit = loaded->unit();
    options.threads = arguments.threads;
    options.time_limit = stopping.left();
    options.stop = stopping.flag();
    options.progress = [&](double share, std::string_view what) { progress.show(share, what); };
    front = pareto_front(loaded->spec, *first, *second, arguments.points, options);
  }
  bool complete = !stopping.flag()();
  if (!front) return tell_no_design(session, front.error(), loaded->unit());
  if (front->empty() && !complete)
    return tell_stopped(session, stopping, "before a point of the front was found; nothing is written");
  if (front->empty()) return fail_unproven(session, none_found);
  const TimeToFinish time{stopping.flag(time_to_map(stopping.limit())),
                          stopping.flag(time_to_write(stopping.limit()))};
  auto files = draft_front(*front, *loaded, arguments.folder, *first, *second, time);
  if (!files) return fail(session, verification_failed, files.error());
  complete = complete && files->complete();
  if (const auto clash = output_clash(loaded->inputs(), arguments.folder, files->names()))
    return fail(session, *clash);
  if (const auto written = files->put_in_place(); !written)
    return fail(session, cannot_write, written.error());
  const int sections = std::max(1, static_cast<int>(loaded->spec.links.sections.size()));
  nlohmann::ordered_json object{{"points", front->size()},
                                {"asked", arguments.points},
                                {"folder", arguments.folder},
                                {"complete", complete},
                                {"left_out", files->left_out()}};
  print(session.json ? json_text(object)
                     : summary_text(files->chart(), arguments.points * sections, complete, arguments.folder));
  for (const std::string& sentence : files->left_out()) say(sentence);
  return stopping.interrupted() ? interrupted : done;
}

}  // namespace

void add_pareto_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "pareto", "The front between two objectives, each point a design",
                  "kempe pareto specs/examples/nameplate.toml --between size,transmission -o out/front");
  auto arguments = std::make_shared<ParetoArguments>();
  command->add_option("SPEC", arguments->spec_file, "The spec (TOML; see docs/spec.md)")->required();
  command
      ->add_option("--between", arguments->between,
                   "Two of size, transmission, copy_error, footprint, load_error, mass")
      ->required()
      ->delimiter(',');
  command->add_option("--points", arguments->points, "Number of points")
      ->check(CLI::Range(2, 200))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder, "Folder for the front's files")->required();
  add_seed_option(*command, arguments->seed, "Seed of the random numbers; the same seed gives the same front")
      ->capture_default_str();
  add_threads_option(*command, arguments->threads);
  add_time_limit(*command, arguments->time_limit,
                 "Seconds; then the points found so far, or exit code 6 without any");
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
