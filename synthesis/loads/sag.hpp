#pragma once
// Sag: how far tracer and pen sink below the plane in which they should move, by the weight of the links and of what they carry, and
// by the play of the pins.
//
// The links' arms are a grillage (grillage.hpp) that stands on the pole's post, clamped in the table, and on the points that the table
// carries. A pin is a round steel bar that bends between the middles of its two links. With the pole at V one post carries both bars: it stands
// in the table under the lower one and goes on from there to the upper one. Play lets every link tilt on its pin by play / grip. Like
// the load error the figures depend on lengths and opening alone. Model and limits: docs/loads-out-of-plane.md.

#include <array>
#include <vector>

#include "kinematics/copying_linkage.hpp"
#include "synthesis/loads/grillage.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// J of a rectangle, mm^4, whatever the order of its sides: W. C. Young, R. G. Budynas, Roark's Formulas for Stress and Strain, 7th
/// edition, table 10.1; to 0.5 % of the exact series.
double torsion_constant(double width, double thickness);

/// Stiffness and weight of a flat bar out of the plane.
struct FlatBar {
  double bending = 0;  ///< N mm^2: E w t^3 / 12
  double torsion = 0;  ///< N mm^2: G J
};
/// `E` and `G` in MPa.
FlatBar flat_bar(const LinkStyle& style, double E, double G);

/// What bears a linkage and what it carries, out of the plane.
struct SagConditions {
  LinkStyle style{};
  JointHardware hardware{};  ///< says how thick the pin of each joint is
  LayerAssignment layers{};
  double E = 0;            ///< MPa, of the links
  double G = 0;            ///< MPa, of the links
  double density = 0;      ///< kg/m^3, of the links
  double pen_mass = 0;     ///< kg, carried by the pen
  double tracer_mass = 0;  ///< kg, carried by the tracer
  double tilt = 0;         ///< rad, of the table from level: 0 lies, pi/2 stands
  double play = 0;         ///< mm, of each pin
  double grip = 0;         ///< mm, > 0: the length over which a pin is held in the link that turns on it
  bool tracer_rests = false, pen_rests = false;  ///< the table carries that point
};
/// Of a spec with a material; without [load] nothing rests and nothing is carried, without [tolerance] nothing plays.
SagConditions sag_conditions(const Spec& spec, const LayerAssignment& layers);

/// How far a point sinks, mm.
struct Drop {
  double by_weight = 0;  ///< negative: it rises
  double by_play = 0;    ///< at most, with every link tilted on its pin the worst way
  double total() const { return by_weight + by_play; }
};

/// Sag at one opening.
struct SagAt {
  Drop tracer{}, pen{};
  double tracer_bears = 0, pen_bears = 0;  ///< N, what the table carries there; 0 where nothing rests
  /// mm, of tracer and pen the one that sinks more; at least 0; infinite where the equations say nothing (Grillage)
  double most() const;
};

/// A sag, mm, with its derivatives by log VA, log VB and the opening.
struct SagJet {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// Openings over which the same points bear on the table.
struct SupportedStretch {
  OpeningInterval openings;
  bool tracer_bears = false, pen_bears = false;
};

/// The sag of all linkages of one ratio and grounding, under one set of conditions.
class SagProfile {
 public:
  SagProfile(Complex k, Grounding grounding, const SagConditions& conditions);

  /// With bars VA and VB so long (mm), at an opening, rad.
  SagAt at(double VA, double VB, double opening) const;
  /// The same of one of the two points, with its slopes by log VA, log VB and the opening; 0 where the table bears it. Where a point is about
  /// to be lifted off the table, the slopes are those of one side.
  SagJet jet(double VA, double VB, double opening, Carrier point) const;
  /// The grillage there: V at 0, bar VA along x; joints in the order of Joint; pins: the post up to its link, with the pole at V to the lower
  /// of VA and VB; at V between VA and VB, with the pole there the post's upper part; A, B, C.
  GrillagePlan plan(double VA, double VB, double opening) const;
  /// Such a grillage on the points that the table carries.
  StandingGrillage stands(const GrillagePlan& plan) const;
  /// Which points bear at an opening, as a stretch of this opening alone.
  SupportedStretch supported_at(double VA, double VB, double opening) const;
  /// An interval of openings, not empty, parted where the weights lift a point off the table or let it down. What happens and is undone within a
  /// 64th of the interval may be missed.
  std::vector<SupportedStretch> stretches(double VA, double VB, const OpeningInterval& openings) const;

 private:
  void add_links(GrillagePlan& plan) const;
  void add_pins(GrillagePlan& plan) const;
  void add_weights(GrillagePlan& plan) const;

  Complex shape_;
  JointRoles roles_;
  SagConditions conditions_;
  FlatBar bar_;
  std::array<double, 6> pins_;  ///< N mm^2: how they resist bending, in the order of Joint
  double down_;                 ///< m/s^2: gravity's part at right angles to the table
};

/// The largest sag over an interval of openings (top_over.hpp), and at which.
struct LargestSag {
  SagAt sag{};
  double opening = 0;  ///< rad
};
LargestSag largest_sag(const CopyingLinkage& linkage, const SagConditions& conditions,
                       const OpeningInterval& openings);

/// The sag where each of the two points sinks most by itself, which may be at two openings.
struct LargestDrops {
  SagAt tracer{}, pen{};
};
LargestDrops largest_drops(const CopyingLinkage& linkage, const SagConditions& conditions,
                           const OpeningInterval& openings);

}  // namespace kempe
