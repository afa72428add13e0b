#pragma once
// Every slack and threshold of the path generators, each with its unit and its reason.

namespace kempe::slack {

/// Share of the coupler: a coupler point nearer to a joint of its link lies on it, and a cognate has a link without length.
inline constexpr double on_a_joint = 1e-9;
/// rad: transmission that every answer keeps, away from dead points, and what is kept above a limit inside the solver.
inline constexpr double path_from_dead_points = 0.02, path_inside_transmission = 1e-7;
/// Share of a length or of the path's size: limits are kept inside by so much in the solver, so that rounding does not break them.
inline constexpr double path_inside_limit = 1e-9;
/// rad: the crank turns on at least so far from one point to the next, where the timing is free.
inline constexpr double least_turn = 1e-3;
/// Share of the longest link, and rad: an answer's pivot and angles that the task gives may be off by so much.
inline constexpr double path_given = 1e-9;
/// None (ground links): how far a motion by Grashof's rule is kept from a change point, so that rounding does not make it one.
inline constexpr double path_from_change_point = 1e-6;
/// Share of the path's size: an error below it is rounding, and the point counts as met.
inline constexpr double path_met = 1e-9;
/// None (logarithms of ratios, radians): starts nearer than this are one.
inline constexpr double path_starts_apart = 0.15;
/// None: the same for answers.
inline constexpr double path_answers_apart = 1e-3;
/// Share of the better one's largest error: answers whose coupler curves are nowhere farther apart are one.
inline constexpr double path_one_curve = 0.1;
/// Share of a limit (rad for angles): an answer nearer to it stands at it.
inline constexpr double path_at_limit = 1e-6;
/// None: the ratios of a link to the ground link that the search looks at, and one over it.
inline constexpr double path_largest_ratio = 20;
/// None: the sum of what limits are missed by in the solver, above which it has not kept them.
inline constexpr double path_limit_broken = 1e-8;
/// Share: a root of the resultant with no larger imaginary part is tried as a real one; Newton's method decides.
inline constexpr double nearly_real = 1e-5;
/// Share of the largest singular value: below it the poses' rows depend on one another. Share of the vector: a pair lies at infinity.
inline constexpr double rows_depend = 1e-11, pair_at_infinity = 1e-9;
/// Share of the longest link, and rad: what the general solver may find a pose off by.
inline constexpr double poses_met = 1e-8;
/// None: a ratio nearer to 1 copies the curve onto itself.
inline constexpr double copies_itself = 1e-6;
/// Share of the copy's size: what the general solver may find a copied point off by.
inline constexpr double copied = 1e-9;
/// Shares of the path's size: errors below the first, all squares together, are led to zero by Newton's steps; the local solver counts
/// errors in those of its start, or in the second if they are smaller.
inline constexpr double path_nearly_met = 1e-2, path_least_unit = 1e-12;

/// mm: two points that follow each other count as no nearer where the path's length is divided.
inline constexpr double path_least_step = 1e-9;
/// Share of the path's size: a crank that is no longer is none.
inline constexpr double path_least_crank = 1e-6;
/// Paths' sizes: what counts as error at a point where the loop does not close; far more than any that closes has.
inline constexpr double path_not_closed = 1e3;
/// None: a search whose reach has shrunk to this is over.
inline constexpr double path_least_reach = 1e-3;

}  // namespace kempe::slack
