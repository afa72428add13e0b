#pragma once
// From a linkage to a finished design: opening certified, workspace mapped, quality measured. Verification is
// not part of it (verification.hpp).

#include <algorithm>
#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"
#include "synthesis/design/design.hpp"
#include "synthesis/search/search.hpp"

namespace kempe {

/// How much of a design is worked out.
enum class Detail {
  full,
  figures  ///< without the footprint, half the work beside the search, and without the reasons for its layers
};

/// What else is made of a design beside its map: it may look at what the spec and the search say of the design, its bound included, and at
/// nothing that is measured.
using BesideMap = std::function<void(const Design&)>;

/// The design that a search found, with the record of the search. On two `threads` or more the footprint, the reasons for its layers and
/// `beside` are worked out beside the map; the design is the same.
Design assemble_design(const Spec& spec, const FoundDesign& found, const MapOptions& options,
                       Detail detail = Detail::full, int threads = 1, const BesideMap& beside = {});

/// The same, if its map shows that it covers the region; else a sentence that says why it is no design.
tl::expected<Design, std::string> certified_design(const Spec& spec, const FoundDesign& found,
                                                   const MapOptions& options, Detail detail = Detail::full,
                                                   int threads = 1, const BesideMap& beside = {});

/// By how much commands may exceed a time limit (s).
inline double grace_after(double limit) { return std::max(0.1, 0.1 * limit); }
/// A design found when the limit was over is mapped, verified and proven for so much longer, s; then all that stays as it is.
inline double time_to_map(double limit) { return 0.4 * grace_after(limit); }
/// And its files are written for so much longer.
inline double time_to_write(double limit) { return 0.65 * grace_after(limit); }

/// The linkage that the spec's mechanism gives; `file` is for the error.
tl::expected<CopyingLinkage, InputError> given_linkage(const Spec& spec, const std::string& file);

/// A given linkage in the spec's layers, or without them in the assignment that covers the region with the
/// widest contact-free opening (the first of equals). It need not keep any limit of the spec: the map says
/// where it does.
Design assemble_given(const Spec& spec, const CopyingLinkage& linkage, const MapOptions& options);

/// What map_workspace() and verdict_at() need to know about a design. The task's region is the design's.
MapTask map_task(const Design& design);

}  // namespace kempe
