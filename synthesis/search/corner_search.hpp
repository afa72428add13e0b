#pragma once
// Designs whose limit on the copy error is kept beyond the first order too.

#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// `found`, the task's best design, if no instrument within the tolerances was found that breaks the limit on the copy error where the first
/// order understates it (corner_error.hpp). Else the best of the designs found with lower limits of the first order, of which this is true;
/// `found` again if none was. Its proven_bound is that of `found`: what no design beats, these do not beat either.
FoundDesign kept_at_corners(const SearchTask& task, const FoundDesign& found);

}  // namespace kempe
