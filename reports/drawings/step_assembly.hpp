#pragma once
// The assembled linkage as STEP, for CAD programs: an optional part of the build, a module there if CMake finds
// OpenCASCADE (-DKEMPE_WITH_OCCT=OFF leaves it out). It is loaded when the first of these functions is called, by the
// dynamic loader's own search: beside the program that was built, in the library folder of one that was installed.

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "synthesis/design/design.hpp"

namespace kempe {

/// Why no STEP can be written here, with the command that mends it, a sentence; nothing where it can.
std::optional<std::string> why_no_step();

/// A STEP file (AP214, mm): the four links as solids with true arcs and cylinders, finished (the kerf is not in them, the fit of the
/// holes is), at the heights of their layers, raised as heads under layer 1 ask for, in the pose of the drawing's assembly view, and the
/// pins and posts between them, as long as the bill says; each named ("ACX", "pin C"). The table is z = 0. The error is a sentence; so is
/// the lack of the module.
tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
