#pragma once
// Trade-offs: the front between two objectives.

#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"

namespace kempe {

/// A point of a front: no other of its points is better in both objectives.
struct FrontPoint {
  double first = 0;   ///< the first objective's value: mm, rad (transmission), mm^2 (footprint) or kg (mass)
  double second = 0;  ///< the second's
  FinishedDesign design;  ///< without a bound, which would be that of the spec's own objective
};

/// A front, from the best in the first objective to the best in the second.
struct Front {
  std::vector<FrontPoint> points;              ///< in that order
  bool complete = true;                        ///< false: stopped early, points are missing
  Objective first = Objective::size;           ///< of FrontPoint::first
  Objective second = Objective::transmission;  ///< of FrontPoint::second
};

/// The front between two objectives by the epsilon constraint method (docs/search.md): about `points` designs, at least 2; fewer where
/// searches give the same design again. Of several sections each has a front of about `points`; what a design of another section beats
/// is left out. All limits of the spec hold at every point, its own objective plays no part. Or, as an Outcome, why there is none; a
/// robust spec and one that lacks what an objective needs are faults, and so are two objectives that are one, and points outside 2 to
/// 200 (keys "between", "points").
KEMPE_EXPORT std::variant<Front, Outcome> front(const Spec& spec, Objective first, Objective second,
                                                int points = 15, const Options& options = {});

}  // namespace kempe
