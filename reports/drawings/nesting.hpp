#pragma once
// The parts laid on sheets of a given size.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "reports/drawings/part_drawings.hpp"

namespace kempe {

/// Where a part lies: on which sheet (from 0) and how it is turned and moved there; the sheet's lower left
/// corner is the origin.
struct NestedPart {
  std::size_t sheet = 0;
  Placement placement;
};

/// Lays outlines on sheets of `size` (width and height, mm), each at least `gap` (mm, >= 0) from the next and
/// from the sheet's edge, in their order of area, each at the lowest and then leftmost free place of a grid
/// in the turn of a quarter that ends lowest. A simple first fit, not the tightest nesting there is: the real
/// outlines count, not their boxes, and no overlap is possible. An outline that fits only at another angle is
/// turned in steps of 5 degrees; one that fits at none is named in the error. Deterministic.
tl::expected<std::vector<NestedPart>, std::string> nest(const std::vector<CutPart>& parts, const Point& size,
                                                        double gap);

/// The sheets side by side, their edges on the layer SHEET, the parts as part_drawing() draws them.
Drawing nested_drawing(const std::vector<CutPart>& parts, const std::vector<NestedPart>& nested,
                       const Point& size);

}  // namespace kempe
