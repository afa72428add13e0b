// kempe solve: any planar linkage moved by its drivers.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/linkage_run.hpp"
#include "app/output_check.hpp"
#include "app/words.hpp"
#include "reports/linkages/forces.hpp"
#include "reports/linkages/loop_equations.hpp"
#include "reports/linkages/solve_table.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

using Json = nlohmann::ordered_json;

struct SolveArguments {
  std::string linkage, table_file;
  std::vector<std::string> animations, angles;
  bool list_assembly_modes = false, velocities = false, accelerations = false;
  int assembly_mode = 0, steps = 0;
  std::optional<double> equations_at;  ///< a step
  std::uint64_t seed = 1;
};

void apply(const SolveArguments& arguments, LinkageFile& file) {
  file.output.velocities |= arguments.velocities;
  file.output.accelerations |= arguments.accelerations;
  for (const std::string& link : arguments.angles)
    if (std::find(file.output.angles.begin(), file.output.angles.end(), link) == file.output.angles.end())
      file.output.angles.push_back(link);
  if (arguments.steps > 0) file.steps = arguments.steps;
}

/// Every link the arguments name must exist.
int check_links(const Session& session, const LoadedLinkage& loaded, const SolveArguments& arguments) {
  for (const std::string& link : arguments.angles)
    if (!loaded.model.bodies.contains(link))
      return fail(session, {"", 0, "--angles", "the link " + link, "a link of " + loaded.file.file});
  return done;
}

/// A row an assembly mode: where the points are.
SolveTable assembly_table(const LoadedLinkage& loaded, const std::vector<PlanarPosition>& found) {
  SolveTable table{{"assembly"}, {ColumnKind::step}, {}};
  for (std::size_t i = 0; i < found.size(); ++i) table.rows.push_back({static_cast<double>(i)});
  for (const ModelPoint& point : loaded.model.points) {
    if (point.place.body == PlanarLinkage::ground) continue;
    for (const int axis : {0, 1}) {
      table.columns.push_back(
          fmt::format("{}_{}_{}", point.name, axis == 0 ? 'x' : 'y', loaded.file.unit.name));
      table.kinds.push_back(ColumnKind::place);
      for (std::size_t i = 0; i < found.size(); ++i)
        table.rows[i].push_back(place(found[i], point.place)[axis] / loaded.file.unit.in_mm);
    }
  }
  return table;
}

Json table_json(const SolveTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json values = Json::array();
    for (const auto& value : row) values.push_back(value ? Json(*value) : Json(nullptr));
    rows.push_back(std::move(values));
  }
  return {{"columns", table.columns}, {"rows", std::move(rows)}};
}

int list_assembly_modes(const Session& session, const LoadedLinkage& loaded,
                        const std::vector<PlanarPosition>& found) {
  const SolveTable table = assembly_table(loaded, found);
  Json object{{"linkage", loaded.file.name}, {"unit", loaded.file.unit.name}, {"assemblies", found.size()}};
  object.update(table_json(table));
  print(session.json ? object.dump() + "\n" : csv_text(table));
  return done;
}

int write_animations(const Session& session, const LoadedLinkage& loaded, const PlanarPosition& start,
                     const std::vector<std::string>& files) {
  const auto run = drive_linkage(session, loaded, start, animated_steps(loaded.file.steps));
  if (!run) return run.error();
  return write_animations(session, linkage_scene(loaded.file, loaded.model, *run, loaded.file.steps), files);
}

int show_equations(const Session& session, const LoadedLinkage& loaded, const PlanarPosition& start,
                   double step) {
  const auto frame = frame_at(session, loaded, start, step, "--equations");
  if (!frame) return frame.error();
  const auto shown = session.json ? loop_equations_json : loop_equations_text;
  print(shown(loaded.file, loaded.model, step, *frame));
  return done;
}

Json summary_json(const LoadedLinkage& loaded, const SolveTable& table, const PlanarRun& run) {
  Json object{{"linkage", loaded.file.name}, {"unit", loaded.file.unit.name}, {"steps", loaded.file.steps}};
  object["stop"] = nullptr;
  if (run.stop)
    object["stop"] = {{"kind", std::string(name(run.stop->end))},
                      {"step", run.frames.back().share * loaded.file.steps},
                      {"sentences", run.stop->sentences}};
  if (!loaded.model.loads.empty())
    object["forces"] = {{"undetermined", undetermined_reactions(loaded.file, loaded.model, table)},
                        {"sentences", force_sentences(loaded.file, loaded.model, table)}};
  object.update(table_json(table));
  return object;
}

