#pragma once
// The search: from a spec to the best design that keeps every limit, or to the reason why there is none.

#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/search_options.hpp"

namespace kempe {

/// The best design for a spec without a search_fault(). Guarantees:
///  1. a design returned keeps every limit of the spec, evaluated anew and its contact certified;
///  2. the same spec, seed and budgets give the same outcome, bit for bit, for any number of threads (unless stopped early);
///  3. what comes back after a stop is marked as incomplete, and NoDesign comes back only where the whole search found
///  nothing, or a proof did. Under a time limit a first design is sought before the best one.
SearchOutcome synthesize(const Spec& spec, const SearchOptions& options);

}  // namespace kempe
