#pragma once
// Every slack and threshold of the verification, each with its unit and its reason: what rounding may do to a design that is right, and
// far less than any workshop could make.

namespace kempe::slack {

// What is compared

/// rad: openings and transmission angles of the solver's positions against those stated; next to a dead point an angle keeps
/// half of a double's digits.
inline constexpr double opening_slack = 1e-7, transmission_slack = 1e-7;
/// Share of the length: lengths of the placed links against those stated.
inline constexpr double length_slack = 1e-9;
/// Share of the mechanism's size: what the loops may be open by.
inline constexpr double loop_residual_share = 1e-12;
/// Share of the mechanism's size: clearances that the map takes as kept.
inline constexpr double clearance_share = 1e-8;
/// Share of 1 + |k|: the ratio of the similarity fitted to all positions.
inline constexpr double ratio_share = 1e-8;

// How the mechanism is drawn and driven

/// Of a side: what rounding of three lengths may leave of the height of a plate whose joints are in line.
inline constexpr double in_line = 1e-9;
/// Heights above this share of a side follow from the three lengths to 1e-10 of it.
inline constexpr double lengths_suffice = 1e-3;
/// Of the reach: how closely arcs of the workspace are followed.
inline constexpr double fine_outline = 1e-4;
/// rad: an opening so far outside the certified ones still counts as in them.
inline constexpr double traced_slack = 1e-9;
/// mm, or for linkages of few millimetres this share of their size: where a line that cannot be followed is cut.
inline constexpr double cut_precision = 1e-9;

}  // namespace kempe::slack
