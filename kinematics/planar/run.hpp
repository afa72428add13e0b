#pragma once
// A linkage driven over a whole motion: the positions, velocities and accelerations at even steps.

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "kinematics/planar/driver_motion.hpp"
#include "kinematics/planar/path.hpp"

namespace kempe {

/// How all drivers of a linkage move together. A range moves one driver, a path two (x and y of a point), in
/// the order of the linkage's drivers.
struct DriveSchedule {
  std::vector<std::variant<DriverRange, DriverPath>> motions;
  double duration = 1;  ///< s

  std::vector<double> values_at(double share) const;         ///< mm, rad
  std::vector<double> speeds_at(double share) const;         ///< mm/s, rad/s
  std::vector<double> accelerations_at(double share) const;  ///< mm/s^2, rad/s^2
};

/// One place of the motion.
struct RunFrame {
  double share = 0;            ///< of the motion, 0..1
  std::vector<double> values;  ///< of the drivers
  PlanarPosition position;
  Eigen::VectorXd rate;    ///< velocities of the unknowns
  Eigen::VectorXd second;  ///< their accelerations
};

/// Where a motion ended before its time, and why.
struct RunStop {
  PathEnd end = PathEnd::dead_point;
  double share = 0;                    ///< of the whole motion
  std::vector<std::string> sentences;  ///< which joints are in line, which links can still move
};

struct PlanarRun {
  /// At the even steps that were reached; then, if it stopped, the last good position.
  std::vector<RunFrame> frames;
  std::optional<RunStop> stop;
};

/// What ends a run before its time.
struct RunLimits {
  /// True ends the run as interrupted; looked at every so often, if there is one.
  std::function<bool()> stop;
  std::size_t steps = 0;  ///< certified steps tried, besides some for every part; 0: plenty_of_steps
};

/// Runs the motion from a closed position at its start, in `steps` equal parts. Rates are left empty at a
/// stop, where they do not exist.
tl::expected<PlanarRun, NoPathHere> run_motion(const PlanarLinkage& linkage, const PlanarPosition& start,
                                               const DriveSchedule& schedule, int steps,
                                               const RunLimits& limits = {});

/// Moves to one share of the motion, 0..1, and shows that place alone; or where it stopped before.
tl::expected<PlanarRun, NoPathHere> run_to(const PlanarLinkage& linkage, const PlanarPosition& start,
                                           const DriveSchedule& schedule, double share,
                                           const RunLimits& limits = {});

}  // namespace kempe
