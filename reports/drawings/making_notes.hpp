#pragma once
// What a maker should know before the parts are cut.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A sentence each, what breaks or hits first: what overload_words(), hardware_faults() and mounting_words() find; holes drawn no wider than their pins; spacers.
std::vector<std::string> making_notes(const Design& design);

}  // namespace kempe
