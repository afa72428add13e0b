#pragma once
// Why a spec has no design: every limit moved alone, as little as makes a design possible.

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// What a diagnosis comes back with.
struct Diagnosis {
  NoDesign none;
  /// A design that keeps every limit of the spec: the search had missed it, a search with a limit moved came to it.
  std::optional<FoundDesign> permitted{};
};

/// `task`: the spec's own limits and objective; `nothing`: what its search came back with; `origin`: where the task's
/// coordinates have their zero on the table, mm. Guarantees:
///  1. every relaxation comes with a design that keeps the spec with that change alone;
///  2. where there is none, every single change that `sentence` lists has been searched in vain, from several random numbers.
///     That is a search's word: `proven` speaks of the spec as it is alone.
/// Limits, holes and obstacles are looked at always; the pole's place and what else restricts designs where those are of no
/// avail. A design that keeps every limit after all ends the questions.
Diagnosis diagnose(const SearchTask& task, const SearchResult& nothing, const Point& origin);

/// The same for a spec that is plainly_impossible() for `reason`: what can help against it alone.
NoDesign diagnose_plain(const SearchTask& task, NoDesign reason, const Point& origin);

}  // namespace kempe
