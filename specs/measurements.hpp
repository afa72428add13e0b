#pragma once
// What a person measured on a made instrument: the file of `kempe calibrate`, checked, in millimetre and
// radian.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/point.hpp"
#include "kempe/input_error.hpp"

namespace kempe {

/// Knight's instrument: two equal arms AC = CF, and the ratio that its four scales were set to.
struct VariableRatioSpec {
  double arm = 0;      ///< mm, > 0
  double ratio = 0.5;  ///< 0 < . < 1
};

/// One place that was set and what was read there. Either the arm angle with the departure of the point read,
/// or both places.
struct ReadingSpec {
  int line = 0;
  std::string name;  ///< as the user calls it, or "reading 3"
  int round = 1;     ///< 2 for the readings after the corrections of round 1 were set, and so on
  std::optional<double> arm_angle;  ///< rad
  Point error = Point::Zero();      ///< mm, with arm_angle
  Point tracer = Point::Zero();     ///< mm, without
  Point pen = Point::Zero();        ///< mm, without
  std::optional<double> ratio;      ///< the scales' setting, where it is not the instrument's
  bool exchanged = false;           ///< tracer and pen exchanged
};

/// A length taken on the instrument itself.
struct LengthSpec {
  std::string name;
  double value = 0;
  double uncertainty = 0;
  int line = 0;
};

enum class CalibrationMethod { knight, least_squares };
std::string_view name(CalibrationMethod method);

struct FitSpec {
  std::optional<CalibrationMethod> method;  ///< absent: Knight's where his equations apply
  std::vector<std::string> free;            ///< groups of measures; empty: the usual ones
  std::optional<double> reading_uncertainty;
  double tracer_uncertainty = 0;
  std::optional<double> plausible_deviation;
  double arm_tolerance_percent = 0;      ///< the arms' length is known to this only, where they are not free
  double bearing_tolerance_percent = 0;  ///< likewise the bearings' place in the line of the arms
  double target = 0.1;
  bool keep_outliers = false;
};

/// A copy ratio wanted of a variable ratio instrument, as the user wrote it.
struct WantedRatio {
  std::string text;
  double value = 0;  ///< > 0
};

/// Arm angles within which an instrument is used, rad.
struct ArmAngles {
  double lower = radians(20), upper = radians(70);
};

struct PlanSpec {
  int readings = 10;
  bool exchange = true;  ///< readings with tracer and pen exchanged may be proposed
};

struct SimulationSpec {
  std::map<std::string, double> errors;  ///< hidden, by the names of the result; the rest is drawn by lot
  double largest_error = 1;              ///< mm
  double noise = 0;                      ///< mm, standard deviation of each coordinate read
  double resolution = 0.01;              ///< mm: readings are rounded to multiples of this; 0: not rounded
  double play = 0;                       ///< mm, of each pin
  double arm_error_percent = 0;          ///< of the arms' length, each by lot within plus or minus this
  double bearing_error_percent = 0;      ///< likewise how far bearings B and D stand out of line
  int instruments = 1000;
  int readings = 0;  ///< of each round; 0: two for Knight's method, ten for least squares
  int rounds = 3;
};

struct Measurements {
  std::optional<VariableRatioSpec> instrument;  ///< either this
  std::string design;                           ///< or a design.json, as written in the file
  std::vector<ReadingSpec> readings;
  std::vector<LengthSpec> lengths;
  FitSpec fit;
  ArmAngles arm_angles;
  std::vector<WantedRatio> ratios;
  std::optional<PlanSpec> plan;
  std::optional<SimulationSpec> simulation;
};

/// Groups of measures that [fit] free may name, for an instrument or a design.
const std::vector<std::string_view>& free_groups(bool variable_ratio);

/// Names of the lengths that [lengths_mm] and [simulate] errors_mm may give.
const std::vector<std::string_view>& measurable_lengths(bool variable_ratio);
const std::vector<std::string_view>& error_names(bool variable_ratio);

/// Reads and checks a file's text; `file` is its name for messages. The error names line and key, what was
/// found and what is allowed.
tl::expected<Measurements, InputError> read_measurements(std::string_view text, const std::string& file);

}  // namespace kempe
