#pragma once
// Degrees as a person would state them, for files that are read back.

namespace kempe {

/// The number of degrees with the fewest decimals that radians() turns back into exactly this angle, so that
/// what was given as 60 is written as 60; the plain conversion where there is none within a few roundings.
double stated_degrees(double radians);

}  // namespace kempe
