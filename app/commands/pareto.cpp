// kempe pareto: the front between two objectives, a design a point.

#include "synthesis/search/pareto.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/all_commands.hpp"
#include "app/design_run.hpp"
#include "app/output_check.hpp"
#include "app/progress.hpp"
#include "app/stopping.hpp"
#include "reports/data/design_json.hpp"
#include "reports/design_package.hpp"
#include "specs/objective_unit.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/verification.hpp"

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

constexpr std::array objectives{Objective::size, Objective::transmission, Objective::copy_error,
                                Objective::footprint};

std::optional<Objective> objective_named(const std::string& word) {
  for (const Objective one : objectives)
    if (word == name(one)) return one;
  return std::nullopt;
}

/// For the table: a millionth of a micrometre is nothing (design.json has every digit).
double coordinate(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

/// What the report's chart shows, and the table of the CSV.
struct FrontFiles {
  std::vector<OutputFile> files;
  ParetoFront chart;
  std::string csv;
};

/// Assembles and verifies every point; the error names the point that failed.
tl::expected<FrontFiles, std::string> files_of(const std::vector<ParetoPoint>& front,
                                               const LoadedSpec& loaded, Objective first, Objective second) {
  FrontFiles all;
  all.chart = {std::string(name(first)),
               std::string(unit_of(first)),
               std::string(name(second)),
               std::string(unit_of(second)),
               {}};
  all.csv = fmt::format("point,{}_{},{}_{},vertex,assembly,VA_mm,VB_mm,pole_x_mm,pole_y_mm\n", name(first),
                        unit_of(first), name(second), unit_of(second));
  std::optional<Design> middle;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const ParetoPoint& point = front[i];
    MapOptions map;
    map.largest_sheets = false;
    Design design = assemble_design(loaded.spec, point.design, map);
    design.quality.proven_bound.reset();  // a bound of the spec's objective, not of this point's
    design.verification = verify(verification_task(design));
    const std::string number = fmt::format("{:02}", i + 1);
    if (!design.verification.certified)
      return tl::unexpected("point " + number + ": " + design.verification.failure);
    all.files.push_back({number + "/design.json", design_json(design)});
    const bool is_middle = i == front.size() / 2;
    all.chart.rows.push_back(
        {number, in_file_unit(first, point.a), in_file_unit(second, point.b), is_middle});
    const CopyingLinkage& l = design.linkage;
    all.csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", number, in_file_unit(first, point.a),
                           in_file_unit(second, point.b), name(l.grounding()), l.assembly_mode(), l.VA(),
                           l.VB(), coordinate(l.pole().x()), coordinate(l.pole().y()));
    if (is_middle) middle = std::move(design);
  }
  ReportExtras extras;
  extras.program_version = KEMPE_VERSION;
  extras.spec_name = shown_name(loaded.file);
  extras.spec_text = loaded.text;
  extras.pareto = all.chart;
  all.files.push_back({"report.html", html_report(*middle, extras)});
  all.files.push_back({"front.csv", all.csv});
  return all;
}

int run(const Session& session, const ParetoArguments& arguments) {
  const auto loaded = load_spec(arguments.spec_file);
  if (!loaded) return fail(session, loaded.error());
  const auto first = objective_named(arguments.between.front()),
             second = objective_named(arguments.between.back());
  if (arguments.between.size() != 2 || !first || !second || *first == *second)
    return fail(session, {"", 0, "--between", fmt::format("{}", fmt::join(arguments.between, ",")),
                          "two of size, transmission, copy_error, footprint, as size,copy_error"});
  if ((*first == Objective::copy_error || *second == Objective::copy_error) && !loaded->spec.tolerance)
    return fail(session, {loaded->file, 0, "tolerance", "no such table",
                          "[tolerance] with length_mm and play_mm, for copy_error"});
  if (loaded->spec.tolerance && loaded->spec.tolerance->robust)
    return fail(session, {loaded->file, 0, "tolerance.robust", "true",
                          "false: fronts are of the instruments as drawn"});
  const Stopping stopping(arguments.time_limit);
  tl::expected<std::vector<ParetoPoint>, NoDesign> front;
  {
    Progress progress(session.quiet);
    SearchOptions options;
    options.seed = arguments.seed;
    options.threads = arguments.threads;
    options.stop = stopping.flag();
    options.progress = [&](double share, std::string_view what) { progress.show(share, what); };
    front = pareto_front(loaded->spec, *first, *second, arguments.points, options);
  }
  const bool complete = !stopping.flag()();
  if (!front) return tell_no_design(session, front.error());
  if (front->empty() && !complete)
    return tell_stopped(session, stopping, "before a point of the front was found; nothing is written");
  if (front->empty()) return fail(session, no_design, "no design was found");
  const auto files = files_of(*front, *loaded, *first, *second);
  if (!files) return fail(session, verification_failed, files.error());
  std::vector<std::string> names;
  for (const OutputFile& file : files->files) names.push_back(file.name.string());
  if (const auto clash = output_clash(loaded->inputs(), arguments.folder, names))
    return fail(session, *clash);
  if (const auto written = write_whole(arguments.folder, files->files); !written)
    return fail(session, cannot_write, written.error());
  nlohmann::ordered_json object{
      {"points", front->size()}, {"folder", arguments.folder}, {"complete", complete}};
  print(session.json
            ? json_text(object)
            : files->csv + fmt::format("{}written {}\n", complete ? "" : "STOPPED EARLY: the front so far\n",
                                       printable(arguments.folder)));
  return stopping.interrupted() ? interrupted : done;
}

}  // namespace

void add_pareto_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "pareto", "The front between two objectives, each point a design",
                  "kempe pareto specs/examples/nameplate.toml --between size,transmission -o out/front");
  auto arguments = std::make_shared<ParetoArguments>();
  command->add_option("SPEC", arguments->spec_file, "The spec (TOML; see docs/spec.md)")->required();
  command->add_option("--between", arguments->between, "Two of size, transmission, copy_error, footprint")
      ->required()
      ->delimiter(',');
  command->add_option("--points", arguments->points, "How many points the front shall have")
      ->check(CLI::Range(2, 200))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder, "Folder for the front's files")->required();
  command->add_option("--seed", arguments->seed, "Of the random numbers: the same seed gives the same front")
      ->capture_default_str();
  command
      ->add_option("-j,--threads", arguments->threads,
                   "Threads to use; the front is the same with any number")
      ->check(CLI::Range(1, 256));
  add_time_limit(*command, arguments->time_limit,
                 "Seconds; then the points found so far, or exit code 6 without any");
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
