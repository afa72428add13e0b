// calibration_text() of report.hpp.

#include <fmt/format.h>

#include <cmath>

#include "geometry/fixed_text.hpp"
#include "reports/calibration/knight_equations.hpp"
#include "reports/calibration/report.hpp"
#include "reports/calibration/sections.hpp"

namespace kempe {
namespace {

std::string instrument_line(const CalibrationRecord& record) {
  if (!record.design)
    return fmt::format(
        "instrument   variable ratio pantograph, arms {:.6g} mm, ratio {:.6g}; points by Knight's letters\n",
        record.measurements.instrument->arm, record.measurements.instrument->ratio);
  const CopyingLinkage& linkage = record.design->linkage;
  return fmt::format("instrument   {}: scale {:.6g}, rotation {:.6g} degrees\n", record.measurements.design,
                     std::abs(linkage.k()), degrees(std::arg(linkage.k())));
}

std::string method_line(const CalibrationRecord& record) {
  return fmt::format("method       {}, {} readings in round {}\n",
                     record.method == CalibrationMethod::knight ? "Knight's" : "least squares",
                     record.readings.size(), record.rounds.back().round);
}

std::string departure_lines(const CalibrationRecord& record) {
  const double target = record.measurements.fit.target;
  std::string text =
      fmt::format("copy error   {:.3f} mm at most as read: {} the target of {:.6g} mm\n",
                  record.rounds.back().departure_largest, record.reached ? "within" : "above", target);
  text += fmt::format("             the instrument as fitted comes within {:.3f} mm of every reading\n",
                      record.rounds.back().residual);
  return text;
}

/// With a sign, and no sign where it rounds to nothing.
std::string signed_figure(double value) {
  return std::abs(value) < 5e-4 ? "0.000" : fmt::format("{:+.3f}", value);
}

/// "  CX           390.520   +0.520 +- 0.098      -0.520  make it shorter"
std::string quantity_line(const CalibrationRecord& record, const Quantity& one) {
  const bool is_scale = one.kind == Quantity::Kind::scale;
  const std::string interval =
      one.determined || one.uncertainty > 0
          ? fmt::format("{:.3f}{}", record.calibration.coverage_factor * one.uncertainty,
                        one.determined ? " " : "*")
          : "held  ";
  std::string text = fmt::format("  {:<10} {:9.3f} {:>9} +- {} ", one.name,
                                 one.drawn + (is_scale ? 0 : one.error), signed_figure(one.error), interval);
  const double correction = correction_of(record, record.rounds.back(), one);
  if (is_scale || record.design)
    text += fmt::format("{:>11}  {}", signed_figure(correction),
                        calibration_sections::move_words(one, correction));
  else
    text += fmt::format("{:>11}  not set by a scale", "-");
  return text + "\n";
}

std::string placement_line(const CalibrationRecord& record, const Quantity& one) {
  const double half = record.calibration.coverage_factor * one.uncertainty;
  if (!one.determined) return fmt::format("  {:<10} cannot be told\n", one.name);
  if (one.name == "turn")
    return fmt::format("  {:<10} {:>9} +- {:.4f} degrees\n", one.name,
                       fixed_text(degrees(one.drawn + one.error), 4), degrees(half));
  return fmt::format("  {:<10} {:>9} +- {:.3f} mm\n", one.name, fixed_text(one.drawn + one.error, 3), half);
}

std::string quantity_lines(const CalibrationRecord& record) {
  const std::vector<Quantity>& quantities = record.rounds.back().quantities;
  std::string text = fmt::format("mm           {:>9} {:>9} {:>8} {:>13}\n", record.design ? "made" : "scale",
                                 "error", "95 %", "correction");
  std::string placement;
  for (const Quantity& one : quantities) {
    if (one.kind == Quantity::Kind::placement)
      placement += placement_line(record, one);
    else
      text += quantity_line(record, one);
  }
  if (!record.indistinct.empty()) text += "             * if what is held is as drawn\n";
  return placement.empty() ? text
                           : text + fmt::format("placement    {:>9} {:>8}\n", "found", "95 %") + placement;
}

std::string undetermined_lines(const CalibrationRecord& record) {
  std::string text;
  for (const UndeterminedCombination& told : record.indistinct) {
    text += fmt::format("undetermined {}\n", told.words);
    for (const Remedy& remedy : told.remedies)
      text += fmt::format("             {}: then known to +- {:.3f} mm\n", remedy.words, remedy.uncertainty);
  }
  return text;
}

/// Where nothing tells the readings' uncertainty.
std::string assumed_noise_lines(const CalibrationRecord& record) {
  if (record.calibration.noise_source != NoiseSource::assumed) return {};
  return fmt::format(
      "assumed      readings are uncertain by {:g} mm: nothing is stated (fit.reading_uncertainty_mm), and "
      "so few "
      "readings leave\n             nothing to estimate it from; the 95 % hold only if that is so\n",
      record.calibration.noise);
}

std::string fit_lines(const CalibrationRecord& record) {
  std::string text = assumed_noise_lines(record);
  bool any_outlier = false;
  for (const ReadingRecord& one : record.readings) {
    if (!one.fit.outlier) continue;
    any_outlier = true;
    const ReadingSpec& spec = record.measurements.readings[one.reading];
    text += fmt::format("outlier      {} (line {}): {:.3f} mm off the fit, {}\n", spec.name, spec.line,
                        one.fit.left.norm(), record.measurements.fit.keep_outliers ? "kept" : "left out");
  }
  if (record.calibration.check)
    text += "residuals    " + words_of(*record.calibration.check, any_outlier) + "\n";
  return text;
}

std::string setting_line(const SettingRow& row) {
  const std::string head = fmt::format("  {:<8} {:<8} ", row.ratio, row.reversed ? "reversed" : "erect");
  if (!row.impossible.empty()) return head + row.impossible + "\n";
  std::string text = head;
  for (const double scale : row.scales.values()) text += fmt::format(" {:9.3f}", scale);
  return text + fmt::format("  {:9.3f}\n", row.predicted);
}

std::string setting_lines(const CalibrationRecord& record) {
  if (record.settings.empty()) return {};
  std::string text = fmt::format("settings     image    {:>10}{:>10}{:>10}{:>10} {:>10}  mm\n", "AC", "CF",
                                 "BE", "DE", "error");
  for (const SettingRow& row : record.settings) text += setting_line(row);
  return text;
}

std::string plan_lines(const PlanRecord& plan) {
  std::string text = fmt::format("plan         {} readings; {:.2f} times as sharp as evenly spread ones\n",
                                 plan.readings.size(), plan.gain);
  for (const PlannedReading& one : plan.readings) {
    text += "  ";
    if (one.arm_angle) text += fmt::format("arm at {:.1f} degrees, ", degrees(*one.arm_angle));
    text +=
        fmt::format("tracer at ({}, {}) mm: pen expected at ({}, {}) mm{}\n", fixed_text(one.input.x(), 3),
                    fixed_text(one.input.y(), 3), fixed_text(one.wanted.x(), 3),
                    fixed_text(one.wanted.y(), 3), one.exchanged ? ", pole and tracer exchanged" : "");
  }
  return text;
}

std::string simulation_lines(const SimulationRecord& simulation) {
  std::string text = fmt::format(
      "simulated    {} instruments, {} readings a round; copy error {:.3f} mm on average, {:.3f} mm at "
      "most\n",
      simulation.instruments, simulation.readings, simulation.departure_mean, simulation.departure_largest);
  for (std::size_t i = 0; i < simulation.rounds.size(); ++i) {
    const SimulatedRound& round = simulation.rounds[i];
    text += fmt::format("  round {:<4} {:.3f} mm on average, {:.3f} mm at most; {:.1f} % within the target\n",
                        i + 1, round.residual_mean, round.residual_largest, 100 * round.reached);
  }
  if (simulation.failed > 0)
    text += fmt::format("             {} could not be calibrated\n", simulation.failed);
  return text;
}

}  // namespace

std::string calibration_text(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, bool equations) {
  std::string text = instrument_line(record);
  if (!record.rounds.empty())
    text += method_line(record) + departure_lines(record) + quantity_lines(record) +
            undetermined_lines(record) + fit_lines(record);
  if (equations) text += knight_equations_text(record);
  text += setting_lines(record);
  if (record.plan) text += plan_lines(*record.plan);
  if (simulation) text += simulation_lines(*simulation);
  return text;
}

}  // namespace kempe
