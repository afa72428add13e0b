#pragma once
// Intervals of the opening d = arg q - arg p, the one inner freedom of the copying linkage.

#include <optional>
#include <vector>

#include "kempe/mechanism.hpp"

namespace kempe {

/// The openings in both; empty if there are none.
OpeningInterval intersect(const OpeningInterval& a, const OpeningInterval& b);

/// The interval without `margin` (rad, >= 0) at each end.
OpeningInterval shrink(const OpeningInterval& interval, double margin);

/// The widest of the intervals (the first of equals); nothing for none.
std::optional<OpeningInterval> widest(const std::vector<OpeningInterval>& intervals);

}  // namespace kempe
