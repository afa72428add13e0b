#pragma once
// What the tolerances do beyond the first order, in words for summary and report.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A sentence each: by how much the first order understates the copy error, and whether limits.copy_error_mm is broken; plates
/// that may lose their height or have no triangle; that an instrument may not close. Empty where the figures of the copy error may
/// stand alone, and without tolerances.
std::vector<std::string> tolerance_words(const Design& design);

/// Whether the copy error exceeds limits.copy_error_mm: of the worst instrument found where the first order understates it, else to the first
/// order.
bool breaks_copy_error_limit(const Design& design);

}  // namespace kempe
