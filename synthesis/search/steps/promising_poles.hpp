#pragma once
// Where a free pole is worth a look: a global search over the pole alone.

#include "synthesis/search/steps/local_search.hpp"

namespace kempe {

/// The best poles, a few pairs of lengths tried at each; none if the pole is fixed. Meant for problems without contact.
std::vector<Point> promising_poles(const DesignProblem& problem, const PoleBudget& budget,
                                   const LocalBudget& local, const StopFlag& stop);

}  // namespace kempe
