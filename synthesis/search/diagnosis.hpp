#pragma once
// Why a spec has no design: every limit moved alone, as little as makes a design possible.

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// Each limit made a goal of its own while all others hold; then the spec is searched again with that limit
/// moved to a round value, so that every relaxation comes with a design.
/// `task`: the spec's own limits and objective; `nothing`: what its search came back with.
/// Obstacles are taken away one by one.
NoDesign diagnose(const SearchTask& task, const SearchResult& nothing);

/// What no search is needed for: a fixed pole inside the region, or an obstacle over it.
std::optional<NoDesign> plainly_impossible(const Spec& spec);

}  // namespace kempe
