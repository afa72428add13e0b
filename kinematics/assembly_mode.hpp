#pragma once
// The assembly modes of a copying linkage: how the same links can be put together so that no motion leads from one way to
// another but through a dead point or the change point.

#include <vector>

#include "geometry/side.hpp"
#include "kempe/mechanism.hpp"

namespace kempe {

/// How the loops of the linkage lie; plates with joints in line lie on no side.
struct LoopSides {
  Side parallelogram = Side::left;  ///< of B, seen from V to A
  Side plate_ACX = Side::on_line;   ///< of X, seen from A to C
  Side plate_BCY = Side::on_line;   ///< of Y, seen from B to C
  bool operator==(const LoopSides&) const = default;
};

/// One usable assembly mode: an open interval of the opening d = arg q - arg p, which the linkage never leaves. At each end it
/// meets its change point (0, pi) or its serial dead point (arg s mod pi).
struct AssemblyMode {
  int number = 0;            ///< from 0, in the order of the openings
  OpeningInterval openings;  ///< rad, within -pi .. pi
  LoopSides sides;           ///< equal for two modes that lie on the same side of the change point
  bool operator==(const AssemblyMode& other) const = default;
};

/// The usable assembly modes of the plates' shape s: between neighbours among {0, pi, arg s mod pi}, from -pi upward. Four of
/// them, or two if the plates are straight.
std::vector<AssemblyMode> assembly_modes(Complex shape);

/// True if the plates have collinear joints (s real): then every plate is a straight bar.
bool is_straight(Complex shape);

}  // namespace kempe
