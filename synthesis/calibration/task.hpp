#pragma once
// From readings as they stand in a file to a task of calibration, and Knight's way to solve it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "specs/measurements.hpp"
#include "synthesis/calibration/calibration.hpp"
#include "synthesis/calibration/plan.hpp"

namespace kempe {

/// The task of one round: its readings are added one by one; setups are shared where setting and mounting
/// agree. Setup 0 is the instrument as drawn. Keeps references to its arguments.
class TaskMaking {
 public:
  TaskMaking(const Measurements& measurements, const std::optional<DrawnDesign>& design);

  const CalibrationTask& task() const { return task_; }
  const Measurements& measurements() const { return *measurements_; }
  const std::optional<DrawnDesign>& design() const { return *design_; }

  void add(const ReadingSpec& reading);
  /// The setup at this setting of the scales (0 for a design), made if it is new.
  std::size_t setup_number(double ratio, bool exchanged);
  /// The setting of a variable ratio instrument, 0 for a design.
  double reference_ratio() const;

 private:
  Instrument setup(double ratio, bool exchanged) const;

  const Measurements* measurements_;
  const std::optional<DrawnDesign>* design_;
  CalibrationTask task_;
  std::vector<std::pair<double, bool>> keys_;
};

/// The task of the last round's readings.
TaskMaking last_round(const Measurements& measurements, const std::optional<DrawnDesign>& design);

/// True if Knight's equations apply to the readings: arm angles, the scales alone free, no lengths taken.
bool knights_case(const Measurements& measurements);

/// The file's choice; else Knight's for two readings a round, least squares for more.
CalibrationMethod method_for(const Measurements& measurements);

/// Knight's equations for these readings of a task, as a calibration. They must be his case. Of more than two, those that
/// stand out from the least-squares fit are named, and left out unless they are to be kept.
tl::expected<Calibration, CalibrationFault> calibrate_by_knight(const CalibrationTask& task,
                                                                const Measurements& measurements,
                                                                const std::vector<std::size_t>& readings);

/// The index of a length in LinkLengths::names; "arm_AC" and "arm_CF" are CX and CY.
std::size_t length_index(std::string_view name);

/// The measures that groups of [fit] free stand for; none: the usual ones.
std::vector<Measure> free_measures(const std::vector<std::string>& groups, bool variable_ratio,
                                   bool straight);

}  // namespace kempe
