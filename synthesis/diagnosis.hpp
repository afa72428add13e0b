#pragma once
// Why a spec has no design: every limit moved alone, as little as makes a design possible.

#include "synthesis/search_run.hpp"

namespace kempe {

/// Each limit made a goal of its own while all others hold; then the spec is searched again with that limit
/// moved to a round value, so that every relaxation comes with a design.
/// `nothing`: the outcome of the search for the spec itself.
NoDesign diagnose(const SearchRun& run, const SearchResult& nothing);

}  // namespace kempe
