#pragma once
// The limit on the load error for the proven bound: do all designs of a box give way by more?
//
// At one opening the compliance is a sum of positive semidefinite matrices, each times VA^3, VA, VB^3 or VB (synthesis/loads/load_error.hpp). So
// its larger eigenvalue grows with VA and with VB, and the designs of a box with these t and w give way by no less than one with the least VA and
// the least VB among them. The range of t is taken in pieces, of which each has such a pair of its own.

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

  /// True if every design of the box gives way by more than the limit at an opening that it passes over the distances. Said with
  /// directed rounding; doubles choose where to look.
  bool exceeded_by_all(const PoleDistances& distances, const LengthBox& lengths) const;

  /// No design of the box gives way by less at `psi` (|psi|), mm.
  double at_least(double psi, const LengthBox& lengths) const;

  /// Whether a design keeps the limit over these openings, as far as doubles tell.
  bool keeps(const BarLengths& lengths, const OpeningInterval& openings) const;

 private:
  double about(double psi, double t, double w) const;

  ModeFacts mode_;
  double limit_;
  double force_, E_, width_, thickness_;
  LoadErrorProfile profile_;
};

}  // namespace kempe::bounding
