#pragma once
// Every slack and threshold of the linkages in closed form, each with its unit and its reason. They are roundings: none is a property of a
// real instrument.

namespace kempe::slack {

/// rad: plates whose angle differs from a straight line by less are straight bars; sin(pi) in doubles is 1e-16.
inline constexpr double straight_plates = 1e-12;
/// None: rounding may leave a cosine just outside [-1, 1] at a dead point.
inline constexpr double cosine_slack = 1e-12;
/// rad: an opening so far outside its interval is on its end: eight roundings of pi.
inline constexpr double opening_rounding = 4e-16 * 8;
/// Sine: directions nearer than this are parallel.
inline constexpr double parallel = 1e-14;
/// Height over base or sides: where a triangle is flatter its slopes mean nothing.
inline constexpr double flattest = 1e-9;
/// None: what rounding may leave past a limit, in the arithmetic of many poses at once.
inline constexpr double batch_slack = 1e-12;
/// mm^2: in place of zero under a root or a division. Far below every length.
inline constexpr double above_zero_square = 1e-300;
/// Share of the longest: bars whose lengths balance to this are at a change point.
inline constexpr double balanced_bars = 1e-12;
/// Share of the largest, squared: a coupler shorter than a billionth is none.
inline constexpr double no_coupler = 1e-18;

}  // namespace kempe::slack
