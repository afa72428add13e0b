#pragma once
// The assembled linkage as STEP, for CAD programs: an optional part of the build, there if CMake finds
// OpenCASCADE (-DKEMPE_WITH_OCCT=OFF leaves it out).

#include <string>
#include <tl/expected.hpp>

#include "synthesis/design.hpp"

namespace kempe {

/// True if this build can write STEP.
bool can_write_step();

/// A STEP file (AP214, mm): the four links as solids with true arcs and cylinders, in their layers, in the
/// pose of the drawing's assembly view, and the pins and posts between them; each named ("ACX", "pin C"). The
/// table is z = 0. The error is a sentence; so is the lack of the component.
tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
