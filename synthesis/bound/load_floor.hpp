#pragma once
// The limit on the load error for the proven bound: do all designs of a box give way by more?
//
// At one opening the compliance is a sum of positive semidefinite matrices, each times VA^3, VA, VB^3 or VB (synthesis/loads/load_error.hpp). So
// its larger eigenvalue grows with VA and with VB, and the designs of a box with these t and w give way by no less than one with the least VA and
// the least VB among them. The range of t is taken in pieces, of which each has such a pair of its own.
//
// Designs of a large box need have no opening in common. Then it is a distance of the tracer that they have in common: where they reach it,
// w (H(t) + cos psi) = (c r)^2 (box.hpp), so in each piece of the ranges of t and psi w has a least value that goes with it. Where not even that
// is so, each design still reaches the farthest distance or one beyond.

#include <optional>

#include "specs/spec.hpp"
#include "synthesis/bound/box.hpp"
#include "synthesis/loads/load_error.hpp"

namespace kempe::bounding {

/// The load error of one grounding and assembly mode against its limit.
class LoadFloor {
 public:
  /// Of a spec with load, material and a limit on the load error.
  LoadFloor(const Spec& spec, const ModeFacts& mode);

  /// True if every design of the box that covers the distances with a transmission angle of at least `transmission` (rad) gives way by more than
  /// the limit at one of its openings. Said with directed rounding; doubles choose where to look.
  bool exceeded_by_all(const PoleDistances& distances, double transmission, const LengthBox& lengths) const;

  /// No design of the box gives way by less at `psi` (|psi|), mm.
  double at_least(double psi, const LengthBox& lengths) const;

  /// What is known of a distance of the tracer from the pole: each design reaches just that one, or one that is no shorter.
  enum class Reaching { exactly, at_least };
  /// No design of the box gives way by less where it reaches the distance (mm) with a transmission angle of at least `transmission` (rad), mm;
  /// infinity if none does. A result that is not above the limit may be looser than necessary.
  double at_least_reaching(double distance, Reaching reaching, double transmission,
                           const LengthBox& lengths) const;

  /// Whether a design keeps the limit over these openings, as far as doubles tell; and whether it does at both ends, which is told sooner.
  bool keeps(const BarLengths& lengths, const OpeningInterval& openings) const;
  bool keeps_at_ends(const BarLengths& lengths, const OpeningInterval& openings) const;

 private:
  class Compliance;
  double about(double psi, double t, double w) const;
  bool is_exceeded_at_a_common_opening(const PoleDistances& distances, const LengthBox& lengths) const;
  /// Whether at_least_reaching may be above the limit, as far as some designs in doubles tell.
  bool may_exceed_reaching(double distance, const Range& usable, const LengthBox& lengths) const;

  ModeFacts mode_;
  double limit_;
  double force_, E_, width_, thickness_;
  LoadErrorProfile profile_;
};

}  // namespace kempe::bounding
