#pragma once
// An independent answer to what loads in the plane do to a copying linkage: a frame of beam elements with pins, solved as a
// whole. It knows joints, sections and who holds what, and none of the formulas of the library.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace kempe::test {

enum FrameJoint { joint_V, joint_A, joint_B, joint_C, joint_X, joint_Y };

/// A copying linkage at one position, and its material. Lengths in mm, forces in N.
struct FrameTask {
  std::array<Point, 6> joints;                                 ///< V, A, B, C, X, Y
  FrameJoint pole = joint_X, tracer = joint_V, pen = joint_Y;  ///< V, X and Y in any order
  double width = 6, thickness = 2;                             ///< of every arm; the width lies in the plane
  double young = 200000;                                       ///< modulus, N/mm^2
  /// A straight plate is one beam through its three joints in their order along it; else two arms from the corner A or B, joined
  /// stiffly there.
  bool straight_ACX = false, straight_BCY = false;
  /// How far the two sides of a pin part per newton between them, mm/N, at V, A, B and C. At V it is the pin of VB: VA holds the
  /// tool there, or sits on the post.
  std::array<double, 4> pin_compliance{};
  double pole_compliance = 0;  ///< of the post, which bears all links at the pole
};

/// All for a unit force at the pen along x (first column) and along y (second), with post and tracer held.
struct FrameAnswer {
  Eigen::Matrix2d compliance;  ///< movement of the pen, mm/N
  Eigen::Matrix2d hand, pole;  ///< force of the hand on the tracer, of the post on the pole
  std::array<Eigen::Matrix2d, 3>
      pins;  ///< at A and B on the plate there, from the bar; at C on BCY, from ACX

  /// A piece of a link between neighbouring joints. VA and VB come first, then two pieces of ACX, two of BCY.
  struct Beam {
    FrameJoint from, to;
    Eigen::RowVector2d pull;  ///< N, along it
    Eigen::Matrix2d moments;  ///< N mm, at `from` (row 0) and `to`: on the beam, counter-clockwise
  };
  std::vector<Beam> beams;
};

/// Solves the frame. Throws std::runtime_error where it is no frame: at a dead point.
FrameAnswer solve_frame(const FrameTask& task);

}  // namespace kempe::test
