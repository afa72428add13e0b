#pragma once
// What stands out at a singular position: joints in line, rods square to their guides, links that can still
// move.

#include <string>
#include <vector>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// Sentences about a position at which the drivers lock or lose hold of the linkage, in the constraints' and
/// bodies' names: first the joints in line ("A, B and C in line (crank, rod)"), then rods square to the line
/// they slide on, then the links that can move while the drivers stand still. Angles within `tolerance` (rad)
/// count as exact.
std::vector<std::string> describe_singularity(const PlanarLinkage& linkage, const PlanarPosition& position,
                                              double tolerance = 1e-5);

}  // namespace kempe
