#pragma once
// The sections of the calibration's page that are tables, each as an HTML fragment; empty where there is
// nothing to say.

#include <string>
#include <vector>

#include "synthesis/calibration/job.hpp"

namespace kempe::calibration_sections {

/// A length with three decimals throughout, so that figures stand under each other: "−0.110 mm".
std::string fixed_mm(double value);

/// Which way a maker moves what is wrong: "make it longer", "B farther from A".
std::string move_words(const Quantity& quantity, double correction);

std::string corrections(const CalibrationRecord& record);
/// Pole and reading frame.
std::string placement(const CalibrationRecord& record);
std::string unidentifiable(const CalibrationRecord& record);
std::string readings(const CalibrationRecord& record);
std::string rounds(const CalibrationRecord& record);
std::string settings(const CalibrationRecord& record);
std::string plan(const CalibrationRecord& record);

}  // namespace kempe::calibration_sections
