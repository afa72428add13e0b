#pragma once
// Every slack of the copy error, each with its unit and its reason. (How much a linkage's joints and holes may
// be off is CopyTolerance.)

namespace kempe::slack {

/// None: keeps the change point a huge number instead of a division by zero.
inline constexpr double smallest_sine = 1e-120;
/// Of the region's extent: places so near to the boundary are told apart exactly.
inline constexpr double on_boundary = 1e-9;
/// Factor: the longest deviation is found when no direction can hold one longer by more.
inline constexpr double close_enough = 1 + 1e-9;
/// Factor: errors, slopes and steps are doubles, off by some dozen units in the last place; all of them are taken this much to
/// the safe side.
inline constexpr double surely = 1 - 1e-9;
/// Of the sine: the shortest step along the openings.
inline constexpr double finest = 1e-6;
/// Of the sine: nearer to a change point the error is beyond any limit worth its name, or there is no tolerance. The error is
/// told there from below, with twice this sine.
inline constexpr double at_change_point = 1e-4;

}  // namespace kempe::slack
