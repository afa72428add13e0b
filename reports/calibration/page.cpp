// The calibration's page, section by section.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/calibration/picture.hpp"
#include "reports/calibration/report.hpp"
#include "reports/calibration/sections.hpp"
#include "reports/page/html_page.hpp"
#include "reports/page/html_table.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

namespace section = calibration_sections;

using Rows = std::vector<std::vector<std::string>>;

std::string title(const CalibrationRecord& record) {
  return record.design ? "Calibration of " + record.measurements.design
                       : "Calibration of a variable ratio pantograph";
}

std::string what_was_done(const CalibrationRecord& record, bool is_simulated) {
  if (record.rounds.empty())
    return is_simulated  ? "How accurate the procedure is, simulated with instruments whose errors are known."
           : record.plan ? "No readings yet: a plan of where to measure."
                         : "No readings yet: --plan says where to measure, --simulate tests the procedure.";
  const std::size_t count = record.readings.size();
  const std::string how =
      record.method == CalibrationMethod::knight ? "Knight’s equations" : "least squares on its measures";
  return fmt::format(
      "{} readings in round {}, fitted by {}. Error = actual - nominal; a correction is what to set.", count,
      record.rounds.size(), how);
}

std::string header(const CalibrationRecord& record, bool is_simulated) {
  std::string badges;
  const std::string target = length_text(record.measurements.fit.target);
  if (!record.rounds.empty()) {
    badges += html_badge(
        record.reached, record.reached ? "Within the target of " + target
                                       : "Not yet within " + target + ": set the corrections and read again");
    badges += html_badge(record.indistinct.empty(), record.indistinct.empty()
                                                        ? "The readings determine every measure"
                                                        : "Some measures are not determined");
    const auto outliers = std::count_if(record.readings.begin(), record.readings.end(),
                                        [](const auto& one) { return one.fit.outlier; });
    if (outliers > 0)
      badges +=
          html_badge(false, fmt::format("{} reading{} out", outliers, outliers == 1 ? " stands" : "s stand"));
    const auto& check = record.calibration.check;
    if (check && check->contradicts())
      badges += html_badge(false, "Residuals larger than the stated uncertainty");
  }
  return "<header>\n" +
         html_heading("Kempe · calibration", title(record), what_was_done(record, is_simulated)) +
         "<ul class=\"badges\">\n" + badges + "</ul>\n</header>\n";
}

std::string key_figures(const CalibrationRecord& record) {
  if (record.rounds.empty()) return {};
  const RoundRecord& last = record.rounds.back();
  std::string html = html_key_figure("Largest departure", length_text(last.departure_largest), "as read");
  html += html_key_figure("Left of the readings", length_text(last.residual), "by the instrument as fitted");
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
      "enlarged {} times.</figcaption></figure></div>\n",
      heading, picture.svg, words, number_text(picture.magnification, 0));
}

std::string vectors(const CalibrationRecord& record) {
  const VectorPicture before = vector_picture(record, ErrorVectors::before),
                      after = vector_picture(record, ErrorVectors::after);
  if (before.svg.empty()) return {};
  return html_section("vectors", "Error vectors",
                      "<div class=\"columns\">\n" +
                          figure(before, "Before",
                                 "From where the point should be to where it was read; pale: the fitted "
                                 "instrument over its whole reach.") +
                          figure(after, "After",
                                 "What remains after the corrections: reading noise and what the model "
                                 "leaves out. Circles have the target’s radius.") +
                          "</div>\n");
}

std::string simulation_section(const std::optional<SimulationRecord>& simulation) {
  if (!simulation) return {};
  Rows rows{{"before", calibration_sections::fixed_mm(simulation->departure_mean),
             calibration_sections::fixed_mm(simulation->departure_largest), "–", "–"}};
  for (std::size_t i = 0; i < simulation->rounds.size(); ++i) {
    const SimulatedRound& round = simulation->rounds[i];
    rows.push_back({fmt::format("after round {}", i + 1), calibration_sections::fixed_mm(round.residual_mean),
                    calibration_sections::fixed_mm(round.residual_largest),
                    number_text(100 * round.reached, 1) + "\u202f%",
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
      "Full precision: <code>calibration.json</code>.</p>\n</footer>\n",
      html_escaped(page.program_version));
}

}  // namespace

std::string calibration_html(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, const CalibrationPage& page) {
  std::string body = "<main>\n" + header(record, simulation.has_value()) + key_figures(record) +
                     vectors(record) + section::corrections(record);
  body += section::unidentifiable(record) + section::placement(record) + section::settings(record) +
          section::readings(record) + section::rounds(record);
  body += section::plan(record) + simulation_section(simulation) + file_section(page) + "</main>\n" +
          footer(page);
  return html_page(title(record), page.program_version, body);
}

}  // namespace kempe
