#pragma once
// A ring that crosses itself, taken apart into simple rings that cover the same ground.

#include <optional>
#include <vector>

#include "geometry/region.hpp"

namespace kempe {

/// Splits a closed ring at every point where it meets itself.
///  1. Every ring that comes back is simple, has at least three corners and runs counter-clockwise.
///  2. Together they cover every point that the ring winds around (winding number not 0), up to the rounding of the
///     crossing points (one unit in the last place). They may cover more: a part that the ring circles once each way.
///  3. The rings may overlap each other.
/// Nothing comes back if the ring crosses itself so often that the work would exceed `corner_visits`.
/// Expects finite coordinates.
std::optional<std::vector<Ring>> simple_loops(const Ring& ring, std::size_t corner_visits = 10'000'000);

}  // namespace kempe
