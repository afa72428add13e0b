#pragma once
// What no search is needed for: the pole in the region or under an obstacle, a copy on its original, holes too near, a post that tilts too far.

#include <optional>

#include "specs/spec.hpp"
#include "specs/spec_keys.hpp"
#include "synthesis/search/steps/outcome.hpp"

namespace kempe {

/// The reason why no linkage whatsoever is a design for the spec, with its place and what must change; nothing where none of
/// these is in the way. `unit`: as in SearchOptions. What must change need not be enough: diagnose_plain() says whether it is.
std::optional<NoDesign> plainly_impossible(const Spec& spec, SpecUnit unit = SpecUnit::mm);

/// Of these what holds of a given mechanism too: a fixed pole under an obstacle, or off the table.
std::optional<NoDesign> pole_blocked(const Spec& spec, SpecUnit unit = SpecUnit::mm);

}  // namespace kempe
