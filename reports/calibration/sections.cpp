#include "reports/calibration/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/page/charts.hpp"
#include "reports/page/html_table.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe::calibration_sections {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Three decimals throughout, so that figures stand under each other.
std::string fixed(double value, bool with_plus = false) {
  const std::string digits = fmt::format("{:.3f}", std::abs(value));
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (zero ? "" : value < 0 ? "\u2212" : with_plus ? "+" : "") + digits;
}
std::string signed_mm(double value) { return fixed(value, true) + "\u00a0mm"; }
std::string plus_minus(double value) { return "±\u202f" + fixed_mm(value); }
std::string degrees_text(double angle) { return angle_text(angle, 1); }
std::string point_text(const Point& at) { return fixed(at.x()) + ", " + fixed(at.y()); }

/// "arm AC" for the file's key arm_AC.
std::string spoken(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return html_escaped(key);
}

/// "CX and CY": what was held as drawn.
std::string held_names(const CalibrationRecord& record) {
  std::string names;
  for (std::size_t i = 0; i < record.indistinct.size(); ++i)
    names += (i == 0                              ? ""
              : i + 1 == record.indistinct.size() ? " and "
                                                  : ", ") +
             spoken_name(record.indistinct[i].combination.parts.front().measure, !record.design);
  return names;
}

std::vector<std::string> correction_row(const CalibrationRecord& record, const Quantity& one) {
  const double correction = correction_of(record, record.rounds.back(), one);
  const bool is_scale = one.kind == Quantity::Kind::scale, is_held = !one.determined && one.uncertainty == 0;
  const std::string interval = is_held ? "held"
                                       : plus_minus(record.calibration.coverage_factor * one.uncertainty) +
                                             (one.determined ? "" : "\u202f*");
  const bool settable = is_scale || record.design;
  return {spoken(one.name),
          fixed_mm(one.drawn + (is_scale ? 0 : one.error)),
          signed_mm(one.error),
          interval,
          settable ? signed_mm(correction) : "–",
          settable ? move_words(one, correction) : move_words(one, 1)};
}

std::string knights_letter(Joint joint) { return joint == Joint::X ? "A" : joint == Joint::Y ? "F" : "E"; }

}  // namespace

std::string move_words(const Quantity& quantity, double correction) {
  const std::string& name = quantity.name;
  const bool more = correction > 0;
  if (std::abs(correction) < 5e-4) return "as drawn";
  if (quantity.kind == Quantity::Kind::length && !name.starts_with("offset") && !name.starts_with("arm") &&
      !name.starts_with("bearing"))
    return more ? "make it longer" : "make it shorter";
  if (name == "AC") return more ? "B farther from A" : "B nearer to A";
  if (name == "CF") return more ? "D farther from C" : "D nearer to C";
  if (name == "BE") return more ? "B farther from E" : "B nearer to E";
  if (name == "DE")
    return more ? "D nearer to E (the scale of DE counts backwards)"
                : "D farther from E (the scale of DE counts backwards)";
  if (name.starts_with("arm") || name.starts_with("bearing"))
    return "not set by a scale: see the setting table";
  if (name.starts_with("offset")) return fmt::format("move {} across its plate", name.back());
  return more ? "make it longer" : "make it shorter";
}

std::string fixed_mm(double value) { return fixed(value) + "\u00a0mm"; }

std::string corrections(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  Rows rows;
  for (const Quantity& one : record.rounds.back().quantities)
    if (one.kind != Quantity::Kind::placement) rows.push_back(correction_row(record, one));
  std::string html = html_table("corrections",
                                {{"", false},
                                 {record.design ? "Made" : "Scale or arm", true},
                                 {"Error", true},
                                 {"95\u202f%", true},
                                 {"Correction", true},
                                 {"That is", false}},
                                rows);
  if (!record.indistinct.empty() && !html.empty())
    html += fmt::format("<p class=\"note\">* if {} as drawn; see below.</p>\n",
                        html_escaped(held_names(record) + (record.indistinct.size() > 1 ? " are" : " is")));
  return html_section("corrections", "What is wrong and what to set", html);
}

