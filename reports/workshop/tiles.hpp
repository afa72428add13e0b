#pragma once
// A drawing at 1:1 on several sheets, to be joined by marks.

#include <functional>
#include <vector>

#include "reports/workshop/frame.hpp"
#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

/// Draws something at 1:1 through the view.
using Draw = std::function<void(Sheet&, const View&)>;

/// What lies in `box` (mm) cut into sheets of this paper, the way round that takes fewer. Neighbours share a strip of
/// `tile_overlap` mm; in its middle a line to cut or fold along, and on it marks that stand at the same places on both.
/// A tile is named by column and row: A1 is at the lower left. None if it would take more
/// than `most_tiles`.
std::vector<Sheet> tiled(const Draw& draw, const Box& box, Paper paper, const SheetTitle& title);

inline constexpr double tile_overlap = 12;
/// What would take more sheets than these is not tiled.
inline constexpr int most_tiles = 40;

}  // namespace kempe::workshop
