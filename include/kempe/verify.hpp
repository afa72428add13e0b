#pragma once
// The independent check of designs.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"
#include "kempe/verification.hpp"

namespace kempe {

/// Builds the linkage from its eight lengths alone and drives the tracer over the region, closing the loops numerically.
/// Takes well under a second.
KEMPE_EXPORT Verification verify(const FinishedDesign& design);

/// What of a design.json does not hold.
struct Audit {
  bool certified = false;           ///< everything that was looked at holds
  std::vector<BrokenLimit> broken;  ///< one a key; empty if certified
};
/// Everything that a design.json states, checked from the file alone, without trust in a word of it. Or why the file cannot be
/// read.
KEMPE_EXPORT std::variant<Audit, InputError> verify(const std::filesystem::path& design_file);

}  // namespace kempe
