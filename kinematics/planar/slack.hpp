#pragma once
// Every slack and threshold of the planar solver, each with its unit and its reason. Lengths count in sizes of the linkage.

#include <array>

namespace kempe::slack {

// Closing

/// Share of size and coordinates: largest closure error that counts as closed; some hundred roundings.
inline constexpr double closed = 1e-13;
/// Sizes: Newton's own region, where its steps take over from the damped ones.
inline constexpr double newtons_region = 1e-7;
/// None: damping at first, and the least; a gain of less than this share with damping below this is none.
inline constexpr double damping_at_first = 1e-3, least_damping = 1e-14, no_gain = 1e-9, stuck_damping = 1e-9;
/// None: damping beyond which steps are too short to be worth a try.
inline constexpr double most_damping = 1e9;
/// Shares of the largest pivot below which a pivot counts as none, tried in this order: full rank first, then ever nearer to a
/// singular position.
inline constexpr std::array<double, 4> left_out{1e-11, 1e-8, 1e-5, 1e-3};
/// Cosine: a residual square on to all that the unknowns can do about it; near a dead point it is about 1e-3 where Newton takes
/// over.
inline constexpr double square_on = 1e-7;
/// None: weights of the worst equation while the nearest position that does not close is looked for, ever smaller.
inline constexpr std::array<double, 4> weights_of_worst{1e-1, 1e-2, 1e-3, 1e-4};
/// None: a direction whose length differs from 1 by no more is a unit vector.
inline constexpr double unit_length = 1e-12;
/// Sizes, and rad: positions that differ by no more are the same assembly mode.
inline constexpr double same_position = 1e-6;

// Paths

/// Drivers' part of the left null vector where assembly modes cross.
inline constexpr double crossing_share = 1e-5;
/// rad, that rounding may add to a step; no other position is near. A certified step this short means a singular position.
inline constexpr double rounding_turn = 1e-8, singular_turn = 1e-8;
/// Share of the largest pivot: below it a row depends on the others.
inline constexpr double dependent_row = 1e-9;
/// The same on the way, where other rows are looked for: those in use are then dependent to about 1e-8.
inline constexpr double nearly_dependent_row = 1e-6;
/// Sizes: over a shorter way the path's bend is lost in rounding.
inline constexpr double least_way = 1e-5;
/// Share of size and coordinates: what constraints that are not solved for may be open by.
inline constexpr double closed_by_others = 1e-12;
/// None: how far ahead the singular position is looked at that ended a path, a share of the path.
inline constexpr double look_ahead = 1e-3;
/// None: a step shortened to less than this share of what was certified has met a singular position.
inline constexpr double least_trust = 1e-3;

// Centres, singular positions, mobility

/// Sine of the angle below which two points or lines count as one; and the least at which a crossing is worth having.
inline constexpr double distinct = 1e-9, worthwhile_crossing = 1e-7;
/// Share of the fastest motion below which a pair counts as at rest.
inline constexpr double standing = 1e-12;
/// Share of a centre's coordinates: with less weight it lies at infinity.
inline constexpr double at_infinity = 1e-9;
/// None: motion of a body, or turn of a joint, in a free motion of length 1, below which it does not take part.
inline constexpr double takes_part = 1e-4;
/// Sizes: points that are nearer make no direction.
inline constexpr double same_point = 1e-9;
/// Of the largest singular value: below it a freedom.
inline constexpr double rank_threshold = 1e-6;
/// Sizes: motions away from singular positions, and around the general position.
inline constexpr double first_motion = 2e-2, second_motion = 1e-4;
/// Share of the second motion that counts as finite.
inline constexpr double followed = 3e-2;
/// None: weight of a constraint in a dependence below which it has no part in it.
inline constexpr double part_of_dependence = 1e-5;

}  // namespace kempe::slack
