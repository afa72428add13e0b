#pragma once
// How the frames that verify loads take a plate: two straight pieces.

#include <algorithm>
#include <array>
#include <utility>

#include "kempe/mechanism.hpp"

namespace kempe {

/// The joints of a plate, that in its middle first: its corner, given first; of three joints in line the one between the others. The plate's
/// pieces go from there to the two others.
inline std::array<Joint, 3> middle_first(std::array<Joint, 3> joints, const Pose& pose, bool straight) {
  if (!straight) return joints;
  const Point axis = pose[joints[1]] - pose[joints[0]];
  std::sort(joints.begin(), joints.end(),
            [&](Joint a, Joint b) { return pose[a].dot(axis) < pose[b].dot(axis); });
  std::swap(joints[0], joints[1]);
  return joints;
}

}  // namespace kempe
