#pragma once
// After the search: the proven bound, and more search while the gap to it is wide.

#include <functional>

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The best of a search and of others from further random numbers, told as the first one's; where these cannot matter, of the one search.
SearchResult searched_again(const SearchTask& task, SearchResult found,
                            const std::function<bool(const SearchResult&)>& is_enough);

/// The design with its proven bound; improved where the bound's tree met a better one or the bound is far away.
SearchResult improved(const SearchTask& task, SearchResult found);

}  // namespace kempe
