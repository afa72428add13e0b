#pragma once
// The inner nouns of calibration: the weighted residuals of a task, and their fit for a choice of free
// measures.

#include <optional>
#include <vector>

#include "synthesis/calibration/calibration.hpp"
#include "synthesis/calibration/least_squares.hpp"

namespace kempe::calibration_detail {

/// Millimetres that a unit of each measure moves things by: 1 for lengths, the instrument's size for the
/// turn. The fit counts in millimetres.
Measures units_of(const CalibrationTask& task);

/// The task with the readings to use and the noise to weigh them by.
struct WeightedTask {
  const CalibrationTask& task;
  std::vector<std::size_t> used;  ///< indices of readings
  double noise;                   ///< of a coordinate read, mm, > 0
  Measures units;
  /// What the model itself may leave, mm: no residual below this makes a reading stand out.
  double model_error = 0;

  Eigen::Index rows() const { return static_cast<Eigen::Index>(2 * used.size() + task.lengths.size()); }
  /// Standard uncertainty of a residual of reading i: what was read, and what was set times the scale of the
  /// copy.
  double deviation_of(std::size_t reading) const;
  /// (fitted - read) / uncertainty, readings first, then lengths; slopes by the measures in `free`, counted
  /// in units.
  bool evaluate(const Measures& deviations, const std::vector<Measure>& free, Eigen::VectorXd& residuals,
                Eigen::MatrixXd* slopes) const;
};

struct FitOutcome {
  Measures deviations = Measures::Zero();
  double square_sum = 0;
  bool converged = false;
  Eigen::VectorXd residuals;  ///< at the solution
  Eigen::MatrixXd slopes;     ///< at the solution, by `free`
};

/// Too few readings, all at one opening, a place out of reach, a copy of the wrong size; nothing if all is
/// well.
std::optional<CalibrationFault> fault_of(const CalibrationTask& task);

/// Fits `free` from `start`; nothing where the start cannot be closed.
std::optional<FitOutcome> fit(const WeightedTask& weighted, const std::vector<Measure>& free,
                              const Measures& start);

/// (J^T J)^-1 by singular values, without those below slack::no_weight of the largest.
Eigen::MatrixXd inverse_normal(const Eigen::MatrixXd& slopes);

/// The combinations of `free` known worse than `plausible` (mm) by slopes J (rows in standard uncertainties,
/// columns per mm): for each, the measure to hold and the parts that move with it. Sorted by the measure
/// held.
std::vector<Indistinct> indistinct_combinations(const Eigen::MatrixXd& slopes,
                                                const std::vector<Measure>& free, const Measures& units,
                                                double plausible);

/// What the readings say about the noise: of a coordinate read, mm, and the degrees of freedom it rests on
/// (0: none).
struct NoiseEstimate {
  double noise = 0;
  double freedom = 0;
};
NoiseEstimate estimated_noise(const WeightedTask& weighted, const FitOutcome& fit);

/// Residuals and slopes about some deviations, weighted: all that the search for outliers looks at.
struct LinearFit {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slopes;
};

/// The sum of squares that a linear fit of everything leaves.
double least_square_sum(const LinearFit& about, std::size_t readings);

}  // namespace kempe::calibration_detail
