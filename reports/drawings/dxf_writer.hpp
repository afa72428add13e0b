#pragma once
// A drawing as DXF of the oldest common version (R12, AC1009), which every CAD and laser program reads.

#include <string>

#include "reports/drawings/drawing.hpp"

namespace kempe {

/// The file's text: outlines as POLYLINE with bulges (true arcs), holes as CIRCLE, texts as TEXT, each layer
/// in the layer table, units mm ($INSUNITS 4), extents stated. Coordinates with 12 decimals, no exponents.
/// Characters beyond ASCII are written \U+XXXX, the form R12 readers know; line breaks in texts become
/// spaces.
std::string dxf_text(const Drawing& drawing);

}  // namespace kempe
