#pragma once
// A design as files and texts: design.json, report, drawings, parts; a spec as the studio's page.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/calibrate.hpp"
#include "kempe/design.hpp"
#include "kempe/drawing_options.hpp"
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

/// What of a design's folder may be chosen.
struct WriteOptions {
  std::string title = "design";  ///< heads the report
  Paper paper = Paper::A4;       ///< of workshop.pdf
  /// The text of the page that scripts/studio builds: studio.html is then it with the design's spec inside, and the report leads to it.
  /// Empty: without studio.html.
  std::string studio{};
};

/// Writes what `kempe synthesize` writes: all files or none, each whole. The folder is made if it is not there; files of
/// these names in it are replaced. Before anything is written the design is verified and its drawings are read again and
/// compared with it; where either fails nothing is written, and `reason` says so. A bound comes with the log of its proof,
/// certificate.jsonl, which proof/kempe_check.py checks without this library (docs/proof.md).
KEMPE_EXPORT Written write(const FinishedDesign& design, const std::filesystem::path& folder,
                           const WriteOptions& options = {});

/// Writes what `kempe pareto` writes: a folder a point ("01", "02", ...) as above, and the front's own report.html and front.csv. `files` are
/// below the front's folder; `reason` names the point that it is about. Of the options `studio` plays no part.
KEMPE_EXPORT Written write(const Front& front, const std::filesystem::path& folder,
                           const WriteOptions& options = {});

/// Writes what `kempe calibrate` writes into its folder: calibration.json, report.html and, of a simulation, simulated.toml; all or none.
KEMPE_EXPORT Written write(const CalibratedInstrument& found, const std::filesystem::path& folder);

/// Why there is no log of a proof.
struct NoProof {
  std::string sentence;  ///< for a person
};
/// certificate.jsonl as `kempe synthesize` writes it where no design exists (Outcome::proven()): the log of that proof, which
/// proof/kempe_check.py checks without this library (docs/proof.md). The spec is checked first. `stop`: asked often; true ends it.
KEMPE_EXPORT std::variant<std::string, InputError, NoProof> proof_of_none(
    const Spec& spec, const std::function<bool()>& stop = {});

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
/// Errors: what cannot be read; a limit that does not hold, by its key. `stop`: asked often; once true the map stays as coarse as it is
/// (Map::complete() is false), and a bound whose proof is not finished is left out.
KEMPE_EXPORT std::variant<FinishedDesign, InputError> restore(std::string_view json,
                                                              const std::string& name = "",
                                                              ClaimedBound bound = ClaimedBound::prove,
                                                              const std::function<bool()>& stop = {});

/// What `kempe studio` writes: one page (HTML) that opens with the spec. `page` is the text of the page that scripts/studio builds, `spec` a
/// spec's file (TOML), `name` what the page calls it; a drawing that the spec names is looked for in `folder`.
/// Errors: the spec's faults; a drawing that cannot be read; a page that is not the studio's (key "page").
KEMPE_EXPORT std::variant<std::string, InputError> studio_page(const std::string& page, std::string_view spec,
                                                               const std::string& name = "spec",
                                                               const std::filesystem::path& folder = {});

}  // namespace kempe
