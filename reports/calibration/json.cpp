// The calibration's JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/calibration/knight_equations.hpp"
#include "reports/calibration/report.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

/// To 12 decimals: beyond them stands rounding.
Json number(double value) {
  constexpr double decimals = 1e12;
  const double rounded = std::abs(value) < 1e3 ? std::round(value * decimals) / decimals : value;
  return std::isfinite(value) ? Json(rounded + 0.0) : Json(nullptr);
}
/// Degrees as a person would have written them.
Json angle(double value) { return number(std::round(degrees(value) * 1e9) / 1e9); }
Json point(const Point& at) { return {number(at.x()), number(at.y())}; }

/// Scales and lengths, mm; the placement has an object of its own because its turn is an angle.
template <class Value>
Json by_name(const std::vector<Quantity>& quantities, Value value) {
  Json object = Json::object();
  for (const Quantity& quantity : quantities)
    if (quantity.kind != Quantity::Kind::placement) object[quantity.name] = value(quantity);
  return object;
}

Json errors(const std::vector<Quantity>& quantities) {
  return by_name(quantities, [](const Quantity& one) { return number(one.error); });
}
/// Of a variable ratio instrument only the scales can be set.
Json corrections(const CalibrationRecord& record, const RoundRecord& round) {
  Json object = Json::object();
  for (const Quantity& one : round.quantities)
    if (one.kind == Quantity::Kind::scale || (record.design && one.kind == Quantity::Kind::length))
      object[one.name] = number(correction_of(record, round, one));
  return object;
}
Json uncertainties(const std::vector<Quantity>& quantities, double factor) {
  return by_name(quantities, [&](const Quantity& one) {
    return one.determined ? number(factor * one.uncertainty) : Json(nullptr);
  });
}

Json placement(const std::vector<Quantity>& quantities) {
  Json object = Json::object();
  for (const Quantity& one : quantities) {
    if (one.kind != Quantity::Kind::placement) continue;
    const bool is_angle = one.name == "turn";
    const double factor = is_angle ? degrees(1) : 1;
    object[one.name + (is_angle ? "_deg" : "_mm")] = {
        {"value", number(factor * (one.drawn + one.error))},
        {"error", number(factor * one.error)},
        {"uncertainty", one.determined ? number(factor * one.uncertainty) : Json(nullptr)}};
  }
  return object;
}

Json instrument(const CalibrationRecord& record) {
  if (!record.design)
    return {{"kind", "variable ratio pantograph"},
            {"arm_mm", record.measurements.instrument->arm},
            {"ratio", record.measurements.instrument->ratio}};
  return {{"kind", "design"},
          {"design", record.measurements.design},
          {"vertex", std::string(name(record.design->linkage.grounding()))},
          {"scale", std::abs(record.design->linkage.k())},
          {"rotation_deg", degrees(std::arg(record.design->linkage.k()))}};
}

/// By how much to shift each index so that its scale reads right once all corrections are set.
Json index_offsets(const CalibrationRecord& record) {
  Json object = Json::object();
  for (const Quantity& one : record.total) {
    if (one.kind != Quantity::Kind::scale) continue;
    double offset = 0;
    for (const RoundRecord& round : record.rounds) offset -= correction_of(record, round, one);
    object[one.name] = number(offset);
  }
  return object;
}

Json rounds(const CalibrationRecord& record) {
  Json list = Json::array();
  for (const RoundRecord& round : record.rounds)
    list.push_back({{"round", round.round},
                    {"readings", round.readings.size()},
                    {"largest_departure_mm", number(round.departure_largest)},
                    {"errors_mm", errors(round.quantities)},
                    {"corrections_mm", corrections(record, round)},
                    {"residual_mm", number(round.residual)}});
  return list;
}

Json correlations(const CalibrationRecord& record) {
  Json names = Json::array(), rows = Json::array();
  for (const Quantity& one : record.total) names.push_back(one.name);
  for (Eigen::Index i = 0; i < record.correlations.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < record.correlations.cols(); ++j)
      row.push_back(number(record.correlations(i, j)));
    rows.push_back(row);
  }
  return {{"names", names}, {"matrix", rows}};
}

