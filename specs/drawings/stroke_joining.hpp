#pragma once
// Strokes that continue each other, made one: drawings often give an outline as loose lines and arcs.

#include <vector>

#include "specs/drawings/curve_flattening.hpp"

namespace kempe {

/// Joins open strokes whose ends lie within `gap` (mm, >= 0) of each other, wherever exactly two ends meet; a
/// chain that returns to its start becomes a closed stroke. Closed strokes and places where three or more
/// ends meet are left as they are. The joined stroke keeps both ends' points where they differ. O(n log n).
std::vector<DrawnStroke> joined(std::vector<DrawnStroke> strokes, double gap);

}  // namespace kempe
