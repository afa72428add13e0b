#pragma once
// A design as files: design.json, report, drawings, parts.

#include <filesystem>
#include <string>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"

namespace kempe {

/// What became of a folder.
struct Written {
  std::vector<std::string> files;     ///< names within the folder; empty if nothing was written
  std::vector<std::string> left_out;  ///< sentences about files that are not there
  std::string reason;                 ///< why nothing was written; empty if all is well

  /// True if all is written.
  explicit operator bool() const { return reason.empty(); }
};

/// Writes what `kempe synthesize` writes: all files or none, each whole. The folder is made if it is not there; files of
/// these names in it are replaced. Before anything is written the design is verified and its drawings are read again and
/// compared with it; where either fails nothing is written, and `reason` says so. A bound comes with the log of its proof,
/// certificate.jsonl, which proof/kempe_check.py checks without this library (docs/proof.md). `title` heads the report.
KEMPE_EXPORT Written write(const FinishedDesign& design, const std::filesystem::path& folder,
                           const std::string& title = "design");

}  // namespace kempe
