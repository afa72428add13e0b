// The calibration's page, section by section.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/calibration_picture.hpp"
#include "reports/calibration_report.hpp"
#include "reports/html_page.hpp"
#include "reports/html_table.hpp"
#include "reports/html_text.hpp"
#include "reports/report_charts.hpp"

namespace kempe {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Three decimals throughout, so that figures stand under each other.
std::string fixed(double value, bool with_plus = false) {
  const std::string digits = fmt::format("{:.3f}", std::abs(value));
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (zero ? "" : value < 0 ? "\u2212" : with_plus ? "+" : "") + digits;
}
std::string fixed_mm(double value) { return fixed(value) + "\u00a0mm"; }
std::string signed_mm(double value) { return fixed(value, true) + "\u00a0mm"; }
std::string plus_minus(double value) { return "±\u202f" + fixed_mm(value); }
std::string degrees_text(double angle) { return angle_text(angle, 1); }
std::string point_text(const Point& at) { return fixed(at.x()) + ", " + fixed(at.y()); }

std::string title(const CalibrationRecord& record) {
  return record.linkage ? "Calibration of " + record.measurements.design
                        : "Calibration of a variable ratio pantograph";
}

std::string what_was_done(const CalibrationRecord& record) {
  if (record.rounds.empty()) return "No readings yet: a plan of where to measure.";
  const std::size_t count = record.readings.size();
  const std::string how =
      record.method == CalibrationMethod::knight ? "Knight’s equations" : "least squares on its measures";
  return fmt::format(
      "{} readings in round {}, explained by {}. Errors are what was made less what was drawn; corrections "
      "are what to set.",
      count, record.rounds.size(), how);
}

std::string header(const CalibrationRecord& record) {
  std::string badges;
  const std::string target = length_text(record.measurements.fit.target);
  if (!record.rounds.empty()) {
    badges += html_badge(
        record.reached, record.reached ? "Within the target of " + target
                                       : "Not yet within " + target + ": set the corrections and read again");
    badges += html_badge(record.indistinct.empty(), record.indistinct.empty()
                                                        ? "Every measure told by the readings"
                                                        : "Some measures cannot be told apart");
    const auto outliers = std::count_if(record.readings.begin(), record.readings.end(),
                                        [](const auto& one) { return one.fit.outlier; });
    if (outliers > 0)
      badges +=
          html_badge(false, fmt::format("{} reading{} out", outliers, outliers == 1 ? " stands" : "s stand"));
  }
  return fmt::format(
      "<header>\n<p class=\"brand\">Kempe · calibration</p>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n<ul "
      "class=\"badges\">\n{}</ul>\n</header>\n",
      html_escaped(title(record)), what_was_done(record), badges);
}

std::string key_figures(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  const RoundRecord& last = record.rounds.back();
  std::string html = html_key_figure("Largest departure", length_text(last.departure_largest), "as read");
  html += html_key_figure("Left over", length_text(last.residual), "once the corrections are set");
  html += html_key_figure("Target", length_text(record.measurements.fit.target), "");
  html += html_key_figure("Uncertainty of a reading", length_text(record.calibration.noise, 4),
                          std::string(name(record.calibration.noise_source)));
  html += html_key_figure("Readings", std::to_string(record.readings.size()),
                          fmt::format("round {}", last.round));
  return "<dl class=\"keys\">\n" + html + "</dl>\n";
}

std::string figure(const VectorPicture& picture, std::string_view heading, std::string_view words) {
  return fmt::format(
      "<div><h3>{}</h3>\n<figure class=\"chart-figure\"><div class=\"board\">{}</div>\n<figcaption>{} Arrows "
      "{} times too long.</figcaption></figure></div>\n",
      heading, picture.svg, words, number_text(picture.magnification, 0));
}

std::string vectors(const CalibrationRecord& record) {
  const VectorPicture before = vector_picture(record, ErrorVectors::before),
                      after = vector_picture(record, ErrorVectors::after);
  if (before.svg.empty()) return {};
  return html_section("vectors", "Error vectors",
                      "<div class=\"columns\">\n" +
                          figure(before, "Before",
                                 "From where the point should be to where it was read; pale, what the fitted "
                                 "instrument does all over its reach.") +
                          figure(after, "After",
                                 "What no correction takes away: reading noise, and what the model does not "
                                 "know. Circles have the target’s radius.") +
                          "</div>\n");
}

/// Which way a maker moves what is wrong.
std::string move_words(const std::string& name, double correction) {
  const bool more = correction > 0;
  if (name == "AC") return more ? "B farther from A" : "B nearer to A";
  if (name == "CF") return more ? "D farther from C" : "D nearer to C";
  if (name == "BE") return more ? "B farther from E" : "B nearer to E";
  if (name == "DE")
    return more ? "D nearer to E (its scale runs the other way)"
                : "D farther from E (its scale runs the other way)";
  if (name.starts_with("arm") || name.starts_with("bearing"))
    return "not set by a scale: see the setting table";
  return more ? "make it longer" : "make it shorter";
}

std::string corrections(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  const RoundRecord& last = record.rounds.back();
  Rows rows;
  for (const Quantity& one : last.quantities) {
    if (one.kind == Quantity::Kind::placement) continue;
    const std::string interval =
        one.determined ? plus_minus(record.calibration.coverage_factor * one.uncertainty) : "cannot be told";
    const double correction = correction_of(record, last, one);
    rows.push_back({html_escaped(one.name),
                    fixed_mm(one.drawn + (one.kind == Quantity::Kind::scale ? 0 : one.error)),
                    signed_mm(one.error), interval, signed_mm(correction), move_words(one.name, correction)});
  }
  const std::string first = record.linkage ? "Made" : "Drawn";
  return html_section("corrections", "What is wrong and what to set",
                      html_table("explained",
                                 {{"", false},
                                  {first, true},
                                  {"Error", true},
                                  {"95 %", true},
                                  {"Correction", true},
                                  {"That is", false}},
                                 rows));
}

std::string placement(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  Rows rows;
  for (const Quantity& one : record.rounds.back().quantities) {
    if (one.kind != Quantity::Kind::placement) continue;
    const bool turn = one.name == "turn";
    const double half = record.calibration.coverage_factor * one.uncertainty;
    rows.push_back(
        {one.name, turn ? angle_text(one.drawn + one.error, 4) : fixed_mm(one.drawn + one.error),
         one.determined ? (turn ? "±\u202f" + angle_text(half, 4) : plus_minus(half)) : "cannot be told"});
  }
  return rows.empty()
             ? std::string()
             : html_section("placement", "Where it stands",
                            html_table("explained", {{"", false}, {"Found", true}, {"95 %", true}}, rows));
}

std::string unidentifiable(const CalibrationRecord& record) {
  std::string html;
  for (const Told& told : record.indistinct) {
    std::string remedies;
    for (const Remedy& remedy : told.remedies)
      remedies += fmt::format("<li>{} (then known to {})</li>\n", html_escaped(remedy.words),
                              plus_minus(remedy.uncertainty));
    html += fmt::format(
        "<div><p><b>{}</b> changes nothing that was read{}. It was held as drawn.</p><p class=\"note\">Any "
        "of these would tell:</p><ul class=\"note\">\n{}</ul></div>\n",
        html_escaped(told.words),
        told.combination.uncertainty
            ? " beyond its uncertainty: it is known to " + plus_minus(*told.combination.uncertainty) + " only"
            : "",
        remedies);
  }
  if (html.empty()) return {};
  return html_section("unidentifiable", "What the readings cannot tell",
                      "<p class=\"lead\">The corrections bring the copy right all the same; only these "
                      "measures themselves stay unknown.</p>\n<div class=\"columns\">" +
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
                                                     : " <b class=\"bad\">stands out, left out</b>";
    rows.push_back({label, place, point_text(one.fit.departure), point_text(one.fit.left),
                    fixed_mm(one.fit.left.norm()),
                    one.fit.studentised > 0 ? number_text(one.fit.studentised, 1) : "–",
                    share_bar(largest > 0 ? one.fit.studentised / largest : 0)});
  }
  return html_section("readings", "Readings",
                      html_table("budget",
                                 {{"", false},
                                  {record.linkage ? "Set at, mm" : "Arm angle", true},
                                  {"Departure x, y, mm", true},
                                  {"Left x, y, mm", true},
                                  {"Left", true},
                                  {"In its own deviations", true},
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
    if (one.kind != Quantity::Kind::placement)
      columns.push_back({html_escaped("Correction " + one.name), true});
  return html_section("rounds", "Rounds", html_table("pareto", columns, rows));
}

std::string knights_letter(Joint joint) { return joint == Joint::X ? "A" : joint == Joint::Y ? "F" : "E"; }

std::string settings(const CalibrationRecord& record) {
  Rows rows;
  for (const SettingRow& row : record.settings) {
    std::vector<std::string> cells{
        html_escaped(row.ratio) + (row.reversed ? " <small>reversed</small>" : " <small>erect</small>"),
        fmt::format("{}, {}, {}", knights_letter(row.pole), knights_letter(row.stylus),
                    knights_letter(row.pencil)),
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
      "A scale’s error is taken as the same along the whole scale, as Knight takes it.</p>\n",
      degrees_text(record.measurements.arm_angles.lower), degrees_text(record.measurements.arm_angles.upper));
  return html_section("settings", "Setting table",
                      words + html_table("pareto",
                                         {{"Ratio", false},
                                          {"Pole, stylus, pencil at", false},
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
                    point_text(one.input), point_text(one.wanted),
                    one.exchanged ? "stylus and pencil exchanged" : "as usual"});
  Rows uncertainties;
  for (const Quantity& one : record.plan->quantities)
    uncertainties.push_back({html_escaped(one.name), one.name == "turn"
                                                         ? "±\u202f" + angle_text(one.uncertainty, 4)
                                                         : plus_minus(one.uncertainty)});
  const std::string words = fmt::format(
      "<p class=\"lead\">These places tell the measures best (D-optimal): {} times as sharply, on the "
      "average, as as many spread evenly.</p>\n",
      number_text(record.plan->gain, 2));
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

std::string simulation_section(const std::optional<SimulationRecord>& simulation) {
  if (!simulation) return {};
  Rows rows{
      {"before", fixed_mm(simulation->departure_mean), fixed_mm(simulation->departure_largest), "–", "–"}};
  for (std::size_t i = 0; i < simulation->rounds.size(); ++i) {
    const SimulatedRound& round = simulation->rounds[i];
    rows.push_back({fmt::format("after round {}", i + 1), fixed_mm(round.residual_mean),
                    fixed_mm(round.residual_largest), number_text(100 * round.reached, 1) + "\u202f%",
                    number_text(100 * round.coverage, 1) + "\u202f%"});
  }
  const std::string words =
      fmt::format("<p class=\"lead\">{} instruments with hidden errors, {} readings a round.</p>\n",
                  count_text(static_cast<unsigned long long>(simulation->instruments)), simulation->readings);
  return html_section("simulation", "Simulation",
                      words + html_table("pareto",
                                         {{"", false},
                                          {"Departure, mean", true},
                                          {"Largest", true},
                                          {"Within the target", true},
                                          {"True errors inside the 95 % intervals", true}},
                                         rows));
}

std::string file_section(const CalibrationPage& page) {
  constexpr std::size_t most = 20000;
  const bool cut = page.file_text.size() > most;
  const std::string text = cut ? page.file_text.substr(0, most) : page.file_text;
  return html_section("file", "Measurements",
                      fmt::format("<p class=\"note\"><code>{}</code></p>\n<pre>{}</pre>\n{}",
                                  html_escaped(page.file_name), html_escaped(text),
                                  cut ? "<p class=\"note left-out\">The rest is left out here.</p>\n" : ""));
}

std::string footer(const CalibrationPage& page) {
  return fmt::format(
      "<footer>\n<p>Made by Kempe {}. Lengths in millimetres, angles counter-clockwise, seen from above. "
      "Full precision stands in <code>calibration.json</code>.</p>\n</footer>\n",
      html_escaped(page.program_version));
}

}  // namespace

std::string calibration_html(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, const CalibrationPage& page) {
  std::string body =
      "<main>\n" + header(record) + key_figures(record) + vectors(record) + corrections(record);
  body += unidentifiable(record) + placement(record) + settings(record) + readings(record) + rounds(record);
  body += plan(record) + simulation_section(simulation) + file_section(page) + "</main>\n" + footer(page);
  return html_page(title(record), page.program_version, body);
}

}  // namespace kempe
