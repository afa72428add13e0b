#pragma once
// A design as files and texts: design.json, report, drawings, parts.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"
#include "kempe/input_error.hpp"

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

/// The report that write() writes as report.html, one self-contained page; it speaks of no proof's log, which only write() makes.
KEMPE_EXPORT std::string report(const FinishedDesign& design, const std::string& title = "design");
/// The drawing that write() writes as drawing.svg: all links and the assembly at 1:1.
KEMPE_EXPORT std::string drawing(const FinishedDesign& design);

/// FinishedDesign::json() with what verify() finds, so that `kempe verify` and restore() take it as a file. Its bound is the search's;
/// that of a file of write() may be a little looser (docs/design-file.md).
KEMPE_EXPORT std::string verified_json(const FinishedDesign& design);

/// What becomes of the bound that a design.json claims.
enum class ClaimedBound {
  prove,  ///< kept, perhaps a little looser, where its proof is found again; else the design has none
  keep    ///< kept: for a text that comes from verified_json() and nobody else
};
/// The design that the text of a design.json states, of whatever origin; `name` stands for the file in messages. It is verified as
/// verify() does; task, mechanism and the record of the search are the text's; all else is computed anew.
/// Errors: what cannot be read; a limit that does not hold, by its key.
KEMPE_EXPORT std::variant<FinishedDesign, InputError> restore(std::string_view json,
                                                              const std::string& name = "",
                                                              ClaimedBound bound = ClaimedBound::prove);

}  // namespace kempe
