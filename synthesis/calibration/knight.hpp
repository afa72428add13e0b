#pragma once
// Knight's calibration of the variable ratio pantograph: four scale errors from departures at two or more arm
// angles.
//
// Source: A. S. Knight, "An analytical method for the calibration of a variable ratio pantograph", equations
// (17), (18):
//   ex cos t + ey sin t = e_DE + e_CF cos 2t
//   ex cos t - ey sin t = e_BE + e_AC cos 2t
// for a reading (ex, ey) at the arm angle t. Two angles solve them exactly: (23) to (26) are the case 30 and
// 60 degrees. More angles are fitted by least squares in each equation. The equations hold to first order in
// the errors, for every setting of the ratio: B and E stay on a rhombus' sides with the pole.

#include <array>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/instrument.hpp"

namespace kempe {

/// Departure of the pen E from its true place, with the arm AC at `arm_angle` from the line A-F.
struct KnightReading {
  double arm_angle = 0;         ///< rad
  Point error = Point::Zero();  ///< mm: x toward the tracer F, y toward C
};

/// Errors of the four scales in Knight's signs, mm. Corrections are their negatives.
///   e_AC = dAB, e_CF = dCD, e_BE = dBE, e_DE = -dDE: the scale of DE runs against its length.
struct ScaleErrors {
  double AC = 0, CF = 0, BE = 0, DE = 0;
  static constexpr std::array<std::string_view, 4> names{"AC", "CF", "BE", "DE"};
  std::array<double, 4> values() const { return {AC, CF, BE, DE}; }
  ScaleErrors operator-() const { return {-AC, -CF, -BE, -DE}; }
  bool operator==(const ScaleErrors&) const = default;
};

/// The measure that each scale sets, in the order of ScaleErrors::names, and its sign in Knight's count.
struct Scale {
  Measure measure;
  double sign;  ///< d measure = sign * e
};
inline constexpr std::array<Scale, 4> scales{
    {{Measure::AX, 1}, {Measure::BC, 1}, {Measure::VA, 1}, {Measure::VB, -1}}};

/// Deviations of an instrument's measures that these scale errors make, all others zero.
Measures deviations_of(const ScaleErrors& errors);
/// The scale errors among an instrument's deviations.
ScaleErrors scale_errors_of(const Measures& deviations);

/// Errors with what they rest on.
struct KnightErrors {
  ScaleErrors errors;
  /// d(AC, CF, BE, DE) / d(ex_1, ey_1, ex_2, ...): the equations solved are linear.
  Eigen::Matrix<double, 4, Eigen::Dynamic> by_reading;
  /// What the equations leave over at each reading, mm: zero for two angles.
  std::vector<Point> left;
};

/// Why the equations cannot be solved.
enum class KnightFault {
  too_few,    ///< fewer than two readings
  at_an_end,  ///< an arm angle within `knight_end_margin` of 0 or 90 degrees
  one_angle   ///< no two arm angles differ by `knight_least_spread` in cos 2t
};
std::string_view name(KnightFault fault);

/// At 0 and 90 degrees equations (5) and (6) were divided by sin 2t = 0; nearer than this to them the linkage
/// is so near its dead points that first order does not hold for errors of a few thousandths of the arms.
inline constexpr double knight_end_margin = radians(5);
/// Least difference of cos 2t between two of the readings: 0.05, about 1.5 degrees of arm angle at 45
/// degrees.
inline constexpr double knight_least_spread = 0.05;

tl::expected<KnightErrors, KnightFault> knight_errors(const std::vector<KnightReading>& readings);

/// The departure that scale errors make at an arm angle, by equations (17) and (18); sin 2t must not be 0.
Point departure_of(const ScaleErrors& errors, double arm_angle);

}  // namespace kempe
