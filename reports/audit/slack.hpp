#pragma once
// Every slack and threshold of the audit of stored designs and written files, each with its unit and its reason. All of them are far
// above what rounding does to a file that is right, and far below what a workshop could make. What the map takes as kept or is certain to
// stands in workspace/slack.hpp.

namespace kempe::audit_slack {

// Figures computed anew

/// Share of a figure in closed form.
inline constexpr double share_of_rounding = 1e-9;
/// Share of a copy error: its maxima are found to this.
inline constexpr double share_of_copy_error = 1e-6;
/// Share of what the worst instrument found does: the search may end at another of nearly the same error.
inline constexpr double share_of_corner = 1e-3;
/// Share of a load error or force, or of a rise under the load: the openings looked at lie beside the worst one, and frames lose digits where
/// two joints of a link are near each other (4e-5 at a thousandth of the linkage's size).
inline constexpr double share_of_load = 1e-4;
/// Share of a figure counted on a grid: last digits move whole cells.
inline constexpr double share_of_grid = 1e-3;
/// Share of a sheet that fits: a search finds sheets, and no more is asked than that it finds them again.
inline constexpr double share_of_sheet = 1e-2;
/// Degrees: near a dead point an angle keeps half of its digits.
inline constexpr double degrees_of_rounding = 1e-5;
/// Of k, mm at the pen per mm at the tracer.
inline constexpr double ratio_rounding = 1e-8;

// Limits

/// rad.
inline constexpr double angle_slack = 1e-7;
/// Share of the coordinates' size beside that of the linkage: what rounding moves places by, far from the origin.
inline constexpr double share_of_coordinates = 1e-14;
/// Share of a length: two that are one; and the same for a length that two locks give.
inline constexpr double same_length = 1e-9, locked_length = 1e-8;

// The mechanism and the written files

/// Share of the size, and rad: statements of one mechanism that agree.
inline constexpr double agreeing = 1e-9;
/// mm: a length or a hole read back from a file is the one that was written.
inline constexpr double same_mm = 1e-9;
/// Share of a part's area, beside what flattening its arcs may take away.
inline constexpr double share_of_area = 1e-6;

}  // namespace kempe::audit_slack
