#pragma once
// Every slack of the copy error, each with its unit and its reason. (How much a linkage's joints and holes may
// be off is CopyTolerance.)

namespace kempe::slack {

/// None: keeps the change point a huge number instead of a division by zero.
inline constexpr double smallest_sine = 1e-120;
/// Of the region's extent: places so near to the boundary are on it.
inline constexpr double on_boundary = 1e-9;
/// Share of a length: edges that differ by less are of one length, and a count of steps that is whole but for as much is whole.
inline constexpr double same_size = 1e-9;
/// Factor: the longest deviation is found when no direction can hold one longer by more.
inline constexpr double close_enough = 1 + 1e-9;
/// Of the sine: the shortest step along the openings.
inline constexpr double finest = 1e-6;
/// Sine: nearer to a change point steps are as long as here.
inline constexpr double at_change_point = 1e-4;
/// rad: what is ruled out is ruled out so far beyond both of its ends. An end of a mode is a double, off by less.
inline constexpr double beyond_end = 1e-13;
/// Of the worst case: an instrument that does worse by more is stated beside it. A second order of less is far below how well tolerances are
/// known.
inline constexpr double second_order = 0.02;
/// Of its height: a plate that may lose as much or more is named. Its lengths are then off by a fifth of what may leave no triangle.
inline constexpr double height_at_risk = 0.1;
/// Of the play's radius: the step by which the slope of a deviation is taken. Its third order is then a millionth, and rounding less.
inline constexpr double pin_step = 1e-3;

}  // namespace kempe::slack
