#pragma once
// Calibration of a made instrument from what it drew: nonlinear least squares on its measures
// (instrument.hpp), with what is behind the figures: uncertainties, correlations, what the readings cannot
// tell apart, which readings stand out.
//
// Lengths mm, angles rad. Deviations are "made less drawn"; the corrections are their negatives.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/instrument.hpp"
#include "synthesis/calibration/fit.hpp"

namespace kempe {

/// One place set and one place read.
struct CalibrationReading {
  std::size_t setup = 0;  ///< index into CalibrationTask::setups: at which setting and mounting it was taken
  Point input = Point::Zero();   ///< where the input joint stood, table frame
  Point output = Point::Zero();  ///< where the output was read, reading frame
};

/// A length of the instrument itself, taken with a ruler or caliper.
struct MeasuredLength {
  std::size_t length = 0;  ///< index into LinkLengths::names
  double value = 0;
  double uncertainty = 0;  ///< standard uncertainty, > 0
};

struct CalibrationTask {
  /// The instrument as drawn, in each setting or mounting in which it was read; the deviations are common to
  /// all.
  std::vector<Instrument> setups;
  std::vector<CalibrationReading> readings;
  std::vector<MeasuredLength> lengths;
  std::vector<Measure> free;  ///< what may deviate; the rest is as drawn
  /// Measures that are not free but only known to be as drawn within a standard uncertainty (mm): it goes
  /// into the uncertainty of the others.
  struct Known {
    Measure measure;
    double uncertainty;
  };
  std::vector<Known> known_within;
  /// Standard uncertainty of each coordinate read; absent: from the residuals.
  std::optional<double> reading_uncertainty;
  /// An estimate from the residuals is never taken as smaller: the rounding of what was written down, mm.
  double rounding = 0;
  double setting_uncertainty = 0;  ///< standard, of each coordinate set (the tracer on its mark)
  /// Deviations expected of the maker. A combination of measures known worse than this is one that the
  /// readings cannot tell.
  double plausible_deviation = 1;
  bool keep_outliers = false;  ///< named but not left out of the fit
};

/// Measures that can move together, each by its factor, without a change that the readings show.
struct Indistinct {
  struct Part {
    Measure measure;
    double factor;  ///< mm per mm of the first part (the turn: rad per mm)
  };
  std::vector<Part> parts;  ///< the first is the measure held as drawn, with factor 1
  /// Standard uncertainty of the first part if it were not held; absent where no reading of this kind tells
  /// anything.
  std::optional<double> uncertainty;
};

/// Where the uncertainty of a reading comes from.
enum class NoiseSource {
  stated,
  residuals,         ///< estimated from what is left, with `degrees_of_freedom`
  larger_residuals,  ///< stated, but the residuals are larger beyond chance: those are used
  assumed            ///< nothing stated and nothing left over: `assumed_reading_uncertainty`
};
std::string_view name(NoiseSource source);
inline constexpr double assumed_reading_uncertainty = 0.01;  ///< mm

struct Calibration {
  Measures deviations = Measures::Zero();
  /// Of the deviations, given that the held measures are as drawn; zero for measures that were neither free
  /// nor only known within an uncertainty.
  Eigen::Matrix<double, measure_count, measure_count> covariance =
      Eigen::Matrix<double, measure_count, measure_count>::Zero();
  std::vector<Indistinct> indistinct;  ///< empty: everything free is determined
  Eigen::Matrix<bool, measure_count, 1> determined = Eigen::Matrix<bool, measure_count, 1>::Constant(true);
  std::vector<ReadingFit> readings;
  std::optional<FitCheck> check;  ///< where the noise is stated and something is left over
  /// Where outliers are named: the deviations if they were kept (or, where they are kept, left out).
  std::optional<Measures> otherwise;
  double noise = 0;  ///< standard uncertainty of a coordinate read, mm
  NoiseSource noise_source = NoiseSource::assumed;
  int degrees_of_freedom = 0;
  double coverage_factor = 2;             ///< standard uncertainty to 95 % interval
  double left_largest = 0, left_rms = 0;  ///< over the readings that were used, mm (rms of a coordinate)
  std::vector<double> singular_values;    ///< of the weighted slopes of the free measures, per mm, falling

  double uncertainty(Measure measure) const {
    return std::sqrt(covariance(index_of(measure), index_of(measure)));
  }
};

/// Why no calibration comes back: what was found and what to give or to measure instead.
struct CalibrationFault {
  std::optional<std::size_t> reading;  ///< absent: no one reading
  std::string found, allowed;
};

/// Fits the free measures to the readings.
///
/// Guarantees:
///  1. without noise the deviations are those of the instrument to 1e-9 of what `determined` marks;
///  2. what the readings cannot tell is named in `indistinct`, one combination each, and held as drawn;
///  3. the same task gives the same bytes.
///
/// Refused: fewer coordinates than free measures, all readings of a setup at one place, a place out of reach,
/// a copy whose size is not near the ratio (swapped points or units).
tl::expected<Calibration, CalibrationFault> calibrate(const CalibrationTask& task);

/// Largest departure that is left at the readings' places when `corrections` are added to the instrument's
/// measures. Nothing if a place is then out of reach.
std::optional<double> departure_with(const CalibrationTask& task, const Measures& deviations,
                                     const Measures& corrections);

}  // namespace kempe
