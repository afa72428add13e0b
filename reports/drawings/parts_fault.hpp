#pragma once
// Whether the links of a design can be cut at all.

#include <optional>
#include <string>

#include "specs/spec.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// Why the links cannot be cut.
struct PartsFault {
  std::string note;      ///< a few words for a title block: "their holes are as wide as the links"
  std::string sentence;  ///< with the figures, and what would do
};

/// A wall thinner than this share of the hole's diameter is none.
inline constexpr double least_wall_share = 1e-3;

/// Nothing if every hole, as the cut leaves it, has a wall all around: beside it the link is wider than the hole, and no other
/// hole of its link is as near as a hole is wide. A hole stands in the middle of a round end or corner of the link's own
/// width, so the wall beside it is the same at the link's end, along its sides and for all lengths.
std::optional<PartsFault> parts_fault(const Design& design, const CuttingSpec& cutting);

}  // namespace kempe
