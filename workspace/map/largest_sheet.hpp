#pragma once
// The largest rectangles that fit a region: what else an instrument could draw on.

#include <optional>
#include <string_view>

#include "kinematics/stop_flag.hpp"
#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// The largest rectangle found whose width is `proportion` times its height (> 0) and that lies in one
/// polygon of the region, at the best turn or, if not `turned`, upright or on its side. It certainly fits;
/// that none larger would is not proven (seen in the tests: within 0.5 % of the best for annuli). Nothing if
/// the region is empty. Stopped, the best so far, which may be none; so below.
std::optional<FittingSheet> largest_rectangle(const ArcRegion& region, double proportion, bool turned,
                                              const StopFlag& stop = {});

/// The largest sheet A0..A8 that fits, upright or on its side if there is room for it so, else at the best
/// turn; nothing if A8 does not fit. Named "A0".."A8"; width is the longer side.
std::optional<FittingSheet> largest_iso_sheet(const ArcRegion& region, const StopFlag& stop = {});

/// mm, width and height of "A0".."A8"; nothing for other names.
std::optional<Point> format_size(std::string_view name);

/// Both of the above for a map: the ISO sheet, and the rectangle of the proportions of `like`'s bounding box. On up to `threads` threads,
/// whose number changes nothing.
std::vector<FittingSheet> largest_sheets(const ArcRegion& free, const Region& like, const StopFlag& stop = {},
                                         int threads = 1);

}  // namespace kempe
