#pragma once
// Obstacles for the proven bound: is a part in an obstacle in every design of a box, with the tracer at some place?
//
// Around the middle design of the box no joint moves farther than joint_moves.hpp says. Signed distances of convex sets change
// by no more than their corners move, so an overlap in the middle that is deeper than the largest of these is an overlap in
// every design.

#include <memory>

#include "kinematics/stop_flag.hpp"
#include "synthesis/bound/joint_moves.hpp"
#include "synthesis/bound/layer_set.hpp"
#include "synthesis/problem/obstacle_gap.hpp"

namespace kempe::bounding {

/// A part in an obstacle, with the tracer at a place: where to look first.
struct Hit {
  std::size_t place = 0, term = 0;
};

/// The obstacles of a spec, seen by one grounding and assembly.
class ObstacleTest {
 public:
  /// Assignments are known by their place in `layers`. Once `stop` is set, no more is ruled out and no design is found clear.
  ObstacleTest(const Spec& spec, const AssemblyMode& assembly_mode,
               const std::vector<LayerAssignment>& layers, StopFlag stop = {});

  /// The assignments of `alive` in which no obstacle is surely hit. `hint`: a hit of the box this one was split from; set to
  /// the one that came nearest to certain. With `only_hint` nothing else is looked at.
  LayerSet not_hit(const DesignBox& box, LayerSet alive, std::optional<Hit>& hint, bool only_hint) const;

  /// What not_hit() without a hint costs, in tests of a box for reach.
  std::size_t cost() const { return 1 + places_.size() * terms_.size() / 300; }

  /// True if a design keeps its clearance at very many places. One where it does not is looked at in every box from then on.
  bool is_clear(double VA, double VB, const Point& pole, std::size_t layers);

 private:
  struct Term {
    ObstacleTerm what;
    LayerSet layers{};  ///< in which it counts
  };
  double gap_rounding(const Term& term, const PlacedJoints& joints) const;

  AssemblyMode assembly_mode_;
  Reach reach_;
  JointRoles roles_;
  double clearance_;
  std::vector<ObstacleShape> shapes_;
  std::vector<Point> places_;       ///< looked at in every box
  std::vector<Point> many_places_;  ///< looked at for single designs
  std::vector<Term> terms_;
  StopFlag stop_;
};

}  // namespace kempe::bounding
