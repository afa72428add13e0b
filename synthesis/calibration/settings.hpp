#pragma once
// What to set on the four scales of a calibrated variable ratio instrument for any ratio, erect or reversed.
//
//   erect, smaller:   pole A, tracer F, pen E, setting k = ratio
//   erect, larger:    pole A, tracer E, pen F, setting k = 1 / ratio
//   reversed, smaller: pole E, tracer F, pen A, setting k = ratio / (1 + ratio)
//   reversed, larger:  pole E, tracer A, pen F, setting k = 1 / (1 + ratio)
//
// A scale's error found by calibration is taken as the same along the whole scale, as Knight takes it: its
// index is off. Arms that are not equal and bearings out of line make the corrections change with the
// setting.

#include <string>
#include <vector>

#include "synthesis/calibration/job.hpp"

namespace kempe {

struct SettingTask {
  double arm = 0;  ///< drawn, mm
  Measures deviations = Measures::Zero();
  Eigen::Matrix<double, measure_count, measure_count> covariance =
      Eigen::Matrix<double, measure_count, measure_count>::Zero();
  double coverage_factor = 2;
  ArmAngles arm_angles;  ///< over which the departures count
};

/// Settings outside these give a figure too flat or too slender to be used.
inline constexpr double smallest_setting = 0.02, largest_setting = 0.98;

/// The corrections that make the sum of squared departures over the arm angles smallest, and what is left
/// then.
SettingRow setting_for(const SettingTask& task, const WantedRatio& wanted, bool reversed);

/// A row erect and a row reversed for each ratio.
std::vector<SettingRow> setting_table(const SettingTask& task, const std::vector<WantedRatio>& wanted);

}  // namespace kempe
