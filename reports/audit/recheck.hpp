#pragma once
// What was written, read again and compared with the design: the last look before a sheet is cut.

#include <filesystem>
#include <string>
#include <vector>

#include "reports/data/atomic_file.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// Reads the files of a design's folder back, each by a reader independent of its writer (no function in common), and says
/// what is wrong, a sentence each; empty if all is well.
///  - design.json: its lengths are the design's and close;
///  - drawing.dxf, nested.dxf and parts/*.dxf: each link one closed outline of its area (to 1e-9 of it),
///    holes of their diameter, as far apart as the lengths say (to 1e-9 mm), nothing else on the link's layer;
///  - parts/*.svg: outline and holes of their areas, as far as flattened arcs tell;
///  - parts/*.stl: closed, of the finished part's volume.
/// Files that are not there are passed over.
std::vector<std::string> recheck(const std::filesystem::path& folder, const Design& design,
                                 const CuttingSpec& cutting);
/// The same before the files are put in place.
std::vector<std::string> recheck(const FolderDraft& draft, const Design& design, const CuttingSpec& cutting);
/// The same of files that are nowhere but here.
std::vector<std::string> recheck(const std::vector<OutputFile>& files, const Design& design,
                                 const CuttingSpec& cutting);

}  // namespace kempe
