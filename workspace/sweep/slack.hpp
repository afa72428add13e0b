#pragma once
// The slack of the sweep, each with its reason.

namespace kempe::sweep {

/// Share of circle and piece: a crossing so far beyond the end of an edge or an arc still counts as on it. One that counts
/// twice does no harm, one that is lost would lose an angle; thousands of times the rounding of a place.
inline constexpr double end_slack = 1e-9;
/// Share of the distance: boxes of edges farther out are passed over. Some thousand times the rounding of a distance.
inline constexpr double box_rounding = 1e-12;

}  // namespace kempe::sweep
