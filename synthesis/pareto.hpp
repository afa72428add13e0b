#pragma once
// Trade-offs: the front between two objectives, each point a full design.

#include <vector>

#include "synthesis/search.hpp"

namespace kempe {

/// One design of a front: no design known is better in both objectives.
struct ParetoPoint {
  double first = 0, second = 0;  ///< in the objectives' units: mm, rad or mm^2
  FoundDesign design;
};

struct Front {
  std::vector<ParetoPoint> points;  ///< from the best in the first objective to the best in the second
  bool stopped = false;             ///< by time or by request: points may be missing
};

/// The front by epsilon constraints: its two ends are the best designs in either objective alone; between them one
/// objective keeps evenly spaced limits (transmission or copy error, which specs limit too, if one of them is asked for)
/// while the other is made as good as it can be. Points that
/// others beat in both are left out, so fewer than `count` (>= 2) may come back; none if the spec has no design.
/// Deterministic.
Front pareto_front(const Spec& spec, Objective first, Objective second, int count, const SearchOptions& options);

}  // namespace kempe