Json unidentifiable(const CalibrationRecord& record) {
  Json list = Json::array();
  for (const UndeterminedCombination& told : record.indistinct) {
    Json combination = Json::object(), remedies = Json::array();
    for (const auto& [measure, factor] : told.combination.parts)
      combination[spoken_name(measure, !record.design)] = number(factor);
    for (const Remedy& remedy : told.remedies)
      remedies.push_back({{"measure", remedy.words}, {"then_known_to_mm", number(remedy.uncertainty)}});
    list.push_back({{"combination", combination},
                    {"in_words", told.words},
                    {"held_as_drawn", spoken_name(told.combination.parts.front().measure, !record.design)},
                    {"known_to_mm",
                     told.combination.uncertainty ? number(*told.combination.uncertainty) : Json(nullptr)},
                    {"what_would_tell", remedies}});
  }
  return list;
}

Json readings(const CalibrationRecord& record) {
  Json list = Json::array();
  for (const ReadingRecord& one : record.readings) {
    const ReadingSpec& spec = record.measurements.readings[one.reading];
    Json row{{"name", spec.name}, {"line", spec.line}};
    if (spec.arm_angle) row["arm_angle_deg"] = angle(*spec.arm_angle);
    row["set_mm"] = point(one.input);
    row["wanted_mm"] = point(one.wanted);
    row["departure_mm"] = point(one.fit.departure);
    row["left_mm"] = point(one.fit.left);
    row["studentised"] = number(one.fit.studentised);
    row["leverage"] = number(one.fit.leverage);
    row["outlier"] = one.fit.outlier;
    list.push_back(row);
  }
  return list;
}

Json outliers(const CalibrationRecord& record) {
  Json list = Json::array();
  for (const ReadingRecord& one : record.readings)
    if (one.fit.outlier) {
      const ReadingSpec& spec = record.measurements.readings[one.reading];
      list.push_back({{"name", spec.name},
                      {"line", spec.line},
                      {"left_mm", number(one.fit.left.norm())},
                      {"studentised", number(one.fit.studentised)},
                      {"left_out", !record.measurements.fit.keep_outliers}});
    }
  return list;
}

bool names_outliers(const CalibrationRecord& record) {
  return std::any_of(record.readings.begin(), record.readings.end(),
                     [](const ReadingRecord& one) { return one.fit.outlier; });
}

Json fit_check(const CalibrationRecord& record) {
  const auto& check = record.calibration.check;
  if (!check) return nullptr;
  return {{"chi_squared", number(check->chi_squared)},
          {"degrees_of_freedom", check->freedom},
          {"by_chance", check->probability},
          {"contradicts_stated_uncertainty", check->contradicts()},
          {"in_words", words_of(*check, names_outliers(record))}};
}

Json scales_json(const ScaleErrors& scales) {
  return {{"AC", number(scales.AC)},
          {"CF", number(scales.CF)},
          {"BE", number(scales.BE)},
          {"DE", number(scales.DE)}};
}

/// Knight's letter of a joint: X is his pole bearing A, Y his tracer F, V his pen E.
std::string knights_letter(Joint joint) { return joint == Joint::X ? "A" : joint == Joint::Y ? "F" : "E"; }

Json settings(const CalibrationRecord& record) {
  Json list = Json::array();
  for (const SettingRow& row : record.settings) {
    Json one{{"ratio", row.ratio},
             {"image", row.reversed ? "reversed" : "erect"},
             {"pole_at", knights_letter(row.pole)},
             {"stylus_at", knights_letter(row.tracer)},
             {"pencil_at", knights_letter(row.pen)},
             {"setting", number(row.setting)}};
    if (!row.impossible.empty()) {
      one["impossible"] = row.impossible;
    } else {
      one["set_mm"] = scales_json(row.scales);
      one["corrections_mm"] = scales_json(row.corrections);
      one["error_uncorrected_mm"] = number(row.before);
      one["error_systematic_mm"] = number(row.remaining);
      one["predicted_error_mm"] = number(row.predicted);
    }
    list.push_back(one);
  }
  return list;
}

Json plan(const PlanRecord& plan) {
  Json list = Json::array();
  for (const PlannedReading& one : plan.readings) {
    Json row = Json::object();
    if (one.arm_angle) row["arm_angle_deg"] = angle(*one.arm_angle);
    row["tracer_mm"] = point(one.input);
    row["expected_mm"] = point(one.wanted);
    row["exchanged"] = one.exchanged;
    list.push_back(row);
  }
  return {{"readings", list},
          {"uncertainty_mm", uncertainties(plan.quantities, 1)},
          {"gain_over_evenly_spread", number(plan.gain)}};
}

