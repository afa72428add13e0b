#pragma once
// Robust designs: the nominal optimum, and where some instrument within the tolerances would fail, designs with limits
// raised by what the instruments lose, until every instrument keeps the spec's own.

#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// A robust design for a task whose spec asks for one, `nominal` being its best design that need not be robust. Guarantees:
///  1. a design that comes back is robust by check_robust(), and keeps every limit of the spec;
///  2. its proven_bound is the nominal one's: what no design beats, no robust design beats;
///  3. NoDesign says that none was found, not that none exists; among its relaxations is the nominal design, with
///  robust = false.
/// It is no proven optimum: of the designs that the rounds come to it is the best.
SearchOutcome make_robust(const SearchTask& task, const FoundDesign& nominal);

/// The same reason, its relaxations told as what they are: designs that need not be robust.
NoDesign told_without_robust(NoDesign none);

}  // namespace kempe
