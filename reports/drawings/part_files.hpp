#pragma once
// The files of the parts: each link alone, all of them nested on a sheet, the bill of materials.

#include <string>
#include <vector>

#include "reports/data/atomic_file.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

struct PartFiles {
  std::vector<OutputFile> files;
  /// What is not among them and why, a sentence each: "no nested.dxf: link ...".
  std::vector<std::string> left_out;
};

/// parts/VA.dxf, parts/VA.svg, parts/VA.stl and so on for each link, parts/assembly.step, bom.csv, and nested.dxf if the cutting has a
/// sheet that takes the parts. Of links that cannot be cut (parts_fault.hpp) only bom.csv. Once `stop` is set, the assembly, which takes longest, is left out.
PartFiles part_files(const Design& design, const CuttingSpec& cutting, const StopFlag& stop = {});

}  // namespace kempe
