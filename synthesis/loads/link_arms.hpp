#pragma once
// The arms of the links: the straight pieces between joints that bend when the linkage is loaded.

#include <vector>

#include "kinematics/links.hpp"

namespace kempe {

/// A straight piece of a link between two of its joints.
struct LinkArm {
  Joint from, to;
};

/// A bar is one arm. A plate has two: of a bent plate and of a triangle, which is stiffer, those from its corner; a straight plate is one
/// beam through its joints in their order.
std::vector<LinkArm> arms_of(Link link, Complex shape);

}  // namespace kempe
