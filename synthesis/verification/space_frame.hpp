#pragma once
// The linkage as a frame in space by the stiffness method: every link's pieces are beams at the height of its layer's middle, every pin is a beam
// from layer to layer that turns freely in the upper link, the post is clamped in the table. An independent path to what layers and pins add to
// the load error (synthesis/loads/layer_offsets.hpp): no grillage, no force and no compliance of that is used. The table's push on points that
// rest on it is found from how far an upward newton there lifts them: no support is held.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "kempe/mechanism.hpp"
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
  /// What pulls at right angles to the table, downwards: N for each mm^3 of the links, and N at tracer and pen.
  double link_weight = 0, tracer_weight = 0, pen_weight = 0;
  double link_pull = 0;  ///< N for each mm^3 of the links along the table, which pull some way there
};

/// A piece of a link between two of its joints.
struct SpaceFramePiece {
  Link link{};
  double length = 0;  ///< mm
  double weight = 0;  ///< N/mm
  /// On its end where it begins: forces along the piece, to its left and upwards, N, and moments about these axes, N mm. A column for each:
  /// a newton on the pen along x and along y; the weights; an upward newton at the tracer and at the pen; the links' pull along x and along y.
  Eigen::Matrix<double, 6, 7> forces{};
  /// N/mm, along the piece and to its left: the links' pull along x and along y.
  Eigen::Matrix2d pulls = Eigen::Matrix2d::Zero();
};

/// Of the frame on its post alone, pole and tracer held in the plane; mm, in the frame of the pose. Rows of two: tracer, pen.
struct SpaceFrameResponse {
  Eigen::Matrix2d in_plane;  ///< how the pen gives way; a column for each axis of a force of one newton on it
  Eigen::Matrix2d rises;     ///< upwards, by the same forces
  Eigen::Matrix2d lifts;     ///< upwards, by an upward newton at the tracer, at the pen
  Eigen::Vector2d weighed;   ///< upwards, by the weights
  /// The same as by the force, by the links' pull along x and along y.
  Eigen::Matrix2d in_plane_by_pull = Eigen::Matrix2d::Zero(), rises_by_pull = Eigen::Matrix2d::Zero();
  std::vector<SpaceFramePiece> pieces{};  ///< of all links
};
/// A pose in which no change point or dead point is met; links with E and G > 0.
SpaceFrameResponse space_frame_response(const Pose& pose, const JointRoles& roles,
                                        const SpaceFrameParts& parts);

/// What a table under the frame may bear: it pushes up and never pulls.
struct FrameTable {
  bool tracer_rests = false, pen_rests = false;
  Eigen::Vector2d free_rises =
      Eigen::Vector2d::Zero();  ///< mm, of tracer and pen by the weights without the table
};

/// What a force on the pen, N, does to the frame on a table beside what the weights do; mm.
struct FrameMovement {
  Eigen::Vector2d give, rises;
};
FrameMovement movement(const SpaceFrameResponse& response, const FrameTable& table, const Point& force);

/// The most of each over all directions of a force of that size, N: how far the pen gives way, and tracer or pen rises or sinks; mm.
struct MostOfFrame {
  double give = 0, rise = 0;
};
MostOfFrame most_movement(const SpaceFrameResponse& response, const FrameTable& table, double force);

/// MPa: the largest equivalent stress in a link by the weights and a force of that size, N, on the pen, over all its directions; links have
/// a hole so wide (mm, less than their width) at every joint. Bending in the plane and out of it and pull at the section's corner, with the
/// largest shear of the torsion as von Mises has it. `only`: in that link.
double most_stress(const SpaceFrameResponse& response, const FrameTable& table, double force,
                   const LinkStyle& style, double hole, std::optional<Link> only = std::nullopt);

/// What the links' pull does at most, whichever way along the table it goes and whichever of the resting points bear meanwhile.
struct MostByPull {
  double give = 0, rise = 0;       ///< mm
  std::array<double, 4> stress{};  ///< MPa, of each link; 0 without a hole
};
/// `hole`: mm, less than the links' width; absent: no stress is asked for.
MostByPull most_by_pull(const SpaceFrameResponse& response, const FrameTable& table, const LinkStyle& style,
                        std::optional<double> hole);

}  // namespace kempe
