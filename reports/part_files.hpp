#pragma once
// The files of the parts: each link alone, all of them nested on a sheet, the bill of materials.

#include <optional>
#include <string>
#include <vector>

#include "reports/atomic_file.hpp"
#include "synthesis/design.hpp"

namespace kempe {

/// Why a link cannot be cut: which two of its holes run into each other, their distance and diameter, and what would do.
/// Nothing if all is well.
std::optional<std::string> holes_fault(const Design& design, const CuttingSpec& cutting);

/// parts/VA.dxf, parts/VA.svg, parts/VA.stl and so on for each link, parts/assembly.step if this build can
/// write it (step_assembly.hpp), bom.csv, and nested.dxf if the cutting has a sheet that takes the parts. Asks for
/// parts without a holes_fault().
std::vector<OutputFile> part_files(const Design& design, const CuttingSpec& cutting);

/// Why there is no nested.dxf although a sheet is given: which part does not fit. Nothing if all is well.
std::optional<std::string> nesting_fault(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
