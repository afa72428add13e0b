// kempe/calibrate.hpp.

#include "kempe/calibrate.hpp"

#include <fmt/format.h>

#include <atomic>
#include <optional>

#include "reports/calibration/choices.hpp"
#include "reports/calibration/knight_equations.hpp"
#include "reports/calibration/named_design.hpp"
#include "reports/calibration/report.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

std::optional<InputError> fault_in(const CalibrationOptions& options) {
  if (options.target && !(*options.target >= 1e-6 && *options.target <= 1000))
    return InputError{"", 0, "target_mm", fmt::format("{}", *options.target), "1e-6 to 1000 mm"};
  if (!options.method.empty() && options.method != "knight" && options.method != "least_squares")
    return InputError{"", 0, "method", options.method, "knight or least_squares"};
  if (options.plan_readings && (*options.plan_readings < 1 || *options.plan_readings > 100))
    return InputError{"", 0, "plan_readings", fmt::format("{}", *options.plan_readings), "1 to 100"};
  return std::nullopt;
}

CalibrationChoices choices_of(const CalibrationOptions& options) {
  CalibrationChoices choices;
  choices.target = options.target;
  if (options.method == "knight") choices.method = CalibrationMethod::knight;
  if (options.method == "least_squares") choices.method = CalibrationMethod::least_squares;
  choices.ratios = options.ratios;
  choices.plan = options.plan;
  choices.plan_readings = options.plan_readings;
  choices.simulate = options.simulate;
  return choices;
}

}  // namespace

std::variant<CalibratedInstrument, InputError> calibrate_with(const CalibrationOptions& options,
                                                              std::string_view text, const std::string& name,
                                                              const std::filesystem::path& folder) {
  if (const auto fault = fault_in(options)) return *fault;
  auto read = read_measurements(text, name);
  if (!read) return read.error();
  const auto measurements = with_choices(std::move(*read), choices_of(options), "");
  if (!measurements) return measurements.error();
  const auto design = named_design(*measurements, folder);
  if (!design) return design.error();
  const auto record = run_calibration(*measurements, *design, name);
  if (!record) return record.error();
  if (options.equations && !has_knight_equations(*record)) return no_knight_equations(*record, "equations");
  std::optional<SimulationRecord> simulation;
  std::atomic<bool> stopped = false;
  const auto look = [&](double) {
    if (options.stop && options.stop()) stopped = true;
  };
  if (measurements->simulation)
    simulation = simulate_calibration(*measurements, *design, options.seed, look, stopped);
  const CalibrationPage page{KEMPE_VERSION, std::filesystem::path(name).filename().string(),
                             std::string(text)};
  return CalibratedInstrument{calibration_json(*record, simulation, options.equations),
                              calibration_text(*record, simulation, options.equations),
                              calibration_html(*record, simulation, page),
                              simulation ? simulated_measurements(*record, *simulation) : ""};
}

std::variant<std::string, InputError> calibrate_text(std::string_view measurements, const std::string& name,
                                                     const std::filesystem::path& folder) {
  auto read = read_measurements(measurements, name);
  if (!read) return read.error();
  read->simulation.reset();
  const auto design = named_design(*read, folder);
  if (!design) return design.error();
  const auto record = run_calibration(*read, *design, name);
  if (!record) return record.error();
  return calibration_json(*record, std::nullopt);
}

std::variant<std::string, InputError> calibrate(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return calibrate_text(*text, file.string(), file.parent_path());
}

std::variant<CalibratedInstrument, InputError> calibrate_file_with(const CalibrationOptions& options,
                                                                   const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return calibrate_with(options, *text, file.string(), file.parent_path());
}

}  // namespace kempe
