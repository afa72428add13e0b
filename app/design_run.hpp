#pragma once
// What `synthesize` and `workspace` share: the spec read, the design verified, written and told.

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/command.hpp"
#include "reports/publication.hpp"
#include "specs/spec.hpp"
#include "synthesis/design/design.hpp"
#include "synthesis/search/search.hpp"

namespace kempe::app {

/// A spec with the text it came from, which the report shows.
struct LoadedSpec {
  std::string file, text;
  Spec spec;
  /// The files that the run reads: the spec, and the drawing that it names.
  std::vector<std::filesystem::path> inputs() const;
  /// Of the lengths in the text.
  SpecUnit unit() const;
};
tl::expected<LoadedSpec, InputError> load_spec(const Session& session, const std::string& file);
/// The same of its text, already read.
tl::expected<LoadedSpec, InputError> spec_of_text(std::string text, const std::string& file);

/// A fault found in what the file means, with its keys as the file has them.
InputError as_in_file(InputError fault, SpecUnit unit);

/// The file's name as a report may show it: bytes that are no UTF-8 become U+FFFD.
std::string shown_name(const std::string& file);

/// Verifies the design, writes its folder and prints the summary. `studio_page` is the text of the studio's page to be written
/// beside the report, which then leads to it; empty: none. `paper` is that of workshop.pdf; on
/// two `threads` or more, files that do not need each other are made at once. `proof`: the log, if it is made already. Returns the exit code: `verification_failed` (and nothing written),
/// `cannot_write`, or done.
int publish_design(const Session& session, Design& design, const LoadedSpec& spec,
                   const std::filesystem::path& folder, const TimeToFinish& time = {},
                   const std::string& studio_page = {}, Paper paper = Paper::A4, int threads = 1,
                   std::optional<CertificateOrNone> proof = {});

/// The option --paper, of workshop.pdf.
CLI::Option* add_paper_option(CLI::App& command, Paper& paper);

/// Where the log of a proof that there is no design may be written.
struct ProofFolder {
  const LoadedSpec& spec;
  std::filesystem::path folder;
  StopFlag stop;
};

/// Says why no design exists and what would make one possible, the designs in `unit`, in which SearchOptions::unit has had the
/// sentences; a proof's log goes into the folder, if one is given. Returns
/// `no_design` where that is proven, else `stopped`: the search's work was spent without an answer; or `cannot_write`.
int tell_no_design(const Session& session, const NoDesign& none, SpecUnit unit,
                   const std::optional<ProofFolder>& proof = std::nullopt);

/// The summary that a person reads, in mm with the spec's keys as its file has them, or with --json one object; `left_out`: sentences about files that are not there.
std::string summary_text(const Design& design, SpecUnit unit, const std::filesystem::path& folder,
                         const std::vector<std::string>& files, const std::vector<std::string>& left_out);
std::string summary_json(const Design& design, const std::filesystem::path& folder,
                         const std::vector<std::string>& files, const std::vector<std::string>& left_out);

}  // namespace kempe::app
