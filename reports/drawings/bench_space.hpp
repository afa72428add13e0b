#pragma once
// The room that an instrument takes at work.

#include <optional>

#include "synthesis/design/design.hpp"

namespace kempe {

/// The convex outline of all that a body sweeps while the tracer covers the region, mm; empty without a region. A body that turns with a
/// link counts with its circle about the point that carries it, a circle with an outline of lines around it.
Region swept_outline(const Design& design, const Body& body);

/// The smallest upright rectangle around all that links and bodies sweep while the tracer covers the region, mm; of the links as far
/// as the footprint is known and bounds it, of bodies as swept_outline() does. Nothing
/// where neither footprint nor bodies are known.
std::optional<Box> swept_box(const Design& design);

}  // namespace kempe
