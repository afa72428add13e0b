#pragma once
// Robust: what every instrument within the tolerances keeps, not the one alone that is drawn (docs/robust.md).
//
// For every instrument whose lengths and pins are off by no more than the tolerances, and every place of the region
// where its tracer is held: the linkage closes, its plates and dyads stay turned as drawn (so one assembly mode, no dead
// point and no change point), and parts that may not touch keep the clearance. The tolerances are those of the copy error
// (docs/tolerance.md). Limits on transmission angle, lengths, copy error and the sheets' gap speak of the drawn one.

#include <string>

#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/map_task.hpp"

namespace kempe {

/// What all instruments keep over the region.
struct RobustCheck {
  /// Each of them closes, with plates and dyads turned as drawn. False: not proven.
  bool closes = false;
  /// mm: no two parts of any instrument come nearer, and none comes nearer to an obstacle. -infinity where nothing is
  /// proven. Gaps larger than what the linkage's own parts keep are not looked for.
  double clearance = 0;
  std::string parts{};     ///< "link VA and link BCY": the pair that it was found at
  double at_distance = 0;  ///< mm: the tracer's distance from the pole there; 0 of obstacles
  double sharpness = 0;    ///< mm: how much larger, about, the smallest bound at a single distance may be
  double obstacle_shift =
      0;  ///< mm: no part that may meet an obstacle is farther from its place; 0 without obstacles

  /// True if every instrument is a design in place of the drawn one; `clearance` mm, the task's.
  bool keeps(double least) const { return closes && clearance >= least; }
};

/// What a design that is asked to be robust tells.
struct Robustness {
  bool holds = false;         ///< every instrument within the tolerances is a design: proven
  double clearance = 0;       ///< mm: no instrument has less; -infinity where nothing is proven
  double clearance_loss = 0;  ///< mm: what the drawn instrument has more at least
  /// Of the objective, in its own unit: what the best design found has that need not be robust. Absent for a given mechanism.
  std::optional<double> nominal_value{};
};

/// Proven, rounded outwards with the slack that docs/robust.md states, but for the drawn linkage's own gap to obstacles, which is the map's. The region must not
/// be empty. Takes some hundredths of a second.
RobustCheck check_robust(const MapTask& task, const CopyTolerance& tolerance);

/// Why a check does not keep a clearance (mm), for a person: "link VA and link BCY of some instruments may come within ...".
std::string robust_fault(const RobustCheck& check, double clearance);

/// True if designs must be robust.
inline bool asks_for_robust(const Spec& spec) { return spec.tolerance && spec.tolerance->robust; }

}  // namespace kempe
