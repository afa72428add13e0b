#pragma once
// The driver of the search for one goal under given limits: what synthesize(), the diagnosis of specs without a design and the
// fronts share.

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The design with the best goal that keeps the limits, stock lengths included. Limits that let instruments reach farther than
/// the spec's may be given too. The result does not depend on the number of threads.
SearchResult best_design(const SearchTask& task);

/// The same by the search of every choice alone, which depends on the random numbers.
SearchResult best_by_choices(const SearchTask& task);

}  // namespace kempe
