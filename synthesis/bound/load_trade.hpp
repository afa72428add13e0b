#pragma once
// What a box loses by the limit on the load error together with the goal: is every design of it too soft, or no better than the best known?
//
// A box may hold designs that are stiff enough and others that are good enough, and none that is both. Then a weighted sum of what they miss is
// positive all over the box. Each figure is bounded from below by its value in the middle and slopes from there, less what its second
// derivatives can take away; so is their sum. The weights, from a linear program, are those with which the slopes cancel best. What is
// lost goes with the square of the box's width, so boxes along the limit need not be split on and on.
//
// Figures, each at most 0 for a design that is better than the best known and keeps the limit, at two places of the tracer:
//
//   reach  log((H + cos near end) w / (c r)^2),  log((c r)^2 / (H + cos far end) w)
//   size   size / best - 1, where size is the goal
//   load   (root(load error / limit) - 1) |sin d| in one direction, at each of the two places (load_waves.hpp)
//
// Coordinates: the logarithms of t and w (box.hpp, with c and H), and where the pole stands, from which a place has the distance r. The reach is
// linear in the logarithm of w.

#include <memory>
#include <optional>

#include "specs/spec.hpp"
#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

class LoadWaves;

/// Lengths, and places of the pole (mm).
struct DesignRange {
  LengthBox lengths;
  Range x, y;
};

/// Of one grounding and assembly mode.
class LoadTrade {
 public:
  /// Of a spec with load, material and a limit on the load error.
  LoadTrade(const Spec& spec, const ModeFacts& mode);

  /// True if no design of the box does all of these: reaches both places, keeps the limit, has a transmission angle above `transmission` (rad)
  /// and, where it is given, is smaller than `size` (mm). Said with directed rounding; doubles choose the weights.
  bool none_better(const ReachedPlaces& places, const DesignRange& box, double transmission,
                   std::optional<double> size) const;

 private:
  ModeFacts mode_;
  std::shared_ptr<const LoadWaves> loads_;
};

}  // namespace kempe::bounding
