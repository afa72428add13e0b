#pragma once
// The assembled linkage as STEP, for CAD programs.

#include <string>
#include <tl/expected.hpp>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A STEP file (AP214, mm): the four links as solids with true arcs and cylinders, finished (the kerf is not in them, the fit of the
/// holes is), at the heights of their layers, raised as heads under layer 1 ask for, in the pose of the drawing's assembly view, and the
/// pins and posts between them, as long as the bill says; each named ("ACX", "pin C"). The table is z = 0. The error is a sentence.
tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
