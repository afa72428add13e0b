#pragma once
// Where the linkage in the middle of a box touches itself or an obstruction, or nearly: what other designs of the box are asked about.

#include <array>
#include <optional>

#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

/// Two points of parts that share a layer, which have to keep `needed` (mm, clearance included) apart: at the place of the tracer that is
/// nearest to the pole, at the one that is farthest from it, or at an opening that every design of the box passes.
struct ContactTouch {
  enum class At { near, far, psi } at = At::psi;
  double psi = 0;  ///< of the last, |psi| in rad
  MaterialPoint first, second;
  double needed = 0;
};

/// A corner of a part, or of an obstruction, and the corner or edge of the other that is nearest to it with the tracer at a place. They have to keep
/// `needed` (mm, clearance included) apart.
struct ObstacleTouch {
  Point place;
  std::optional<Joint> seen_from{};  ///< that carries the obstruction's frame; absent: the table's
  bool corner_is_of_part = true;
  bool is_edge = false;            ///< what the other has: an edge, or a corner
  std::array<Joint, 2> joints{};   ///< the part's corner, or the ends of its edge
  std::array<Complex, 2> fixed{};  ///< mm: the same of the obstruction, in its frame
  double side = 1;                 ///< of an edge: on which the corner lies, 1 left, -1 right
  double needed = 0;
};

}  // namespace kempe::bounding
