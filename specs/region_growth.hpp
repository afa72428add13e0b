#pragma once
// Regions and strokes grown by a margin.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "specs/input_error.hpp"
#include "specs/region.hpp"

namespace kempe {

/// Polylines: open or closed strokes of a drawing.
using Stroke = std::vector<Point>;

/// All points within `margin` (mm, >= 0) of the region, and a little more: arcs are replaced by the edges
/// around them, so the result contains the true one and exceeds it by less than half a percent of the margin.
/// Margin 0 gives the region back. The error is a sentence for a person.
tl::expected<Region, std::string> grown(const Region& region, double margin);

/// All points within `margin` (mm, > 0) of a stroke, and a little more, as above.
tl::expected<Region, std::string> grown(const std::vector<Stroke>& strokes, double margin);

/// The union of simple rings of either direction that may overlap, touch and lie in each other.
tl::expected<Region, std::string> united(const std::vector<Ring>& rings);

/// grown() for a region that was read from a file, its error as InputError about region.margin_mm.
tl::expected<Region, InputError> grown_region(const Region& region, double margin,
                                              const std::string& file_name);

}  // namespace kempe
