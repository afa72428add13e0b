#pragma once
// The search for the pole and the layers with both lengths locked.

#include "synthesis/search/strategies/length_candidates.hpp"

namespace kempe {

/// The best design of a candidate's lengths over all its layers, sought around the poles that are promising without contact
/// and that of `any_lengths`. Without contact first: where no pole does there, no layers need to be looked at, and a pole that
/// does is a good place to start.
SearchResult best_with_locked_lengths(const SearchTask& task, const std::vector<Prospect>& prospects,
                                      const LengthCandidate& candidate,
                                      const std::optional<FoundDesign>& any_lengths);

}  // namespace kempe
