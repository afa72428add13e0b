#pragma once
// Whether a design's copy lies on its original.

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// True if the region and its copy share more than a boundary; exact for the corners as doubles. False without a region.
bool copy_overlaps_original(const Design& design);

/// What a reader is told where that is so and no gap was asked for; else empty.
std::string overlap_note(const Design& design);

}  // namespace kempe