std::string placement(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  Rows rows;
  for (const Quantity& one : record.rounds.back().quantities) {
    if (one.kind != Quantity::Kind::placement) continue;
    const bool turn = one.name == "turn";
    const double half = record.calibration.coverage_factor * one.uncertainty;
    rows.push_back(
        {spoken(one.name), turn ? angle_text(one.drawn + one.error, 4) : fixed_mm(one.drawn + one.error),
         one.determined ? (turn ? "±\u202f" + angle_text(half, 4) : plus_minus(half)) : "cannot be told"});
  }
  return rows.empty()
             ? std::string()
             : html_section("placement", "Where it stands",
                            html_table("explained", {{"", false}, {"Found", true}, {"95 %", true}}, rows));
}

std::string unidentifiable(const CalibrationRecord& record) {
  std::string html;
  for (const UndeterminedCombination& told : record.indistinct) {
    std::string remedies;
    for (const Remedy& remedy : told.remedies)
      remedies += fmt::format("<li>{} (then known to {})</li>\n", html_escaped(remedy.words),
                              plus_minus(remedy.uncertainty));
    html += fmt::format(
        "<div><p><b>{}</b> changes nothing that was read{}. It was held as drawn.</p><p class=\"note\">Any "
        "of these would determine it:</p><ul class=\"note\">\n{}</ul></div>\n",
        html_escaped(told.words),
        told.combination.uncertainty
            ? " beyond its uncertainty: it is known to " + plus_minus(*told.combination.uncertainty) + " only"
            : "",
        remedies);
  }
  if (html.empty()) return {};
  return html_section("unidentifiable", "What the readings do not determine",
                      "<p class=\"lead\">The corrections still make the copy right; only these measures stay "
                      "unknown.</p>\n<div class=\"columns\">" +
                          html + "</div>\n");
}

std::string readings(const CalibrationRecord& record) {
  double largest = 0;
  for (const ReadingRecord& one : record.readings) largest = std::max(largest, one.fit.studentised);
  Rows rows;
  for (const ReadingRecord& one : record.readings) {
    const ReadingSpec& spec = record.measurements.readings[one.reading];
    const std::string place = spec.arm_angle
                                  ? degrees_text(*spec.arm_angle) + (spec.exchanged ? ", exchanged" : "")
                                  : point_text(one.input);
    std::string label = html_escaped(spec.name) + fmt::format(" <small>line {}</small>", spec.line);
    if (one.fit.outlier)
      label += record.measurements.fit.keep_outliers ? " <b class=\"bad\">stands out</b>"
                                                     : " <b class=\"bad\">outlier, left out</b>";
    rows.push_back({label, place, point_text(one.fit.departure), point_text(one.fit.left),
                    fixed_mm(one.fit.left.norm()),
                    one.fit.studentised > 0 ? number_text(one.fit.studentised, 1) : "–",
                    share_bar(largest > 0 ? one.fit.studentised / largest : 0)});
  }
  const bool names_any = std::any_of(record.readings.begin(), record.readings.end(),
                                     [](const ReadingRecord& one) { return one.fit.outlier; });
  std::string words;
  if (record.calibration.check)
    words =
        fmt::format("<p class=\"lead\">Chi-squared {} for {} degrees of freedom: {}.</p>\n",
                    number_text(record.calibration.check->chi_squared, 1), record.calibration.check->freedom,
                    html_escaped(words_of(*record.calibration.check, names_any)));
  if (!record.otherwise.empty()) {
    std::string errors;
    for (const Quantity& one : record.otherwise)
      if (one.kind != Quantity::Kind::placement)
        errors += fmt::format("{}{} {}", errors.empty() ? "" : ", ", spoken(one.name), signed_mm(one.error));
    words += fmt::format("<p class=\"note\">With the outliers {} the errors would be: {}.</p>\n",
                         record.measurements.fit.keep_outliers ? "left out" : "kept", errors);
  }
  return html_section("readings", "Readings",
                      words + html_table("budget",
                                         {{"", false},
                                          {record.design ? "Set at, mm" : "Arm angle", true},
                                          {"Departure x, y, mm", true},
                                          {"Left x, y, mm", true},
                                          {"Left", true},
                                          {"In units of its uncertainty", true},
                                          {"", false}},
                                         rows));
}

