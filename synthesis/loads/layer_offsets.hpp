#pragma once
// What the layers add to the load error: links lie above each other, so a pin's force acts beside the middles of the links that it joins. It
// tilts the pins and bends and twists the links out of their plane; that lets the pen give way further in the plane, and rise or sink.
//
// A pin over a height h between the middles of its links that bears f loads each of them by a couple h f / 2, and its ends move apart by h times the
// mean of the two links' tilts, beside its own h^3 / 12EI + 10 h / 9GA. The links are the grillage of the sag under those couples M; by reciprocity the pen gives
// way by M' R M more, R the grillage's answer to couples. Exact for slender links and pins that turn freely about their axes.
//
// The table pushes a point that rests on it and never pulls: under weights and force together each such point either bears, or is lifted off.
// What the force does is the state under both less that under the weights alone; stress is that of the state under both.
//
// On a tilted table the links' own weight along it (plane_weight.hpp) pulls at the pins too, and so has couples of its own. What it does in
// addition, while any set of points bears, is no more than the most of what it does while each set that may bear does so: all is linear while
// the set stays. Stress is a norm of what a piece bears, so the stresses of two loads add up to no less than that of both.
// Derivation: docs/loads.md.

#include <Eigen/Core>
#include <map>
#include <optional>

#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/load_figures.hpp"
#include "synthesis/loads/plane_weight.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/loads/strength.hpp"

namespace kempe {

/// At one opening, mm, under the force of the profile in its worst direction. NaN where the grillage's equations lose their digits.
struct LayeredErrorAt {
  double in_plane = 0;  ///< how far the pen gives way: links, pins and layers together
  double rise = 0;      ///< how far tracer or pen rises or sinks
};

/// Of all linkages of one ratio and grounding, under one set of conditions.
class LayeredErrorProfile {
 public:
  /// `pen_force`: N.
  LayeredErrorProfile(Complex k, Grounding grounding, const SagConditions& conditions, double pen_force);

  /// At an opening, rad.
  LayeredErrorAt at(const BarLengths& lengths, double opening) const;
  /// The most of each over an interval of openings (top_over.hpp), not empty, each at its own one; nothing where one of those looked at has no figure.
  std::optional<LayeredFigures> over(const BarLengths& lengths, const OpeningInterval& openings) const;
  /// How far the pen gives way at most over such an interval, as over() has it; infinite where there is no figure.
  double give_over(const BarLengths& lengths, const OpeningInterval& openings) const;

  /// The largest stress in each link (strength.hpp), each at its own opening and direction of the force: in the plane by the force, out of
  /// it by its couples and the weights; on a tilted table with the largest by the links' own weight along it, over all turns, added. `hole`: mm, the diameter that every joint takes of its link. Nothing where moments lose their digits.
  std::optional<LinkStresses> stresses_over(const BarLengths& lengths, const OpeningInterval& openings,
                                            double hole) const;
  /// At an opening, rad; NaN where there is nothing to state. Without the links' own weight along the table.
  LinkStresses stresses(const BarLengths& lengths, double opening, double hole) const;

  /// How far the pen gives way in the plane there under this force, N, all in, mm; x axis along bar VA. NaN as above.
  Point give(const BarLengths& lengths, double opening, const Point& force) const;

  /// What the links' own weight along the table does in addition, the most over all turns of the linkage; nothing on a level table, infinite
  /// where there is nothing to state.
  LayeredErrorAt by_weight(const BarLengths& lengths, double opening) const;
  /// The most of each over an interval of openings, each at its own one.
  LayeredErrorAt by_weight_over(const BarLengths& lengths, const OpeningInterval& openings) const;
  /// MPa in each link by that weight alone, the most over all turns; 0 on a level table, infinite where there is nothing to state.
  /// `hole` as above.
  LinkStresses stresses_by_weight(const BarLengths& lengths, double opening, double hole) const;
  /// mm: how far the pen gives way in the plane by that weight where gravity pulls in this direction, of size 1, in the frame of give(),
  /// on the points that the weights press down; 0 on a level table, NaN as above.
  Point give_by_weight(const BarLengths& lengths, double opening, const Point& direction) const;

 private:
  struct Bent;
  struct Moments;
  struct OwnWeight;
  class Contacts;
  LayeredErrorAt at(const BarLengths& lengths, double opening, const SupportedStretch& under_weights) const;
  double most_of(const BarLengths& lengths, const OpeningInterval& part, const SupportedStretch& stretch,
                 double LayeredErrorAt::*figure, std::map<double, LayeredErrorAt>& seen) const;
  Eigen::Matrix2d upright(const BarLengths& lengths, double opening) const;
  double most_stress(Contacts& contacts, Link link, double hole) const;
  template <class Look>
  void for_each_part(const BarLengths& lengths, const OpeningInterval& openings, const Look& look) const;

  Complex shape_, factor_;
  JointRoles roles_;
  SagConditions conditions_;
  SagProfile sag_;
  LoadErrorProfile upright_;  ///< links, and pins whose ends do not tilt
  PlaneWeight weight_;        ///< the same under their own weight along the table
  double force_;
};

/// mm, the most that the pen gives way in the plane over these openings, not empty: links, pins, layers and the links' own weight along a tilted
/// table. Infinite where it cannot be stated. Of a spec with load and material.
double give_in_all(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                   const OpeningInterval& openings);

}  // namespace kempe
