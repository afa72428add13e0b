#pragma once
// A design's folder, ready to be put in place: verified, written beside its place, read again.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "reports/certificate.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/design_package.hpp"
#include "reports/page/html_report.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// Why a design is not published.
struct NotPublished {
  enum class By { verification, rereading, writing } by;
  std::string sentence;
};

struct Drafted {
  std::vector<std::string> left_out;  ///< sentences about files that are not there
  bool has_parts = true;              ///< false: the links cannot be cut
};

/// Fills in the design's verification, and gives all its files (design_package.hpp) to the draft.
///  1. Nothing is drafted of a design that fails its verification.
///     Its bound comes with the log of its proof (certificate.hpp): where that does not close before there is `enough`, no bound is
///     stated. From then on the design is verified at few places.
///  2. The drawings are read again from the draft; where they are not the design, the error says so. Once the time is over, they are not read.
/// Files are made on up to `threads` threads; the bytes are the same. The proof's log may have been made beside the map: `proof`. Putting
/// the draft in place is the caller's.
tl::expected<Drafted, NotPublished> draft_design(Design& design, ReportExtras extras, FolderDraft& draft,
                                                 const TimeToFinish& time = {}, int threads = 1,
                                                 std::optional<CertificateOrNone> proof = {});

}  // namespace kempe
