#pragma once
// A calibration as JSON for programs and as a page for people.

#include <optional>
#include <string>

#include "synthesis/calibration/job.hpp"
#include "synthesis/calibration/simulation.hpp"

namespace kempe {

/// One JSON object, newline at the end. errors_mm, corrections_mm, uncertainty_mm (standard) and
/// interval_95_mm (half width) have the keys AC, CF, BE, DE in Knight's signs (and arm_AC, ... where they
/// were free) or the eight lengths' names. What is not known is null. `equations`: with those of knight_equations.hpp, which the record
/// has.
std::string calibration_json(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, bool equations = false);

/// The same for people: what is wrong, what to set, what is left; short aligned lines.
std::string calibration_text(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, bool equations = false);

/// The page: error vectors before and after on a map, corrections, residuals, what cannot be told, settings,
/// plan. In the style of the design's report; loads nothing. Every text of the file is escaped.
struct CalibrationPage {
  std::string program_version, file_name, file_text;
};
std::string calibration_html(const CalibrationRecord& record,
                             const std::optional<SimulationRecord>& simulation, const CalibrationPage& page);

/// The simulated readings of the first instrument as a measurements file to be calibrated by hand, a comment
/// on top.
std::string simulated_measurements(const CalibrationRecord& record, const SimulationRecord& simulation);

}  // namespace kempe
