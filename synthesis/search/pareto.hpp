#pragma once
// Trade-offs: the front between two objectives.

#include <tl/expected.hpp>

#include "synthesis/search/search.hpp"

namespace kempe {

struct ParetoPoint {
  double a = 0, b = 0;  ///< the two objectives, mm, rad, mm^2 or kg
  FoundDesign design;
};

/// Of a spec without a front_fault(): the front from the best in `a` to the best in `b`, about `points` of them (at least 2), by the
/// epsilon constraint method: one objective is limited in even steps, the other made best. No point beats another in both. The spec's own
/// objective does not matter; all its limits hold at every point. With several sections to choose from the front is that
/// of all of them: each section's own front is made, with an equal share of the time, and what a design of another section
/// beats is left out. A spec without designs: why. Stopped early: what there was, perhaps nothing.
tl::expected<std::vector<ParetoPoint>, NoDesign> pareto_front(const Spec& spec, Objective a, Objective b,
                                                              int points, const SearchOptions& options);

}  // namespace kempe
