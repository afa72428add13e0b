#pragma once
// Obstacles, bodies and the table's edge for the proven bound: is a part in one of them in every design of a box, with the tracer at
// some place?
//
// Around the middle design of the box no joint moves farther than joint_moves.hpp says. Signed distances of convex sets change
// by no more than their corners move, so an overlap in the middle that is deeper than the corners of the part's piece move is
// an overlap in every design. A body is at rest seen from the joint that carries it, so there the same holds of what joints move as
// seen from that joint. That a body meets an obstacle, the edge or another body is a matter of places of tracer and pen alone, which
// the copy fixes: it is so in every design, reached or not. So it is of the links' ends at tracer and pen.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "synthesis/bound/joint_moves.hpp"
#include "synthesis/bound/layer_set.hpp"
#include "synthesis/bound/place_groups.hpp"
#include "synthesis/bound/touches.hpp"
#include "synthesis/problem/obstacle_gap.hpp"

namespace kempe::bounding {

/// A part in an obstruction, with the tracer at a place: where to look first.
struct Hit {
  std::size_t place = 0, term = 0;
};

/// Places and, of each, terms that follow each other.
struct PlacesWithTerms {
  struct Place {
    std::size_t number, first, terms;
  };
  std::vector<Place> places{};
  std::vector<std::uint32_t> terms{};

  std::span<const std::uint32_t> at(const Place& place) const {
    return std::span(terms).subspan(place.first, place.terms);
  }
};

/// What a box hands down to those it is split into.
struct Sight {
  std::optional<Hit> hit{};  ///< where an obstruction came nearest to being in the way
  /// Of the first `judged` places those from which something can be hit in some part of the box, and what; absent: all of them.
  std::shared_ptr<const PlacesWithTerms> near{};
  std::size_t judged = 0;
  std::size_t layers = 0;  ///< the assignment that both are of
  int rests = 0;  ///< for so many more splits only the hit is looked at, as nothing was nearly hit all over
};

/// What the tests of all groundings and assembly modes share: to divide outlines of many corners into convex parts takes long, and so does
/// to spread places over a region.
struct ObstacleScene {
  std::vector<ObstacleShape> shapes;  ///< in the order of obstructions_of()
  std::vector<Point> places;          ///< of the tracer, looked at in every box
  std::vector<Point> many_places;     ///< looked at for single designs
  PlaceGroups groups;                 ///< of the many places
};
/// Of a spec; once stopped, with what there is so far.
std::shared_ptr<const ObstacleScene> obstacle_scene(const Spec& spec, const StopFlag& stop = {});

/// The obstacles, bodies and table's edge of a spec, in the order of obstructions_of(). Bodies that turn with a link are left out:
/// without them designs can only be better.
std::vector<Obstruction> obstructions_of(const Spec& spec);

/// They, seen by one grounding and assembly.
class ObstacleTest {
 public:
  /// Assignments are known by their place in `layers`. Once `stop` is set, no more is ruled out and no design is found clear.
  ObstacleTest(const Spec& spec, const ModeFacts& mode, const std::vector<LayerAssignment>& layers,
               const StopFlag& stop = {});
  /// With a scene that is known: the spec's.
  ObstacleTest(const Spec& spec, const ModeFacts& mode, const std::vector<LayerAssignment>& layers,
               std::shared_ptr<const ObstacleScene> scene, StopFlag stop);

  /// The assignments in which a link's end at tracer or pen is surely hit, whatever the lengths are and wherever the spec lets the pole
  /// stand.
  const LayerSet& hit_by_the_copy() const { return hit_by_the_copy_; }

  /// The assignments of `alive` in which nothing is surely hit. `sight`: of the box this one was split from; becomes its
  /// own. With `only_hit` nothing but the hit is looked at.
  LayerSet not_hit(const DesignBox& box, LayerSet alive, Sight& sight, bool only_hit) const;

  /// Where the part of a hit comes nearest to the obstruction in the middle of a box; nothing where the obstruction has no part.
  std::optional<ObstacleTouch> touch_of(const DesignBox& box, const Hit& hit) const;
  /// The assignments that a hit counts in.
  LayerSet layers_of(const Hit& hit) const;

  /// From now on obstructions are kept away by `margin` (mm) more, at these places too.
  void demand_more(double margin, const std::vector<Point>& places);

  /// What not_hit() costs where it looks at all, in tests of a box for reach.
  std::size_t cost(const Sight& sight) const {
    if (sight.rests > 0) return 1;
    const std::size_t near = sight.near ? sight.near->places.size() : 0;
    return 1 + (near + places_.size() - sight.judged) * convex_pairs_ / 300;
  }

  /// True if a design keeps its clearance at very many places. One where it does not is looked at in every box from then on.
  /// `first`: where it may well not be kept. `left`: without the assignments in which the same part is in the way at the same place,
  /// if it is not.
  bool is_clear(double VA, double VB, const Point& pole, std::size_t layers, const std::optional<Hit>& first,
                LayerSet& left);

  /// Looks at the middle of a box at very many places, and at the one where it is hit most deeply in every box from then on, if that is
  /// more than twice as deep as at the places looked at so far. `alive`: of the box.
  void look_further(const DesignBox& box, const LayerSet& alive);

  /// One more place to look at for one assignment alone.
  void add_place(const Point& place, std::size_t layers);

 private:
  struct Term {
    ObstacleTerm what;
    LayerSet layers{};            ///< in which it counts
    bool is_of_the_copy = false;  ///< of tracer's and pen's places alone
  };
  struct Place {
    Point at;
    std::optional<std::size_t> layers{};  ///< of which it is; absent: of all
  };
  LogLengths middle_of(const DesignBox& box) const;
  double gap_rounding(const ObstacleTerm& term, const PlacedJoints& joints) const;
  void add_term(Term term);
  void look_at_the_copy(const Spec& spec, const CopyingLinkage& any,
                        const std::vector<Obstruction>& obstructions,
                        const std::vector<LayerAssignment>& layers);
  bool is_hit_by_the_copy(const PoleSpec& pole, const ObstacleTerm& end) const;
  struct Design;
  struct Doubt;
  using TermNumbers = std::vector<std::uint32_t>;
  std::shared_ptr<const TermNumbers> may_be_nearer(const Design& design, const PlaceGroup& group,
                                                   const TermNumbers& terms, double gap) const;
  std::vector<Doubt> where_it_may_be_hit(const Design& design, std::size_t layers) const;
  bool is_hit_all_over(const Term& term, const JointSpreads& spreads, double rounding) const;
  struct Look;
  bool look_all_over(const DesignBox& box, std::size_t one, Sight& sight) const;
  void judge(Look& look, Sight& sight) const;

  ModeFacts mode_;
  JointMoving moving_;
  Complex k_;
  Reach reach_;
  JointRoles roles_;
  double clearance_;
  Range usable_;  ///< |psi| that keep the transmission limit
  std::shared_ptr<const ObstacleScene> scene_;
  std::vector<Place> places_;  ///< looked at in every box
  std::size_t last_hit_ =
      0;  ///< of the places: where a design was not clear, so that the next may well not be
  std::vector<Term> terms_;
  TermNumbers all_terms_;         ///< their numbers
  LayerSet hit_by_the_copy_{};    ///< in which something is hit whatever the lengths are
  std::size_t convex_pairs_ = 0;  ///< what the terms cost: those with a shape of few parts one, others two
  StopFlag stop_;
};

}  // namespace kempe::bounding
