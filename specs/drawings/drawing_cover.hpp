#pragma once
// What of the table a drawing covers: the region that its strokes ask for.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"
#include "specs/drawings/curve_flattening.hpp"
#include "specs/drawings/region_file.hpp"

namespace kempe {

/// The region of a drawing's strokes:
///  - hull: the convex hull of all strokes, grown by the margin (a drawing on one line needs a margin);
///  - outline: what closed strokes enclose by the even-odd rule (an O has its hole); if outlines meet or cross, all
///    that any of them encloses, holes filled. Grown by the margin;
///  - strokes: all that is within the margin (> 0) of a stroke.
/// Open strokes whose ends meet to 1e-3 mm are joined before outlines are looked for. `remark` says what else
/// the drawing held; it becomes part of the error if there is nothing to cover.
tl::expected<Region, InputError> covered_region(const std::vector<DrawnStroke>& strokes,
                                                const std::string& remark, const std::string& file_name,
                                                const RegionFileOptions& options);

}  // namespace kempe
