#pragma once
// What a maker should know before the parts are cut.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A sentence each: what the load breaks or bends too far (overload_words.hpp), then part_notes().
std::vector<std::string> making_notes(const Design& design);

/// A sentence each: what hardware_faults() and mounting_words() find; holes drawn no wider than their pins; spacers.
std::vector<std::string> part_notes(const Design& design);

}  // namespace kempe
