#pragma once
// The strategy for stock lengths (ratio_lengths.hpp): pairs of them in a good order, the pole and the
// layers sought for each. Where none keeps the spec's ratio, those of ratios next to it.

#include "synthesis/search/steps/relax.hpp"
#include "synthesis/search/steps/search_result.hpp"

namespace kempe {

/// The best design with stock lengths, given the best with any lengths. Size: the best of all. Other goals: the best of those
/// next to the best with any lengths. The design's linkage has another ratio than the spec where the stock lengths do not
/// allow the spec's. `relaxed`: all choices as that search relaxed them, in any order; or none.
SearchResult best_with_stock_lengths(const SearchTask& task, const SearchResult& any_lengths,
                                     std::vector<Prospect> relaxed);

}  // namespace kempe
