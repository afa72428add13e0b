#pragma once
// The independent check of designs.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/verification.hpp"

namespace kempe {

/// Builds the linkage from its eight lengths alone and drives the tracer over the region, closing the loops numerically
/// (docs/verification.md). Takes well under a second. write() does the same and writes nothing where `holds` is false.
KEMPE_EXPORT Verification verify(const FinishedDesign& design);

/// What of a design.json does not hold.
struct Audit {
  bool holds = false;               ///< everything that was looked at holds
  std::vector<BrokenLimit> broken;  ///< one a key; empty if all holds
};
/// Everything that a design.json states, checked from the file alone, without trust in a word of it. Or why the file cannot be
/// read.
KEMPE_EXPORT std::variant<Audit, InputError> verify(const std::filesystem::path& design_file);

}  // namespace kempe
