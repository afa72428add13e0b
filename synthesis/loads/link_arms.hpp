#pragma once
// The arms of the links: the straight pieces between joints that bend when the linkage is loaded.

#include <array>
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

/// The two joints at which the material of a link with these arms ends, half a width beyond each.
std::array<Joint, 2> ends_of(const std::vector<LinkArm>& arms);

}  // namespace kempe
