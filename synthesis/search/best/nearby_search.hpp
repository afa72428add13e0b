#pragma once
// Local searches around a design that is known.

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The better of a design, if there is one, and what a local search from `start` makes of it.
SearchResult best_from(const RelaxedDesign& start, const SearchTask& task, SearchResult found);

/// The better of a design and what local searches from random places around it find, ever nearer ones. `while_better`: no further round
/// after one that found nothing better.
SearchResult basin_hopping(const SearchTask& task, SearchResult found, bool while_better = false);

}  // namespace kempe
