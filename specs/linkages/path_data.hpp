#pragma once
// SVG path data ("M 0 0 C ...") as pieces of a path.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/driver_motion.hpp"

namespace kempe {

/// The pieces of one sub-path: lines, circular arcs, cubics. All commands of SVG 1.1, absolute and relative;
/// quadratic curves become cubics exactly, elliptic arcs cubics of at most 15 degrees (1e-9 of the ellipse's
/// size off). Numbers are taken as they stand, times `unit` (mm). The error is a sentence that
/// quotes what follows the fault. A second sub-path (the pen lifted) is refused, as are pieces of no length at all.
tl::expected<std::vector<PathPiece>, std::string> read_path_data(std::string_view data, double unit = 1);

}  // namespace kempe
