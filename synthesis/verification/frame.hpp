#pragma once
// The linkage as a plane frame by the stiffness method: an independent path to what synthesis/loads/ has in closed form. It shares no formula
// with that: every link is elements between its joints, joints share displacements and not rotations, and the forces come out of a solve.

#include "kempe/pose.hpp"
#include "kinematics/grounding.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// For one newton at the pen, worst over its directions, while pole and tracer are held.
struct FrameResponse {
  double worst = 0, least = 0;  ///< mm: how far the pen gives way
  double pin_force = 0;         ///< N, at the pin of A, B, C, V and the pole that bears most
  double hand_force = 0;        ///< N, at the tracer
  double stress = 0;  ///< MPa, in the link that is strained most, over the section that `hole` leaves
};

/// A pose in which no change point or dead point is met; `hole` mm; a material with E > 0.
FrameResponse frame_response(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
                             const Material& material, double hole);

}  // namespace kempe
