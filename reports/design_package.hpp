#pragma once
// Everything a person takes away from a design, as files by name. To add an output: its function, and its line here.

#include <string>
#include <vector>

#include "reports/atomic_file.hpp"
#include "reports/html_report.hpp"
#include "synthesis/design.hpp"

namespace kempe {

/// The files of a design's folder: design.json first, map, drawings and report, then those of the parts
/// (part_files.hpp). Depends on its arguments alone.
std::vector<OutputFile> design_package(const Design& design, const CuttingSpec& cutting,
                                       const ReportExtras& extras);

}  // namespace kempe
