#pragma once
// The links' own weight along a tilted table: how far it moves the pen in the plane while pole and tracer are held, and what pins and links
// bear of it.
//
// Each arm's weight is spread evenly. Half of it at either end loads the joints as the arm does, so the forces follow from the balance of a
// linkage that is loaded at its joints. With V at 0, F_j all that acts on joint j from outside and G = F_X + conj(s) F_Y, a small turn of p
// and one of q do no work:
//   dot(i p, G + F_A + F_C) = 0        dot(i q / s, G) + dot(i q, F_B + F_C) = 0
// Between its ends an arm of length L that bears q per length bends by q_across L^2 x (1 - x) / 2 less at x of L. By the unit-load theorem
// the pen moves along a force of one newton on it by
//   the sum over the arms of across (across_w L^3 / 3 - q_across L^4 / 24) / EI + along along_w L / EA  and over the pins of c dot(f, f_w)
// with the forces of that newton and, by index w, of the weight. A bar's own bending moves no joint.
//
// Weights: each link's along its arms, with half a disc at each end; a triangle's at its corners. Holes are not taken off.
// All is linear in the direction in which gravity pulls. So the most over all turns of the linkage on the table is the larger singular value
// of a matrix of two rows. Derivation, limits of the model: docs/loads.md.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/strength.hpp"

namespace kempe {

/// N, on every link at each of its joints: [link][joint].
using ForcesOnLinks = std::array<std::array<Complex, 6>, 4>;

/// What the weight does where gravity pulls in one direction; x axis along bar VA.
struct UnderWeight {
  /// With half of each arm's weight at its ends, and what its ends weigh.
  ForcesOnLinks with_halves{};
  ForcesOnLinks by_pins{};  ///< by pins, the post and the hand alone
  Complex post = 0;         ///< N, of the post on what it bears
  Complex hand = 0;         ///< N, of the hand on the tracer
};

/// What pins and the post put on the links, N.
struct PinPulls {
  Complex A = 0;        ///< on link VA
  Complex B = 0;        ///< on link VB
  Complex C = 0;        ///< on plate ACX
  Complex V = 0;        ///< on link VB, of what it turns on there
  Complex VA_at_V = 0;  ///< on link VA there
  Complex post = 0;     ///< on all that stands on it
};

/// Of all linkages of one ratio and grounding, of links of one section and material on a table of one tilt.
class PlaneWeight {
 public:
  /// `tilt`: rad. `pins`: what they give; that at V, and on a post at V, is pulled by what it puts on the end of `upper_at_V`, VA or VB.
  PlaneWeight(Complex k, Grounding grounding, const LinkStyle& style, const Material& material, double tilt,
              const PinCompliance& pins = {}, Link upper_at_V = Link::VB);

  /// True where links pull along the table at all.
  bool weighs() const { return per_area_ > 0; }

  /// mm, how far the pen moves at an opening (rad): a column for gravity along x and along y, x along bar VA.
  Eigen::Matrix2d give(const BarLengths& lengths, double opening) const;
  /// mm, the most over all turns of the linkage.
  double most(const BarLengths& lengths, double opening) const;
  /// mm, over an interval of openings (top_over.hpp) too.
  double most_over(const BarLengths& lengths, const OpeningInterval& openings) const;

  /// N, the most over all turns: A at either end of bar VA, B and V at either end of VB, C between the plates, and the post's.
  PinForces pin_forces(const BarLengths& lengths, double opening) const;
  /// MPa, the most over all turns, in the plane alone; infinite where a hole (mm) leaves nothing of a link.
  LinkStresses stresses(const BarLengths& lengths, double opening, double hole) const;

  /// Forces where gravity pulls in this direction, of size 1.
  UnderWeight under(const BarLengths& lengths, double opening, Complex direction) const;
  /// The same of a force on the pen too (N, x axis along bar VA).
  PinPulls pulls(const BarLengths& lengths, double opening, Complex direction, Complex pen_force) const;
  /// What the arms bear under the weight alone, in the order of all_links and arms_of(), each from its LinkArm::from to its LinkArm::to.
  std::vector<PieceForces> pieces(const BarLengths& lengths, double opening, Complex direction) const;

 private:
  struct Weights;
  struct Held;
  Weights weights_of(const BarLengths& lengths, double opening) const;
  Held held_under(const std::array<Complex, 6>& loads, const BarLengths& lengths, double opening) const;
  double work_in_arms(const ForcesOnLinks& by_force, const ForcesOnLinks& by_weight, const Weights& weights,
                      Complex direction) const;
  double work_in_pins(const Held& by_force, const UnderWeight& by_weight) const;

  Complex shape_;
  JointRoles roles_;
  LinkStyle style_;
  double E_, per_area_;  ///< MPa; N along the table for each mm^2 of a link
  PinCompliance pins_;
  Link upper_at_V_;
};

/// The pieces' forces where gravity pulls in that direction (rad), of those along x and along y.
PieceForces turned(const std::array<PieceForces, 2>& by_axis, double direction);

/// The larger singular value.
double larger_singular_value(const Eigen::Matrix2d& matrix);

}  // namespace kempe
