#pragma once
// How far the joints of a box of designs may stand from given places, with the tracer at one place.
//
// With p along the x axis and rho = t e^{i psi} every joint is p (P + Q rho) for fixed complex P, Q (MaterialPoint), so in the
// table's frame it stands at Z = O + (T - O) M(rho), O the pole, T the tracer's place, with the Moebius map
//     M = ((P - P_pole) + (Q - Q_pole) rho) / D,   D = (P_tracer - P_pole) + (Q_tracer - Q_pole) rho.
// At one place T a box of designs knows |T - O| and so psi, by cos psi = (c |T - O|)^2 / w - H(t). For rho within delta of
// rho_0 and O within R of O_0
//     |M - M_0| <= |det M| delta / (|D_0| (|D_0| - |Q_tracer - Q_pole| delta)),
//     |Z - Z_0| <= R |1 - M| + |T - O_0| |M - M_0|.
// Seen from a joint that carries a body it stands at (T - O) M with the difference M of the two joints' maps, so that R |M| takes the
// place of R |1 - M|. All of it in intervals.
//
// Of one design with the tracer within R of T_0 the joints, seen from each other, stand at (T - O) M, so
//     |Z - Z_0| <= R |M_0| + (|T_0 - O| + R) |M - M_0|,   delta = t |psi - psi_0|,
// psi known from |T_0 - O| give or take R. There are doubles enough: no bound rests on it.

#include <array>
#include <memory>
#include <optional>

#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

/// A box of designs with the pole within `radius` (mm) of `pole`, and no farther from it along x and y than `half`.
struct DesignBox {
  LengthBox lengths;
  Point pole = Point::Zero();
  double radius = 0;
  Point half = Point::Constant(infinity);

  /// The middle of the lengths.
  double t() const;
  double w() const;
};

/// In the order of Joint, mm.
using JointMoves = std::array<double, 6>;

/// No joint of any design of the box that has its tracer at `place` is farther than its figure from its place in `joints`;
/// nothing if the middle design does not reach the place, or the box is too large for a statement. `joints`: about where
/// the middle design's are, in the order of Joint, table's frame, mm; an error there only makes the figure larger. With
/// `seen_from` places are differences from that joint's.
std::optional<JointMoves> joints_move_at_most(const ModeFacts& mode, const DesignBox& box, const Point& place,
                                              const std::array<Complex, 6>& joints,
                                              std::optional<Joint> seen_from = std::nullopt);

/// Where a joint stands in the designs of a box, mm: at `middle` + sum of x_i `by[i]` with |x_i| <= 1, the same x for all joints, give or
/// take `rest`.
struct JointSpread {
  Complex middle;
  std::array<Complex, 4> by;
  double rest = 0;
};
/// In the order of Joint.
using JointSpreads = std::array<JointSpread, 6>;

/// The same for many boxes and places: what depends on grounding and assembly mode alone is kept.
class JointMoving {
 public:
  explicit JointMoving(const ModeFacts& mode);
  std::optional<JointMoves> at_most(const DesignBox& box, const Point& place,
                                    const std::array<Complex, 6>& joints,
                                    std::optional<Joint> seen_from = std::nullopt) const;

  /// Of one design with this VA (mm), while its tracer goes no farther than `radius` (mm) from its place in `joints`: for each joint the
  /// largest move, mm, as seen from the joint `seen_from`, or an upper bound of it; infinite near a dead point and where the design does
  /// not reach its place. In doubles.
  JointMoves beside(double VA, const std::array<Complex, 6>& joints, double radius, Joint seen_from) const;

  /// Where they stand to first order, of those designs that reach the place within `usable` (|psi|). Nothing if the box is too large for
  /// a statement, or has no such design.
  std::optional<JointSpreads> spread(const DesignBox& box, const Point& place, const Range& usable,
                                     std::optional<Joint> seen_from = std::nullopt) const;

 private:
  struct Known;
  ModeFacts mode_;
  std::shared_ptr<const Known> known_;
};

/// The same for the tracer and the pen alone, in the order of Joint, infinite for the others. The copy fixes these two whatever the
/// lengths are, so it is said of places, too, that the middle design does not reach.
JointMoves copying_joints_move_at_most(const ModeFacts& mode, Complex k, const DesignBox& box,
                                       const Point& place, const std::array<Complex, 6>& joints,
                                       std::optional<Joint> seen_from = std::nullopt);

}  // namespace kempe::bounding
