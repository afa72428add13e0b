#pragma once
// Where to measure: D-optimal readings, and what would tell a combination that the readings so far cannot.

#include <vector>

#include "geometry/region.hpp"
#include "synthesis/calibration/calibration.hpp"

namespace kempe {

/// A reading that could be taken.
struct Candidate {
  std::size_t setup = 0;
  Point input = Point::Zero();
};

/// Candidates on Knight's axis: arm angles evenly over [lower, upper] (rad); `setup` is mounted as drawn.
std::vector<Candidate> candidates_on_axis(const CalibrationTask& task, std::size_t setup, double arm,
                                          double lower, double upper, int count);

/// A design whose made instrument is calibrated, and where it may be read.
struct DrawnDesign {
  CopyingLinkage linkage;
  OpeningInterval usable;      ///< openings at which nothing touches
  double bearing_lower = -pi;  ///< of the tracer as seen from the pole, rad
  double bearing_upper = pi;

  /// The tracer at a share (0..1) of the usable openings and of the bearings.
  Point place(double share_of_openings, double share_of_bearings) const;
};

/// The design with the openings that its file certifies (those with 20 degrees of transmission if it
/// certifies none), and the bearings of its region, widened by 30 degrees.
DrawnDesign drawn_design(const CopyingLinkage& linkage, const OpeningInterval& certified,
                         const Region& region);

/// Candidates all over a design's places: `radii` openings times `bearings`. Exchanged: the places of the
/// pen.
std::vector<Candidate> candidates_over_reach(const DrawnDesign& design, bool exchanged, std::size_t setup,
                                             int radii, int bearings);

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