std::string rounds(const CalibrationRecord& record) {
  if (record.rounds.size() < 2) return {};
  Rows rows;
  for (const RoundRecord& round : record.rounds) {
    std::vector<std::string> row{std::to_string(round.round), fixed_mm(round.departure_largest)};
    for (const Quantity& one : round.quantities)
      if (one.kind != Quantity::Kind::placement) row.push_back(signed_mm(correction_of(record, round, one)));
    rows.push_back(row);
  }
  std::vector<HtmlColumn> columns{{"Round", false}, {"Largest departure", true}};
  for (const Quantity& one : record.rounds.front().quantities)
    if (one.kind != Quantity::Kind::placement) columns.push_back({"Correction " + spoken(one.name), true});
  return html_section("rounds", "Rounds", html_table("pareto", columns, rows));
}

std::string settings(const CalibrationRecord& record) {
  Rows rows;
  for (const SettingRow& row : record.settings) {
    std::vector<std::string> cells{
        html_escaped(row.ratio) + (row.reversed ? " <small>reversed</small>" : " <small>erect</small>"),
        fmt::format("{}, {}, {}", knights_letter(row.pole), knights_letter(row.tracer),
                    knights_letter(row.pen)),
        number_text(row.setting, 5)};
    if (row.impossible.empty()) {
      for (const double value : row.scales.values()) cells.push_back(fixed(value));
      cells.push_back(fixed_mm(row.before));
      cells.push_back(fixed_mm(row.predicted));
    } else {
      cells.insert(cells.end(), {"–", "–", "–", "–", "–", html_escaped(row.impossible)});
    }
    rows.push_back(cells);
  }
  if (rows.empty()) return {};
  const std::string words = fmt::format(
      "<p class=\"lead\">What to set on each scale, in mm, for the ratios wanted; largest departure over arm "
      "angles from {} to {}. "
      "A scale’s error is assumed to be the same along the whole scale (Knight).</p>\n",
      degrees_text(record.measurements.arm_angles.lower), degrees_text(record.measurements.arm_angles.upper));
  return html_section("settings", "Setting table",
                      words + html_table("pareto",
                                         {{"Ratio", false},
                                          {"Pole, tracer, pen at", false},
                                          {"Setting", true},
                                          {"AC", true},
                                          {"CF", true},
                                          {"BE", true},
                                          {"DE", true},
                                          {"Error if not corrected", true},
                                          {"Predicted error", true}},
                                         rows));
}

std::string plan(const CalibrationRecord& record) {
  if (!record.plan) return {};
  Rows rows;
  for (const PlannedReading& one : record.plan->readings)
    rows.push_back({std::to_string(rows.size() + 1), one.arm_angle ? degrees_text(*one.arm_angle) : "–",
                    point_text(one.input), point_text(one.wanted), one.exchanged ? "exchanged" : "as usual"});
  Rows uncertainties;
  for (const Quantity& one : record.plan->quantities)
    uncertainties.push_back({spoken(one.name), one.name == "turn" ? "±\u202f" + angle_text(one.uncertainty, 4)
                                                                  : plus_minus(one.uncertainty)});
  const std::string words = fmt::format(
      "<p class=\"lead\">These places determine the measures best (D-optimal): on average {} times as "
      "precisely as the same number spread evenly.{}</p>\n",
      number_text(record.plan->gain, 2),
      std::any_of(record.plan->readings.begin(), record.plan->readings.end(),
                  [](const PlannedReading& one) { return one.exchanged; })
          ? " Exchanged: tracer and pen change places, so that errors appear enlarged."
          : "");
  return html_section("plan", "Where to measure",
                      words + "<div class=\"columns\"><div>" +
                          html_table("pareto",
                                     {{"", false},
                                      {"Arm angle", true},
                                      {"Set at, mm", true},
                                      {"Should read, mm", true},
                                      {"Mounted", false}},
                                     rows) +
                          "</div><div><h3>Then known to (standard)</h3>" +
                          html_table("explained", {{"", false}, {"", true}}, uncertainties) +
                          "</div></div>\n");
}

}  // namespace kempe::calibration_sections
