#pragma once
// What a maker should know before the parts are cut.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A sentence each: holes drawn no wider than their pins; what hardware_faults() finds.
std::vector<std::string> making_notes(const Design& design);

}  // namespace kempe
