#pragma once
// What a box loses by the limit on the load error together with the goal: is every design of it too soft, or no better than the best known?
//
// A box may hold designs that are stiff enough and others that are good enough, and none that is both. Then a weighted sum of what they miss is
// positive all over the box. Along the limit, where both trade off against each other, the sum changes only by the square of the box's width:
// it is bounded by its value in the middle and its slopes over the box, so that such boxes need not be split on and on.
//
// Figures, each at most 0 for a design that is better than the best known and keeps the limit; psi at the two distances that every design of
// the box covers:
//
//   reach  psi_near - near end + mu,  far end + mu - psi_far
//   size   size / best - 1, where size is the goal
//   load   load error in one direction / limit - 1, at each of the two psi

#include <optional>

#include "specs/spec.hpp"
#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

/// Of one grounding and assembly mode.
class LoadTrade {
 public:
  /// Of a spec with load, material and a limit on the load error.
  LoadTrade(const Spec& spec, const ModeFacts& mode);

  /// True if no design of the box that covers the distances keeps the limit, has a transmission angle above `transmission` (rad) and, where it
  /// is given, is smaller than `size` (mm). Said with directed rounding; doubles choose the weights.
  bool none_better(const PoleDistances& distances, const LengthBox& lengths, double transmission,
                   std::optional<double> size) const;

 private:
  ModeFacts mode_;
  double limit_;
  double force_, E_, width_, thickness_;
};

}  // namespace kempe::bounding