/// Where the table is and what its forces come to.
void tell_summary(const SolveArguments& arguments, const LoadedLinkage& loaded, const SolveTable& table) {
  print(fmt::format("{}: {} in {}\n", loaded.file.name, counted(table.rows.size(), "position"),
                    printable(arguments.table_file)));
  for (const std::string& sentence : force_sentences(loaded.file, loaded.model, table))
    print(sentence + "\n");
}

void tell(const Session& session, const SolveArguments& arguments, const LoadedLinkage& loaded,
          const SolveTable& table, const PlanarRun& run) {
  if (session.json)
    print(summary_json(loaded, table, run).dump() + "\n");
  else if (arguments.table_file.empty())
    print(csv_text(table));
  else
    tell_summary(arguments, loaded, table);
}

int run(const Session& session, const SolveArguments& arguments) {
  if (const auto wrong = wrong_animation("--animate", arguments.animations)) return fail(session, *wrong);
  std::vector<std::filesystem::path> outputs{arguments.table_file};
  outputs.insert(outputs.end(), arguments.animations.begin(), arguments.animations.end());
  if (const auto clash = output_clash({arguments.linkage}, outputs)) return fail(session, *clash);
  auto loaded = load_linkage(session, arguments.linkage);
  if (!loaded) return loaded.error();
  if (const int code = check_links(session, *loaded, arguments); code != done) return code;
  if (arguments.steps > loaded->file.most_steps())
    return fail(session, {"", 0, "--steps", fmt::format("{}", arguments.steps),
                          fmt::format("at most {} with so many links", loaded->file.most_steps())});
  apply(arguments, loaded->file);
  const auto assembly_modes = assemble_linkage(session, *loaded, arguments.seed);
  if (!assembly_modes) return assembly_modes.error();
  if (arguments.list_assembly_modes) return list_assembly_modes(session, *loaded, *assembly_modes);
  if (arguments.assembly_mode >= static_cast<int>(assembly_modes->size()))
    return fail(session,
                {"", 0, "--assembly", fmt::format("{}", arguments.assembly_mode),
                 fmt::format("0 to {}: so many are known (see --assemblies)", assembly_modes->size() - 1)});
  const PlanarPosition& start = (*assembly_modes)[static_cast<std::size_t>(arguments.assembly_mode)];
  if (arguments.equations_at) return show_equations(session, *loaded, start, *arguments.equations_at);
  const auto motion = drive_linkage(session, *loaded, start, loaded->file.steps);
  if (!motion) return motion.error();
  const SolveTable table = solve_table(loaded->file, loaded->model, *motion, loaded->file.steps);
  if (!arguments.table_file.empty())
    if (const int code = write_output(session, arguments.table_file, csv_text(table)); code != done)
      return code;
  if (!arguments.animations.empty())
    if (const int code = write_animations(session, *loaded, start, arguments.animations); code != done)
      return code;
  tell(session, arguments, *loaded, table, *motion);
  if (!motion->stop) return done;
  return fail_told(code_of(*motion),
                   printable(arguments.linkage) + ": " + stop_sentence(*loaded, *motion, loaded->file.steps));
}

}  // namespace

void add_solve_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "solve", "Move any planar linkage: positions, velocities, accelerations",
                  "kempe solve specs/examples/linkages/shear-press.toml -o press.csv --animate press.html");
  auto arguments = std::make_shared<SolveArguments>();
  add_linkage_argument(*command, arguments->linkage)->required();
  command->add_option("-o,--output", arguments->table_file, "Table of positions (CSV); left out: on stdout");
  command->add_option("--animate", arguments->animations,
                      "The linkage moving: FILE.html or FILE.svg; may be given twice");
  command->add_flag("--assemblies", arguments->list_assembly_modes,
                    "List the assembly modes at the start of the motion, then stop");
  command->add_option("--assembly", arguments->assembly_mode, "Start in this one of them (see --assemblies)")
      ->check(CLI::Range(0, 1000));
  command->add_option(
      "--equations", arguments->equations_at,
      "Write out the loop equations at this step with their numbers and derivatives, then stop");
  command->add_flag("--velocities", arguments->velocities, "Velocities of points and links");
  command->add_flag("--accelerations", arguments->accelerations, "Accelerations of points and links");
  command
      ->add_option("--angles", arguments->angles,
                   "Links whose angles are added to the table, besides the file's")
      ->delimiter(',');
  command->add_option("--steps", arguments->steps, "Equal parts of the motion, instead of the file's")
      ->check(CLI::Range(1, 1000000));
  add_seed_option(*command, arguments->seed, "Seed of the random numbers in the search for assembly modes")
      ->capture_default_str();
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
