#pragma once
// Regions and strokes grown by a margin.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/regions/region_checks.hpp"

namespace kempe {

/// Polylines: open or closed strokes of a drawing.
using Stroke = std::vector<Point>;

/// All points within `margin` (mm, >= 0) of the region, and a little more: arcs are replaced by the edges
/// around them, so the result contains the true one and exceeds it by less than half a percent of the margin.
/// Margin 0 gives the region back. The error is a sentence for a person.
tl::expected<Region, std::string> grown(const Region& region, double margin);

/// All points within `margin` (mm, > 0) of a stroke, and a little more, as above.
tl::expected<Region, std::string> grown(const std::vector<Stroke>& strokes, double margin);

/// The union of the areas of rings of either direction that may overlap, touch and lie in each other; one
/// that crosses itself counts as the area that ring_loops.hpp gives it. The error is a sentence for a person:
/// too many corners, or a union whose parts touch in a point.
tl::expected<Region, std::string> united(const std::vector<Ring>& rings);

/// assemble_region(), but outer rings that cross or touch each other are united first, as what they mean is
/// plain: all of them. Everything else is refused as there. Faults after a union name polygons of the union.
tl::expected<Region, RingFault> assemble_united_region(const std::vector<Ring>& outers,
                                                       const std::vector<Ring>& holes);

}  // namespace kempe
