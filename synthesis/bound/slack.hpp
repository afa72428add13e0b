#pragma once
// Every slack of the bound, each with its unit and its reason: what is computed in doubles is moved by it, away from what would
// let the bound leave out a design. (Intervals with directed rounding need none.) How this fits into the proof:
// docs/proven-bound.md.

#include <limits>

#include "geometry/slack.hpp"

namespace kempe::slack {

/// Share of a length: limits and locks of lengths are this much wider, as finished lengths are rounded.
inline constexpr double locked_length = 1e-9;
/// rad: an end of an opening in |psi| is a sum of at most six doubles below 7, each off by two units in its last place, and the
/// argument of s by as much again: 7e-15 rad is more than all of these.
inline constexpr double end_of_opening = 32 * std::numeric_limits<double>::epsilon();
/// Share of the largest coordinate: a gap to an obstacle is a difference of coordinates. Some 450 units in the last place, for
/// a formula of a few dozen operations.
inline constexpr double obstacle_gap_rounding = 1e-13;
/// Share of the limit on the load error, which designs are held against as doubles tell: so much beyond it none is left out.
inline constexpr double load_limit = 1e-9;
/// Factors: what must surely be no larger, or no smaller, than its value in doubles.
inline constexpr double surely_less = 1 - rounding, surely_more = 1 + rounding;
/// A cosine of psi: nearer to 1 or -1 doubles do not tell the angle well enough to say how far a single design's joints move.
inline constexpr double surely_within = 1 - 1e-6;
/// Share of the size: designs whose lengths and poles are apart by no more are one.
inline constexpr double same_design = 1e-9;
/// rad: a design of the relaxation misses the transmission limit by no more.
inline constexpr double relaxed_transmission = 1e-9;
/// rad: how far above its guess an upper bound of the transmission angle is tried first; ten times farther each time.
inline constexpr double first_above_guess = 1e-14;

}  // namespace kempe::slack
