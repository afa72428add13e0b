#pragma once
// The linkage as a frame in space by the stiffness method: every link's pieces are beams at the height of its layer's middle, every pin is a beam
// from layer to layer that turns freely in the upper link, the post is clamped in the table. An independent path to what layers and pins add to
// the load error (synthesis/loads/layer_offsets.hpp): no grillage, no force and no compliance of that is used.

#include <Eigen/Core>

#include "kempe/pose.hpp"
#include "kempe/spec.hpp"
#include "kinematics/grounding.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// What the linkage is made of.
struct SpaceFrameParts {
  bool straight = false;  ///< the joints of each plate lie in line
  LinkStyle style{};
  JointHardware hardware{};
  LayerAssignment layers{};
  double E = 0, G = 0;  ///< MPa, of the links
};

/// For one newton at the pen while pole and tracer are held in the plane; mm, in the frame of the pose.
struct SpaceFrameResponse {
  Eigen::Matrix2d in_plane;                  ///< how the pen gives way; a column for each axis of the force
  Eigen::RowVector2d tracer_rise, pen_rise;  ///< upwards

  /// The most of each over the directions of the force.
  double give() const;
  double rise() const;  ///< of tracer or pen, up or down
};

/// A pose in which no change point or dead point is met; links with E and G > 0. Points that rest on the table keep their height.
SpaceFrameResponse space_frame_response(const Pose& pose, const JointRoles& roles,
                                        const SpaceFrameParts& parts, bool tracer_rests, bool pen_rests);

}  // namespace kempe
