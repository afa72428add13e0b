// kempe calibrate: what is wrong with a real instrument, from what it drew.

#include <filesystem>
#include <memory>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/output_check.hpp"
#include "app/progress.hpp"
#include "reports/calibration/choices.hpp"
#include "reports/calibration/knight_equations.hpp"
#include "reports/calibration/named_design.hpp"
#include "reports/calibration/report.hpp"
#include "reports/data/atomic_file.hpp"

namespace kempe::app {
namespace {

struct CalibrateArguments {
  std::string file, folder, method;
  CalibrationChoices choices;
  std::uint64_t seed = 1;
  bool equations = false;
};

int write_report(const Session& session, const CalibrateArguments& arguments, const CalibrationRecord& record,
                 const std::optional<SimulationRecord>& simulation, const std::string& json,
                 const std::string& text, const std::string& design) {
  std::vector<OutputFile> files{{"calibration.json", json}};
  const CalibrationPage page{KEMPE_VERSION, std::filesystem::path(arguments.file).filename().string(), text};
  files.push_back({"report.html", calibration_html(record, simulation, page)});
  if (simulation) files.push_back({"simulated.toml", simulated_measurements(record, *simulation)});
  std::vector<std::string> names;
  for (const OutputFile& file : files) names.push_back(file.name.string());
  std::vector<std::filesystem::path> inputs{arguments.file};
  if (!design.empty()) inputs.push_back(std::filesystem::path(arguments.file).parent_path() / design);
  if (const auto clash = output_clash(inputs, arguments.folder, names)) return fail(session, *clash);
  const auto written = write_whole(std::filesystem::path(arguments.folder), files);
  return written ? done : fail(session, cannot_write, written.error());
}

int run(const Session& session, CalibrateArguments arguments) {
  if (arguments.method == "knight") arguments.choices.method = CalibrationMethod::knight;
  if (arguments.method == "least_squares") arguments.choices.method = CalibrationMethod::least_squares;
  const auto text = input_text(session, arguments.file);
  if (!text) return fail(session, text.error());
  auto read = read_measurements(*text, arguments.file);
  if (!read) return fail(session, read.error());
  const auto measurements = with_choices(std::move(*read), arguments.choices, "--");
  if (!measurements) return fail(session, measurements.error());
  const auto design = named_design(*measurements, std::filesystem::path(arguments.file).parent_path());
  if (!design) return fail(session, design.error());
  const auto record = run_calibration(*measurements, *design, arguments.file);
  if (!record) return fail(session, record.error());
  if (arguments.equations && !has_knight_equations(*record))
    return fail(session, no_knight_equations(*record, "--equations"));
  std::optional<SimulationRecord> simulation;
  if (measurements->simulation) {
    const Interrupt interrupt;
    Progress progress(session.quiet);
    simulation = simulate_calibration(
        *measurements, *design, arguments.seed, [&](double share) { progress.show(share, "simulating"); },
        interrupt.requested());
    if (!simulation) return fail(session, interrupted, "stopped; nothing is written");
  }
  const std::string json = calibration_json(*record, simulation, arguments.equations);
  if (!arguments.folder.empty())
    if (const int code =
            write_report(session, arguments, *record, simulation, json, *text, measurements->design);
        code != done)
      return code;
  answer(session, calibration_text(*record, simulation, arguments.equations), json);
  return done;
}

}  // namespace

void add_calibrate_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "calibrate",
                                  "Find what is wrong with a real instrument from what it drew",
                                  "kempe calibrate specs/examples/calibration/knight.toml");
  auto arguments = std::make_shared<CalibrateArguments>();
  command
      ->add_option("MEASUREMENTS", arguments->file, "Instrument and readings (TOML; see docs/calibration.md)")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "Write calibration.json and report.html into this folder");
  command->add_option("--target-mm", arguments->choices.target, "Copy error that is good enough, mm")
      ->check(number_between(1e-6, 1000));
  command
      ->add_option("--method", arguments->method,
                   "knight or least_squares; left out: knight for two readings a round, else least_squares")
      ->check(CLI::IsMember({"knight", "least_squares"}));
  command->add_flag("--equations", arguments->equations,
                    "Write out Knight's equations of the last round, and their matrix, with their numbers");
  command
      ->add_option("--ratios", arguments->choices.ratios,
                   "Setting table for these ratios, such as 1:2,1:3,0.4")
      ->delimiter(',');
  command->add_flag("--plan", arguments->choices.plan,
                    "Propose the readings that determine most (D-optimal)");
  command
      ->add_option("--plan-readings", arguments->choices.plan_readings, "How many readings --plan proposes")
      ->check(CLI::Range(1, 100));
  command->add_flag("--simulate", arguments->choices.simulate,
                    "Simulate instruments with hidden errors ([simulate])");
  add_seed_option(*command, arguments->seed, "Seed of the random numbers of the simulation");
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
