#pragma once
// From a solution to a design that is certain: every limit anew, contact in closed form, obstacles over the whole region.

#include <limits>

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The candidate certified: feasible if its finished design keeps every limit. A place of the region where an obstacle is in
/// the way is added to the subproblem, a limit missed by a hair is demanded more strictly, and it is solved again; so the
/// result may be better or worse than the candidate. Once it costs `too_much` or more it is given up, and infeasible.
ChoiceResult certified(const SearchTask& task, Subproblem& subproblem, ChoiceResult candidate,
                       double too_much = std::numeric_limits<double>::infinity());

/// The finished design, all its figures measured; nothing if it misses a limit.
std::optional<FoundDesign> design_of(const SearchTask& task, const Subproblem& subproblem,
                                     const ChoiceResult& found);

}  // namespace kempe
