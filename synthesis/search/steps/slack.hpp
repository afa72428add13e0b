#pragma once
// Every slack and threshold of the search, each with its unit and its reason; those of the problem stand in
// synthesis/problem/slack.hpp.
//
// None of them decides whether a design is right: that is `limit_rounding` of the problem alone. These decide when two
// figures are one, and which gain is worth more work.

#include "synthesis/problem/slack.hpp"

namespace kempe::slack {

// When two figures are one

/// Share of |k|: a design farther off has another ratio than the spec's (stock lengths), and the bound does not hold for it.
inline constexpr double same_ratio = 1e-12;
/// Share of the larger: two stock lengths are one. Grid times a count is rounded, and lengths in mm have no more
/// than seven digits.
inline constexpr double same_length = 1e-9;
/// Share of a figure: two points of a front are equal in it. What no user pays for with the other figure.
inline constexpr double same_value = 1e-7;
/// Share of a limit: one that a design meets with no more to spare holds it back.
inline constexpr double met_exactly = 1e-4;
/// Share of the cost without contact: a size smaller by no more is so by rounding alone.
inline constexpr double bound_rounding = 1e-9;
/// Share of a length: holes that fit but for rounding fit.
inline constexpr double hole_rounding = 1e-9;
/// Share of a distance and of the coordinates that it comes from: two places nearer than they must be, by more than this, are
/// so for certain. Thousands of times what the few operations can be off by.
inline constexpr double place_rounding = 1e-9;
/// Unit (DesignLayout::unit): a row of the exchange method missed by no more is not violated; the local solvers leave so much.
inline constexpr double violated_row = 1e-11;

/// Share of the size: what a robust design keeps more than the clearance, so that it does in another frame and file too.
inline constexpr double robust_rounding = 1e-9;

// Which gain is worth more work

/// Share of the cost: a choice that comes so near to its bound is searched no further.
inline constexpr double at_bound = 1e-7;
/// Share of the cost: the tree is searched until no design can be better by more.
inline constexpr double tree_search = 5e-7;
/// The same under a limit on the load error, where the last digits of the proof would take most of its time.
inline constexpr double tree_under_load = 3e-4;
/// Share of the bound: how near the tree brings it to the best design.
inline constexpr double tree_bound = 1e-4;
/// Share of the gap between a design that keeps a limit on the load error and the best that need not, which is all that a told bound knows: how
/// near the bound is brought to that best.
inline constexpr double gap_of_a_limit = 0.05;
/// Share of the cost: the second solver's result replaces the first's only if it is better by more; rounding must not make
/// one solver's digits look better than the other's.
inline constexpr double solver_gain = 1e-9;
/// Share of the value: a design met by basin hopping is certified only if it is better by more.
inline constexpr double hop_gain = 1e-6;
/// Share of the cost: layers on stock lengths that come so near to the cost without contact end the look at further layers;
/// for a footprint no more is known.
inline constexpr double near_free_cost = 1e-7, near_free_footprint = 1e-3;

// Limits that give way (diagnosis)

/// Share of the value attained, share of the way from what was demanded, and the limit's own unit (mm or degree): a limit
/// gives way by the first, or by the second if that is less, but by the third at least, or one on an error by the first: a value told
/// without any leeway would be kept by a single design.
inline constexpr double give_of_value = 1e-3, give_of_way = 8e-3, least_give = 1e-6;
/// mm or rad: what the share by which a limit gives way is of, where the limit itself is less.
inline constexpr double least_demand = 1e-3;
/// mm: no joints of a link are looked for that are nearer.
inline constexpr double nearest_joints = 1e-3;
/// Share of the hole: a wall thinner than this is none.
inline constexpr double least_wall_share = 1e-3;

// Weights of a first impression

/// None: what is missing from the limits against the goal, both in shares of the task's size; what an infeasible point is
/// worse by at least, so that a feasible one of the same goal comes first.
inline constexpr double missing_weight = 10, infeasible_weight = 1e-3;

}  // namespace kempe::slack
