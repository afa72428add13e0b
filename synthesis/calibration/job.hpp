#pragma once
// From a measurements file to a finished calibration: rounds, quantities in the maker's names, what to set,
// what to measure next. The record holds everything that a report says.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"
#include "specs/measurements.hpp"
#include "synthesis/calibration/knight.hpp"
#include "synthesis/calibration/plan.hpp"

namespace kempe {

/// Something with a name of its own that may be wrong: a scale's reading (Knight's sign), a length, an offset
/// out of line, the pole's place, the reading frame.
struct Quantity {
  std::string name;
  enum class Kind { scale, length, placement } kind = Kind::length;
  double drawn = 0;        ///< what it should be, mm (rad for the turn)
  double error = 0;        ///< made less drawn, mm (rad)
  double uncertainty = 0;  ///< standard, given that what is held is as drawn
  bool determined = true;  ///< false: only together with others, see `UndeterminedCombination::parts`
};

/// What an extra measurement would tell about a combination.
struct Remedy {
  std::string words;       ///< "measure CX with a ruler"
  double uncertainty = 0;  ///< of the combination's first part afterwards, mm
};

/// A combination that the readings cannot tell, in words.
struct UndeterminedCombination {
  Indistinct combination;
  std::string words;
  std::vector<Remedy> remedies;  ///< best first; never empty
};

struct RoundRecord {
  int round = 1;
  std::vector<std::size_t> readings;  ///< indices into Measurements::readings
  double departure_largest = 0;       ///< as read, mm
  double residual = 0;                ///< largest departure left once the corrections are set, mm
  Measures deviations = Measures::Zero();
  std::vector<Quantity> quantities;
  /// Of the scales, for arms and bearings as they are; where those are as drawn, the errors' negatives.
  ScaleErrors corrections;
};

struct ReadingRecord {
  std::size_t reading = 0;
  Point input = Point::Zero(), wanted = Point::Zero(), read = Point::Zero();
  ReadingFit fit;
};

/// One row of the setting table of a variable ratio instrument.
struct SettingRow {
  std::string ratio;  ///< as wanted
  bool reversed = false;
  Joint pole = Joint::X, tracer = Joint::Y, pen = Joint::V;
  double setting = 0;       ///< AB / AC
  ScaleErrors corrections;  ///< to each scale's reading
  ScaleErrors scales;       ///< what to set on each scale, mm: setting * arm + correction
  double before = 0;        ///< largest departure with the scales at their nominal reading, mm
  double remaining = 0;     ///< largest departure that no setting takes away, mm
  double predicted = 0;     ///< remaining, with the 95 % uncertainty of the calibration added, mm
  std::string impossible;   ///< why there is no such setting; then the rest means nothing
};

/// A reading that would tell much.
struct PlannedReading {
  bool exchanged = false;
  std::optional<double> arm_angle;  ///< rad, on Knight's axis
  Point input = Point::Zero();      ///< table frame, mm
  Point wanted = Point::Zero();     ///< where the point read should be
};

struct PlanRecord {
  std::vector<PlannedReading> readings;
  std::vector<Quantity> quantities;  ///< with the uncertainty that these readings would give
  double gain = 1;  ///< how much smaller (geometric mean) than by as many evenly spread readings
};

struct CalibrationRecord {
  Measurements measurements;
  std::optional<DrawnDesign> design;  ///< absent for a variable ratio instrument
  std::vector<Instrument> setups;
  CalibrationMethod method = CalibrationMethod::least_squares;
  std::vector<RoundRecord> rounds;      ///< the last is the present state; empty if there are no readings
  std::vector<ReadingRecord> readings;  ///< of the last round
  std::vector<Quantity> total;          ///< errors of all rounds together: of the instrument at the start
  Calibration calibration;              ///< of the last round
  /// Where readings of the last round stand out: its errors if those were kept (or, where they are kept, left out).
  std::vector<Quantity> otherwise;
  Eigen::MatrixXd correlations;  ///< of the last round's quantities
  std::vector<UndeterminedCombination> indistinct;
  bool reached = false;  ///< the last round's readings depart by no more than the target
  std::vector<SettingRow> settings;
  std::optional<PlanRecord> plan;
};

/// What to set or to make a quantity of a round other by: a scale's correction, else the error's negative.
double correction_of(const CalibrationRecord& record, const RoundRecord& round, const Quantity& quantity);

/// The calibration of a file's readings. `design` is the one that the file names, nothing for a
/// variable ratio instrument.
/// `file` names the measurements in errors.
tl::expected<CalibrationRecord, InputError> run_calibration(const Measurements& measurements,
                                                            const std::optional<DrawnDesign>& design,
                                                            const std::string& file);

/// The quantities that deviations make, in the order of the result, with their uncertainties.
struct QuantityTable {
  std::vector<Quantity> quantities;
  Eigen::MatrixXd by;  ///< d quantity / d measures
};
QuantityTable quantities_of(const Instrument& reference, bool variable_ratio,
                            const std::vector<Measure>& free, const Calibration& calibration);

/// What the residuals say about the stated uncertainty, for a person.
std::string words_of(const FitCheck& check, bool outliers_named);

/// What a person calls a measure of a design ("AX") or of a variable ratio instrument ("AC" for the scale
/// that sets it).
std::string spoken_name(Measure measure, bool variable_ratio);

}  // namespace kempe
