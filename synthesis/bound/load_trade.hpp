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
//   reach     log((H + cos near end) w / (c r)^2),  log((c r)^2 / (H + cos far end) w)
//   size      size / best - 1, where size is the goal
//   load      (root(load error / limit) - 1) |sin d| in one direction, at each of the two places (load_waves.hpp)
//
// and, where it is asked for, one of those of touches:
//
//   contact   1 - (distance / needed)^2 of two points of the linkage
//   obstacle  1 - distance / needed of a part and an obstruction, as their nearest features tell it
//
// Coordinates: the logarithms of t and w (box.hpp, with c and H), and where the pole stands, from which a place has the distance r. The reach is
// linear in the logarithm of w.

#include <memory>
#include <optional>

#include "specs/spec.hpp"
#include "synthesis/bound/touches.hpp"

namespace kempe::bounding {

class LoadWaves;

/// Lengths, and places of the pole (mm).
struct DesignRange {
  LengthBox lengths;
  Range x, y;
};

/// What designs of a box have to do to be better than the best known.
struct BetterDesign {
  double transmission;         ///< rad: a transmission angle above it
  std::optional<double> size;  ///< mm: a size below it
};

/// Of one grounding and assembly mode.
class LoadTrade {
 public:
  /// Of a spec with load, material and a limit on the load error.
  LoadTrade(const Spec& spec, const ModeFacts& mode);

 private:
  friend class BoxTrade;
  ModeFacts mode_;
  std::shared_ptr<const LoadWaves> loads_;
};

/// Of one box. What is said is said with directed rounding; doubles choose the weights.
class BoxTrade {
 public:
  /// The box and the trade must outlive it.
  BoxTrade(const LoadTrade& trade, const ReachedPlaces& places, const DesignRange& box,
           const BetterDesign& better);
  ~BoxTrade();
  BoxTrade(const BoxTrade&) = delete;
  BoxTrade& operator=(const BoxTrade&) = delete;

  /// True if no design of the box does all of these: reaches both places, keeps the limit and is better.
  bool none_better() const;
  /// True if no better design keeps the points apart.
  bool none_better_without(const ContactTouch& touch) const;
  /// True if no better design keeps the part clear.
  bool none_better_without(const ObstacleTouch& touch) const;

 private:
  struct Figures;
  std::unique_ptr<const Figures> figures_;
};

}  // namespace kempe::bounding
