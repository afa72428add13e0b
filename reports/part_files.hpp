#pragma once
// The files of the parts: each link alone, all of them nested on a sheet, the bill of materials.

#include <string>
#include <vector>

#include "reports/atomic_file.hpp"
#include "synthesis/design.hpp"

namespace kempe {

struct PartFiles {
  std::vector<OutputFile> files;
  std::vector<std::string>
      left_out;  ///< what is not among them and why, a sentence each: "no nested.dxf: link ..."
};

/// parts/VA.dxf, parts/VA.svg, parts/VA.stl and so on for each link, parts/assembly.step if this build can
/// write it (step_assembly.hpp), bom.csv, and nested.dxf if the cutting has a sheet that takes the parts. Of links that
/// cannot be cut (parts_fault.hpp) only bom.csv.
PartFiles part_files(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
