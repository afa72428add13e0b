#pragma once
// Slacks of the workspace's map that its checks must know too, each with its unit and its reason.

namespace kempe::slack {

/// To what the smallest gap is certified: mm, and for small linkages a share of the outer reach.
inline constexpr double certain_gap = 1e-2, certain_gap_share = 1e-4;
/// Share of the outer reach: limits missed by less count as kept.
inline constexpr double touching = 1e-8;

}  // namespace kempe::slack
