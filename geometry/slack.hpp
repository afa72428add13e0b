#pragma once
// The slack of doubles that all rooms share.

namespace kempe::slack {

/// Share of a figure, or of the largest of the figures that it comes from: what formulas of a few dozen operations may be off
/// by. Some 4500 units in the last place, many times what they are.
inline constexpr double rounding = 1e-12;

}  // namespace kempe::slack
