#pragma once
// links.csv: every length between joints of one link, a row each.

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// Columns link, length, mm, layer, shape, rounded_mm: "ACX,CX,43.0116...,2,bent,43.01". `mm` with twelve digits,
/// `rounded_mm` as rounded_lengths() has it; RFC 4180 with LF.
std::string links_csv(const Design& design);

}  // namespace kempe
