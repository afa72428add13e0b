#pragma once
// Every slack and threshold of the problem, each with its unit and its reason; those of the search stand in
// synthesis/search/steps/slack.hpp. (How much a linkage's joints and holes may be off is synthesis/tolerance/.)
//
// Rounding: what floating-point evaluation may be off by. Inward: kept inside a limit, so that the finished design, whose
// numbers are rounded and which is checked anew, keeps the limit itself. Floors: keep a divisor or a logarithm's argument
// away from zero. Steps: of differences.
//
// "Unit" is the task's size (DesignLayout::unit, mm): the distance from the pole to the farthest place of the region.

namespace kempe::slack {

// Rounding

/// Share of a limit: a limit missed by no more is met. Some thousand times the rounding of a double.
inline constexpr double limit_rounding = 1e-12;
/// Share of the design's size: the pole of a finished design beside its area. It comes from coordinates, whose rounding is
/// that of the largest of them.
inline constexpr double pole_rounding = 1e-11;
/// Unit: a reach against the distance that it must cover. Fine, as both come from the same few operations.
inline constexpr double reach_rounding = 1e-13;
/// Unit: two places nearer than this are one corner or one edge of the pole's area.
inline constexpr double same_place = 1e-9;
/// Share of the figure: distances that decide whether an obstacle is out of reach. Many times what they can be off, as the
/// answer must be certain.
inline constexpr double reach_box_slack = 1e-9;
/// Share of the reach: its slope by the opening, below which it is taken as zero (a serial dead point).
inline constexpr double zero_slope = 1e-9;
/// q^2 - 1, q the ratio of the region's two distances: a region seen as one point, whose bound of lambda is infinite.
inline constexpr double point_like = 1e-20;
/// mm^2, or none: put in place of zero under a square root or a logarithm. Far below every length.
inline constexpr double above_zero = 1e-300;

/// Share of the coordinates: a gap of tracer or pen to an obstacle that is too small by more than this is taken to be so; thousands of
/// times what its few operations can be off by.
inline constexpr double copied_gap_rounding = 1e-9;

/// Share of its chord: a part of a round outline that is no higher is taken as flat.
inline constexpr double flat_arc = 1e-12;

// Inward

/// rad: openings inside the transmission limit, or inside the openings that keep the copy error.
inline constexpr double inward_opening = 1e-9;
/// Of log VA and log VB, so a share of the length: inside the limits of lengths.
inline constexpr double inward_log_length = 1e-11;
/// Unit: inside a limit that is a distance in the plane (the gap between original and copy, the edges of the pole's area).
inline constexpr double inward_distance = 4e-11;
/// Unit: inside the clearance of two links. Certified openings end 1e-9 rad before a contact, and an angle counts by its lever
/// arm.
inline constexpr double inward_gap = 4e-8;
/// Unit: inside the clearance to obstacles, which are looked at in single places of the tracer; between two of them the gap
/// may be a trifle smaller.
inline constexpr double inward_obstacle = 2e-5;
/// rad, or a share of the unit: added to a limit that is demanded more strictly, so that it moves even for a shortfall of 0.
inline constexpr double least_tightening = 1e-12;
/// None: a limit is demanded more strictly by the shortfall times this. Above 1, or the same shortfall would come again.
inline constexpr double tightening_factor = 1.5;

/// Share of the limit: inside the limit on the load error, whose rows look at single openings.
inline constexpr double inward_load_error = 1e-8;
/// Share of the limit: inside the limit on the sag, whose rows look at single openings.
inline constexpr double inward_sag = 1e-8;
/// Share of the limit: the limit on load error or sag when it is demanded more strictly.
inline constexpr double give_tightening = 1e-7;

// Floors

/// Share of longest_mm: the least length looked for where the spec sets no other; its logarithm bounds u and v.
inline constexpr double least_length_share = 1e-9;
/// Share of the farthest distance: the nearest distance of a region that touches or holds the pole.
inline constexpr double least_distance_share = 1e-6;
/// mm: what copy errors are divided by where the tolerances add up to less.
inline constexpr double least_error_scale = 1e-9;

// Steps

/// log of a length, or unit: for the second derivatives of gaps to obstacles, differences of exact first ones (error of the
/// order of step^2 + rounding / step).
inline constexpr double obstacle_step = 1e-5;
/// rad: the same for the copy error, whose slope is smoother.
inline constexpr double copy_error_step = 1e-6;
/// log of a length, or rad: for the second derivatives of the sag, differences of first ones.
inline constexpr double sag_step = 1e-4;
/// log of a length, or unit: for the slopes of the footprint, above the grain of its estimate.
inline constexpr double footprint_step = 2e-3;

}  // namespace kempe::slack
