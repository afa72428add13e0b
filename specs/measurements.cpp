#include "specs/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "specs/file_kind.hpp"
#include "specs/measurements_table.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/ratio.hpp"

namespace kempe {
namespace {

using Words = std::vector<std::string_view>;

constexpr double farthest_place = 1e5;  // mm

void read_instrument(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("instrument");
  if (!node) return;
  const auto table = MeasurementTable::of(*node, "instrument", {"arm_mm", "ratio", "design"}, complaints);
  if (!table) return;
  if (const auto design = table->text("design")) measurements.design = *design;
  if (!table->has("arm_mm") && !measurements.design.empty()) return;
  VariableRatioSpec instrument;
  instrument.arm =
      table->number("arm_mm", 10, farthest_place, " mm, the length AC = CF (in millimetres, not metres)")
          .value_or(500);
  if (!table->has("arm_mm"))
    table->missing("arm_mm", "the length of the arms AC = CF in mm, or design = \"design.json\"");
  instrument.ratio = table->number("ratio", 0.02, 0.98, ", the setting AB / AC").value_or(0.5);
  measurements.instrument = instrument;
}

void read_design_name(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("design");
  if (!node) return;
  const auto text = node->value<std::string>();
  if (!text || text->empty())
    return complaints.add(line_of(*node), "design", describe(*node), "the name of a design.json");
  measurements.design = *text;
}

void check_what_was_measured(const toml::table& file, const Measurements& measurements,
                             Complaints& complaints) {
  const bool design = !measurements.design.empty(), instrument = measurements.instrument.has_value();
  if (design != instrument) return;
  const toml::node* node = file.get("instrument");
  complaints.add(node ? line_of(*node) : 0, "instrument",
                 design ? "both [instrument] and design" : "neither [instrument] nor design",
                 "one of them: [instrument] with arm_mm for a variable ratio pantograph, design = "
                 "\"design.json\" for any other");
}

// Readings.

void read_arm_angle(const MeasurementTable& table, const Measurements& measurements, ReadingSpec& reading) {
  const auto angle =
      table.number("arm_angle_deg", 0, 90, " degrees, the angle of arm AC to the line from pole to tracer");
  const auto error = table.point("error_mm", farthest_place);
  if (!table.has("error_mm")) table.missing("error_mm", "[x, y] in mm: x toward the tracer, y toward C");
  if (!angle || !error) return;
  constexpr double nearest_end = 5;
  if (*angle < nearest_end || *angle > 90 - nearest_end) {
    const bool looks_like_radians = *angle > 0.08 && *angle < 1.5;
    table.refuse(
        "arm_angle_deg", fmt::format("{}", *angle),
        fmt::format("5 to 85 degrees: next to 0 and 90 the equations lose rank; measure at 30 and 60{}",
                    looks_like_radians ? " (is this in radians?)" : ""));
  }
  const double arm = measurements.instrument ? measurements.instrument->arm : farthest_place;
  if (error->norm() > 0.05 * arm)
    table.refuse(
        "error_mm", fmt::format("a departure of {:.4g} mm", error->norm()),
        fmt::format(
            "a departure in millimetres, less than a twentieth of the arm's {:g} mm: is it in micrometres, "
            "or the place itself?",
            arm));
  reading.arm_angle = radians(*angle);
  reading.error = *error;
}

void read_places(const MeasurementTable& table, ReadingSpec& reading) {
  const auto tracer = table.point("tracer_mm", farthest_place), pen = table.point("pen_mm", farthest_place);
  if (!table.has("tracer_mm")) table.missing("tracer_mm", "[x, y] in mm, or arm_angle_deg and error_mm");
  if (!table.has("pen_mm")) table.missing("pen_mm", "[x, y] in mm");
  reading.tracer = tracer.value_or(Point(0, 0));
  reading.pen = pen.value_or(Point(0, 0));
}

void read_reading(const toml::node& node, Measurements& measurements, Complaints& complaints) {
  static const Words keys{"name",      "round",  "arm_angle_deg", "error_mm",
                          "tracer_mm", "pen_mm", "ratio",         "exchanged"};
  const auto table = MeasurementTable::of(node, "reading", keys, complaints);
  if (!table) return;
  ReadingSpec reading;
  reading.line = line_of(node);
  reading.name = table->text("name").value_or(fmt::format("reading {}", measurements.readings.size() + 1));
  reading.round = table->whole("round", 1, 100).value_or(1);
  reading.exchanged = table->truth("exchanged");
  reading.ratio = table->number("ratio", 0.02, 0.98, ", the setting AB / AC");
  const bool by_angle = table->has("arm_angle_deg") || table->has("error_mm");
  const bool by_place = table->has("tracer_mm") || table->has("pen_mm");
  if (by_angle && by_place)
    return table->refuse("tracer_mm", "both an arm angle or departure and a place",
                         "arm_angle_deg with error_mm, or tracer_mm with pen_mm");
  if (!measurements.instrument && by_angle)
    table->refuse(table->has("arm_angle_deg") ? "arm_angle_deg" : "error_mm",
                  "an arm angle or departure of a design",
                  "tracer_mm and pen_mm; arm angles are for a variable ratio pantograph's [instrument]");
  if (!measurements.instrument && reading.ratio)
    table->refuse("ratio", "a setting of a design", "ratio only with [instrument]");
  if (by_angle) {
    read_arm_angle(*table, measurements, reading);
    if (!table->has("arm_angle_deg")) table->missing("arm_angle_deg", "the angle of arm AC in degrees");
  } else {
    read_places(*table, reading);
  }
  measurements.readings.push_back(reading);
}

void read_readings(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("reading");
  if (!node) return;
  const toml::array* list = node->as_array();
  if (!list)
    return complaints.add(line_of(*node), "reading", describe(*node),
                          "tables [[reading]], with two brackets");
  constexpr std::size_t most = 100'000;
  if (list->size() > most)
    return complaints.add(line_of(*node), "reading", fmt::format("{} readings", list->size()),
                          fmt::format("at most {}", most));
  for (const toml::node& one : *list) read_reading(one, measurements, complaints);
}

void check_rounds(const Measurements& measurements, Complaints& complaints) {
  int last = 0;
  for (const ReadingSpec& reading : measurements.readings) {
    if (reading.round > last + 1)
      complaints.add(reading.line, "reading.round", fmt::format("{}", reading.round),
                     fmt::format("{}: rounds follow each other from 1",
                                 last == 0 ? "1" : fmt::format("{} or {}", last, last + 1)));
    if (reading.round < last)
      complaints.add(reading.line, "reading.round", fmt::format("{} after {}", reading.round, last),
                     "the readings of a round together, the first round first");
    last = std::max(last, reading.round);
  }
}

// The rest of the file.

void read_lengths(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("lengths_mm");
  if (!node) return;
  Words keys = measurable_lengths(measurements.instrument.has_value());
  const Words lengths = keys;
  keys.push_back("uncertainty_mm");
  const auto table = MeasurementTable::of(*node, "lengths_mm", keys, complaints);
  if (!table) return;
  const double uncertainty = table->number("uncertainty_mm", 1e-6, 100, " mm").value_or(0.02);
  for (const std::string_view length : lengths)
    if (const auto value = table->number(length, 0.1, farthest_place, " mm"))
      measurements.lengths.push_back({std::string(length), *value, uncertainty, table->line(length)});
}

void read_fit(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("fit");
  if (!node) return;
  const auto table = MeasurementTable::of(
      *node, "fit",
      {"method", "free", "reading_uncertainty_mm", "tracer_uncertainty_mm", "expected_error_mm",
       "arm_tolerance_percent", "bearing_tolerance_percent", "target_mm", "keep_outliers"},
      complaints);
  if (!table) return;
  FitSpec& fit = measurements.fit;
  if (const auto method = table->word("method", {"knight", "least_squares"}))
    fit.method = *method == "knight" ? CalibrationMethod::knight : CalibrationMethod::least_squares;
  if (fit.method == CalibrationMethod::knight && !measurements.instrument)
    table->refuse("method", "Knight's method for a design",
                  "least_squares; Knight's equations are for [instrument]");
  fit.free = table->words("free", free_groups(measurements.instrument.has_value()));
  fit.reading_uncertainty = table->number("reading_uncertainty_mm", 1e-6, 100, " mm");
  fit.tracer_uncertainty = table->number("tracer_uncertainty_mm", 0, 100, " mm").value_or(0);
  fit.plausible_deviation = table->number("expected_error_mm", 1e-6, 1000, " mm");
  fit.arm_tolerance_percent =
      table->number("arm_tolerance_percent", 0, 10, " per cent of the arm").value_or(0);
  fit.bearing_tolerance_percent =
      table->number("bearing_tolerance_percent", 0, 10, " per cent of the arm").value_or(0);
  fit.target = table->number("target_mm", 1e-6, 1000, " mm").value_or(fit.target);
  fit.keep_outliers = table->truth("keep_outliers");
}

void read_ratios(const MeasurementTable& table, Measurements& measurements) {
  const toml::array* list = table.list("ratios");
  constexpr std::size_t most = 200;
  if (!list) return;
  if (list->size() > most)
    return table.refuse("ratios", fmt::format("{} ratios", list->size()), fmt::format("at most {}", most));
  for (const toml::node& one : *list) {
    const std::string text = one.is_string() ? one.value_or(std::string()) : describe(one);
    const auto value = parse_ratio(text);
    if (!value || *value < 0.01 || *value > 100)
      return table.refuse("ratios", describe(one), "numbers from 0.01 to 100, or text such as \"1:3\"");
    measurements.ratios.push_back({text, *value});
  }
}

void read_use(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("use");
  if (!node) return;
  const auto table = MeasurementTable::of(*node, "use", {"ratios", "arm_angles_deg"}, complaints);
  if (!table) return;
  read_ratios(*table, measurements);
  if (const auto angles = table->point("arm_angles_deg", 90)) {
    if (!(angles->x() >= 5 && angles->x() < angles->y() && angles->y() <= 85))
      return table->refuse("arm_angles_deg", fmt::format("[{}, {}]", angles->x(), angles->y()),
                           "[lower, upper] within 5 to 85 degrees");
    measurements.arm_angles = {radians(angles->x()), radians(angles->y())};
  }
}

void read_plan(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("plan");
  if (!node) return;
  const auto table = MeasurementTable::of(*node, "plan", {"readings", "exchange"}, complaints);
  if (!table) return;
  PlanSpec plan;
  plan.readings = table->whole("readings", 1, 100).value_or(plan.readings);
  if (table->has("exchange")) plan.exchange = table->truth("exchange");
  measurements.plan = plan;
}

void read_hidden_errors(const MeasurementTable& table, const Measurements& measurements,
                        SimulationSpec& simulation, Complaints& complaints) {
  const toml::node* node = table.find("errors_mm");
  if (!node) return;
  const Words& names = error_names(measurements.instrument.has_value());
  const auto errors = MeasurementTable::of(*node, "simulate.errors_mm", names, complaints);
  if (!errors) return;
  for (const std::string_view one : names)
    if (const auto value = errors->number(one, -100, 100, " mm"))
      simulation.errors[std::string(one)] = *value;
}

void read_simulation(const toml::table& file, Measurements& measurements, Complaints& complaints) {
  const toml::node* node = file.get("simulate");
  if (!node) return;
  const auto table = MeasurementTable::of(
      *node, "simulate",
      {"errors_mm", "largest_error_mm", "noise_mm", "resolution_mm", "play_mm", "arm_error_percent",
       "bearing_error_percent", "instruments", "readings", "rounds"},
      complaints);
  if (!table) return;
  SimulationSpec simulation;
  read_hidden_errors(*table, measurements, simulation, complaints);
  simulation.largest_error =
      table->number("largest_error_mm", 0, 100, " mm").value_or(simulation.largest_error);
  simulation.noise = table->number("noise_mm", 0, 10, " mm").value_or(simulation.noise);
  simulation.resolution = table->number("resolution_mm", 0, 10, " mm").value_or(simulation.resolution);
  simulation.play = table->number("play_mm", 0, 10, " mm").value_or(simulation.play);
  simulation.arm_error_percent = table->number("arm_error_percent", 0, 10, "").value_or(0);
  simulation.bearing_error_percent = table->number("bearing_error_percent", 0, 10, "").value_or(0);
  simulation.instruments = table->whole("instruments", 1, 100000).value_or(simulation.instruments);
  simulation.readings = table->whole("readings", 2, 200).value_or(simulation.readings);
  simulation.rounds = table->whole("rounds", 1, 20).value_or(simulation.rounds);
  measurements.simulation = simulation;
}

}  // namespace

std::string_view name(CalibrationMethod method) {
  return method == CalibrationMethod::knight ? "knight" : "least_squares";
}

const std::vector<std::string_view>& free_groups(bool variable_ratio) {
  static const Words of_instrument{"scales", "arms", "bearings", "pole", "frame"};
  static const Words of_design{"lengths", "bearings", "pole", "frame"};
  return variable_ratio ? of_instrument : of_design;
}

const std::vector<std::string_view>& measurable_lengths(bool variable_ratio) {
  static const Words of_instrument{"arm_AC", "arm_CF"};
  static const Words of_design{"VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY"};
  return variable_ratio ? of_instrument : of_design;
}

const std::vector<std::string_view>& error_names(bool variable_ratio) {
  static const Words of_instrument{"AC", "CF", "BE", "DE", "arm_AC", "arm_CF", "bearing_B", "bearing_D"};
  static const Words of_design{"VA", "VB", "AX", "CX", "offset_A", "BC", "CY", "offset_B"};
  return variable_ratio ? of_instrument : of_design;
}

tl::expected<Measurements, InputError> read_measurements(std::string_view text, const std::string& file) {
  const auto parsed = parse_toml(text, file);
  if (!parsed) return tl::unexpected(or_other_kind(parsed.error(), text, FileKind::measurements));
  Complaints complaints(file);
  Measurements measurements;
  check_known_keys(*parsed, "",
                   {"design", "instrument", "reading", "lengths_mm", "fit", "use", "plan", "simulate"},
                   complaints);
  read_design_name(*parsed, measurements, complaints);
  read_instrument(*parsed, measurements, complaints);
  if (complaints.none_about("instrument") && complaints.none_about("design"))
    check_what_was_measured(*parsed, measurements, complaints);
  read_readings(*parsed, measurements, complaints);
  check_rounds(measurements, complaints);
  read_lengths(*parsed, measurements, complaints);
  read_fit(*parsed, measurements, complaints);
  read_use(*parsed, measurements, complaints);
  read_plan(*parsed, measurements, complaints);
  read_simulation(*parsed, measurements, complaints);
  if (!complaints.none())
    return tl::unexpected(or_other_kind(complaints.all(), text, FileKind::measurements));
  return measurements;
}

}  // namespace kempe
