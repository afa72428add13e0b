#pragma once
// Every slack and threshold of the calibration, each with its unit and its reason. (Uncertainties are stated or estimated, and no
// slack.)

namespace kempe::slack {

// Least squares

/// Share: what cminpack is asked for, a double's rounding.
inline constexpr double tightest = 2.3e-16;
/// mm: a step this short ends the fit; what is badly determined moves by rounding, at most so much.
inline constexpr double settled = 1e-8;
/// Share of the squares: a step may raise them by no more, which is rounding.
inline constexpr double squares_rounding = 1e-9;
/// Share of the largest singular value: below the first a direction has no weight at all in a covariance; below the second it
/// counts as not determined.
inline constexpr double no_weight = 1e-13, rounding_share = 1e-10;
/// mm: corrections of the scales move no more.
inline constexpr double corrections_at_rest = 1e-12;

// Noise

/// Share: noise that changes by no more from one weighing to the next is settled.
inline constexpr double noise_settled = 1e-3;
/// mm at the farthest place: noise below this is the rounding of coordinates.
inline constexpr double noise_rounding = 1e-15;
/// Share of the squares: what is left for the readings where the known part explains all of them.
inline constexpr double least_unexplained = 1e-4;
/// mm: the least reading noise that a simulated instrument's readings are said to have.
inline constexpr double least_simulated_noise = 1e-6;

// Readings that stand out

/// Chance of naming any reading of a fit whose readings are all good.
inline constexpr double named_by_chance = 1e-3;
/// mm at the farthest place: readings without noise have no outliers that rounding alone makes.
inline constexpr double outlier_rounding = 1e-11;
/// Share of the largest square: a trace of the drawn instrument, where a few readings alone do not determine all.
inline constexpr double trace_of_drawn = 1e-12;
/// None: a reading whose own weight leaves less than this decides a measure alone; nothing can be said of it.
inline constexpr double decides_alone = 1e-6;

// What is told

/// None: a measure whose share in a combination is less is not named in it.
inline constexpr double too_small_to_name = 1e-3;
/// None: a quantity that an undetermined combination moves by less is determined.
inline constexpr double hardly_moves = 2e-3;
/// Share of the distance: readings whose distances from the pole differ by less stand at one opening.
inline constexpr double one_opening = 1e-3;
/// Share of a step: a reading that is off a multiple of the step by less is one; typed decimals are.
inline constexpr double is_multiple = 1e-6;
/// Chance below which a fit is told as "hardly ever".
inline constexpr double rare = 1e-3;

}  // namespace kempe::slack
