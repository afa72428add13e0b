#pragma once
// Where to measure: D-optimal readings, and what would tell a combination that the readings so far cannot.

#include <vector>

#include "synthesis/calibration.hpp"

namespace kempe {

/// A reading that could be taken.
struct Candidate {
  std::size_t setup = 0;
  Point input = Point::Zero();
};

/// Candidates on Knight's axis: arm angles evenly over [lower, upper] (rad); `setup` is mounted as drawn.
std::vector<Candidate> candidates_on_axis(const CalibrationTask& task, std::size_t setup, double arm,
                                          double lower, double upper, int count);

/// Candidates all over a linkage's reach: openings over `openings`, bearings all around.
std::vector<Candidate> candidates_over_reach(const CopyingLinkage& linkage, const OpeningInterval& openings,
                                             bool exchanged, std::size_t setup, int radii, int bearings);

/// What a set of readings would tell about the measures in `task.free` (in task.units of calibration_fit,
/// mm), the task's own readings and lengths included: J^T J / noise^2.
Eigen::MatrixXd information_of(const CalibrationTask& task, const std::vector<Candidate>& readings,
                               double noise);

/// The `count` different candidates that, with the task's own readings, make det(information) largest:
/// greedy, then exchanged one by one while that helps. Combinations that nothing tells count as known to the
/// plausible deviation.
std::vector<Candidate> d_optimal(const CalibrationTask& task, const std::vector<Candidate>& candidates,
                                 std::size_t count, double noise);

/// Standard uncertainty of `combination`'s first part if one more reading (or length, by its slopes) were
/// taken.
double uncertainty_after(const CalibrationTask& task, const Indistinct& combination,
                         const Candidate& candidate, double noise);
double uncertainty_after(const CalibrationTask& task, const Indistinct& combination, std::size_t length,
                         double uncertainty);

}  // namespace kempe
