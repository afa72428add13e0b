#pragma once
// The linkage as a plane frame by the stiffness method: an independent path to what synthesis/loads/ has in closed form. It shares no formula
// with that: every link is elements between its joints, joints share displacements and not rotations, and the forces come out of a solve.

#include <Eigen/Core>
#include <array>

#include "kempe/mechanism.hpp"
#include "kinematics/grounding.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// For one newton at the pen, worst over its directions, while pole and tracer are held.
struct FrameResponse {
  double worst = 0, least = 0;  ///< mm: how far the pen gives way
  double pin_force = 0;         ///< N, at the pin of A, B, C, V and the pole that bears most
  double hand_force = 0;        ///< N, at the tracer
  double stress = 0;  ///< MPa, in the link that is strained most, over the section that `hole` leaves
  std::array<double, 4> pins{};      ///< N, at A, B, C and on the pole's post
  std::array<double, 4> stresses{};  ///< MPa, of VA, VB, ACX and BCY
};

/// A pose in which no change point or dead point is met; `hole` mm; a material with E > 0.
FrameResponse frame_response(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
                             const Material& material, double hole);

/// What the links' own weight does, worst over the ways along the table that it may pull, while pole and tracer are held.
struct FrameUnderWeight {
  double most = 0;  ///< mm: how far the pen moves
  Eigen::Matrix2d moved =
      Eigen::Matrix2d::Zero();   ///< mm, the pen, by a pull along x and along y of the pose
  std::array<double, 4> pins{};  ///< N, at either end of VA, at either end of VB, at C and on the pole's post
  std::array<double, 4> stresses{};  ///< MPa, of VA, VB, ACX and BCY, anywhere along them
};

/// The same under `pull`, N for each mm^3 of the links. Weights lie along the pieces and go to their ends as forces and moments that move these
/// as the spread weight does; half discs at a link's ends, and a triangle at its corners.
FrameUnderWeight frame_under_weight(const Pose& pose, const JointRoles& roles, bool straight,
                                    const LinkStyle& style, const Material& material, double hole,
                                    double pull);

}  // namespace kempe