Json simulation_json(const SimulationRecord& simulation) {
  Json list = Json::array();
  for (std::size_t i = 0; i < simulation.rounds.size(); ++i) {
    const SimulatedRound& round = simulation.rounds[i];
    list.push_back({{"round", i + 1},
                    {"residual_mean_mm", number(round.residual_mean)},
                    {"residual_largest_mm", number(round.residual_largest)},
                    {"share_within_target", number(round.reached)},
                    {"coverage_95", number(round.coverage)}});
  }
  return {{"instruments", simulation.instruments},
          {"method", std::string(name(simulation.method))},
          {"readings_a_round", simulation.readings},
          {"departure_mean_mm", number(simulation.departure_mean)},
          {"departure_largest_mm", number(simulation.departure_largest)},
          {"rounds", list},
          {"not_calibrated", simulation.failed},
          {"hidden_errors_of_first_mm", errors(simulation.hidden)}};
}

void put_calibration(const CalibrationRecord& record, Json& object) {
  const Calibration& found = record.calibration;
  const std::vector<Quantity>& last = record.rounds.back().quantities;
  object["errors_mm"] = errors(last);
  object["corrections_mm"] = corrections(record, record.rounds.back());
  object["uncertainty_mm"] = uncertainties(last, 1);
  object["interval_95_mm"] = uncertainties(last, found.coverage_factor);
  if (!record.indistinct.empty())
    object["uncertainty_if_held_mm"] =
        by_name(last, [](const Quantity& one) { return number(one.uncertainty); });
  if (record.design)
    object["lengths_mm"] = by_name(last, [](const Quantity& one) { return number(one.drawn + one.error); });
  if (!record.design) object["index_offsets_mm"] = index_offsets(record);
  if (record.rounds.size() > 1) object["total_errors_mm"] = errors(record.total);
  const Json place = placement(last);
  if (!place.empty()) object["placement"] = place;
  object["largest_departure_mm"] = number(record.rounds.back().departure_largest);
  object["residual_mm"] = number(record.rounds.back().residual);
  object["residual_rms_mm"] = number(found.left_rms);
  object["target_mm"] = record.measurements.fit.target;
  object["target_reached"] = record.reached;
  object["reading_uncertainty_mm"] = number(found.noise);
  object["reading_uncertainty_source"] = std::string(name(found.noise_source));
  object["degrees_of_freedom"] = found.degrees_of_freedom;
  object["unidentifiable"] = unidentifiable(record);
  object["residuals_against_stated"] = fit_check(record);
  object["outliers"] = outliers(record);
  if (!record.otherwise.empty())
    object[record.measurements.fit.keep_outliers ? "errors_without_outliers_mm" : "errors_with_outliers_mm"] =
        errors(record.otherwise);
  object["rounds"] = rounds(record);
  object["readings"] = readings(record);
  object["correlations"] = correlations(record);
}

}  // namespace

std::string calibration_json(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, bool equations) {
  Json object{{"format", "kempe-calibration/1"},
              {"method", std::string(name(record.method))},
              {"instrument", instrument(record)}};
  if (!record.rounds.empty()) put_calibration(record, object);
  if (equations) object["equations"] = knight_equations_json(record);
  if (!record.settings.empty()) object["settings"] = settings(record);
  if (record.plan) object["plan"] = plan(*record.plan);
  if (simulation) object["simulation"] = simulation_json(*simulation);
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string simulated_measurements(const CalibrationRecord& record, const SimulationRecord& simulation) {
  const Measurements& spec = record.measurements;
  std::string text = "# Readings of a simulated instrument with hidden errors.\n";
  if (spec.instrument) {
    text +=
        fmt::format("[instrument]\narm_mm = {}\nratio = {}\n", spec.instrument->arm, spec.instrument->ratio);
  } else {
    text += fmt::format("design = {}\n", Json(spec.design).dump());
  }
  for (const ReadingSpec& reading : simulation.readings_of_first) {
    text += "\n[[reading]]\n";
    if (reading.round > 1) text += fmt::format("round = {}\n", reading.round);
    if (reading.arm_angle)
      text += fmt::format("arm_angle_deg = {:.6g}\nerror_mm = [{:.6g}, {:.6g}]\n",
                          degrees(*reading.arm_angle), reading.error.x(), reading.error.y());
    else
      text += fmt::format("tracer_mm = [{:.10g}, {:.10g}]\npen_mm = [{:.10g}, {:.10g}]\n", reading.tracer.x(),
                          reading.tracer.y(), reading.pen.x(), reading.pen.y());
  }
  return text;
}

}  // namespace kempe
