#pragma once
// Every slack and threshold of the function generators and inversors, each with its unit and its reason.

namespace kempe::slack {

// Search

/// None (logarithms of lengths, radians of starts): two designs nearer than this are one, and one of them is searched from.
inline constexpr double designs_apart = 1e-2;
/// Share of the wanted places: a place is due when the way covers it but for rounding of the sums.
inline constexpr double place_due = 1e-9;
/// Of the output's range: what the function may stand off the straight line in the middle of a cell, so that sums over cells
/// are those of the function to some thousandths of any error worth having.
inline constexpr double nearly_straight = 2e-4;
/// Of the output's range: where the places run out the function may stand off so far and is followed with a reservation; and so far
/// from the dial's ends the places may stay.
inline constexpr double strays_too_far = 0.02;
/// Of the largest value; of y: functions that differ by less are constant but for rounding. Of y: the most a difference may be
/// before products of it overflow.
inline constexpr double constant = 1e-12, least_range = 1e-300, most_range = 1e300;
/// Of what three halvings gain on a peak, and of how far the function falls beside it: three more leave less of a smooth one (1/64)
/// and all of a pole. A pole still gains so much
/// in the last third of the halvings of what it gained in the first; a root's cusp does not.
inline constexpr double peak_settles = 0.2, pole_goes_on = 0.75;
/// Of y's range: a pole that gains less in the last third of the halvings shows nowhere. A peak between samples that stands out
/// by no more leaves the dial's ends where the samples have them.
inline constexpr double pole_counts = 1e-3, peak_stands_out = 1e-4;
/// Share of the mean square error: the integral's own error, with what rounding of the error and of its square leaves.
inline constexpr double integral_share = 1e-10, integral_rounding = 1e-15, integral_floor = 1e-28;

// Precision points

/// Reciprocal condition of Freudenstein's equations: below it the points do not determine a linkage.
inline constexpr double least_condition = 1e-12;
/// rad: step of central differences; the cube root of a double's rounding, within a few times.
inline constexpr double difference_step = 1e-7;
/// rad: a Newton step this short is rounding.
inline constexpr double newton_at_rest = 1e-13;
/// rad: a start that lies so far from the one given has moved.
inline constexpr double start_moved = 1e-9;
/// rad: two starts that are nearer are one solution, met twice.
inline constexpr double same_start = 1e-7;

// Least squares and minimax on the four-bar

/// None: what a limit may be missed by inside the solver; designs are kept inside it by more.
inline constexpr double solver_slack = 1e-12;
/// Share of the variables: changes at which the local solvers end, that with slopes and that without, a start for the other.
inline constexpr double variables_at_rest = 1e-12, starts_at_rest = 1e-9;
/// rad: transmission that every design keeps, and what it keeps above its limit so that the finished one keeps the limit.
inline constexpr double away_from_dead_points = 1e-3, above_rounding = 1e-10;
/// Of the logarithm of the longest ratio: designs stay inside it by so much.
inline constexpr double inside_ratio = 1e-12;
/// rad: what errors are divided by where they are less.
inline constexpr double least_unit = 1e-12;
/// Share of the range of x: two watched places nearer than this are one.
inline constexpr double same_place_of_x = 1e-9;
/// None: a trust region smaller than this ends the minimax, and so does a gain of less than this share of the error.
inline constexpr double least_box = 1e-9, least_gain = 1e-11;

// Conditions of an optimum

/// Shares of the largest ripple: ripples that hold the optimum; tried in this order, as ripples are nearly level at first.
inline constexpr double holding_ripples[] = {1e-4, 1e-3, 1e-2, 0.05, 1e-6};
/// The same for what is told of a design that is no proven optimum, and for the count of equal ripples.
inline constexpr double told_ripples = 1e-6;
/// None: a limit missed by no more holds the optimum too.
inline constexpr double holding_limit = 1e-5;
/// None: step of central differences of exact slopes.
inline constexpr double curvature_step = 1e-5;
/// Share of the error: ripples are level. None: the pull on every unknown and the last step are zero; squares of the latter lie
/// at rounding.
inline constexpr double level = 1e-9, no_pull = 1e-7;
/// Share of the largest singular value: those below are rounding.
inline constexpr double rank_of_conditions = 1e-9;
/// Share of the error: a design found level replaces the other if it is no worse by more.
inline constexpr double no_worse = 1e-8;

// Inversors

/// Shares of the focal length: the shortest side of Peaucellier's rhombus and the shortest bar of Hart's that are looked at.
inline constexpr double shortest_side = 1e-3, shortest_bar = 1e-2;
/// None: the share at which Hart's bar is divided is found to this.
inline constexpr double share_precision = 1e-6;

}  // namespace kempe::slack
