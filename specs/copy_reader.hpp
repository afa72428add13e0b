#pragma once
// The [copy] table: a scale and a rotation, or pairs of points.

#include <optional>

#include "specs/spec.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// The copy asked for, and where its pole must be if pairs say so.
struct CopyReading {
  Copy copy;
  std::optional<Point> pole;  ///< the fixed point of the similarity that fits the pairs
};

/// Reads a [copy] table whose keys have been checked.
CopyReading read_copy(const TableView& table, Complaints& complaints);

}  // namespace kempe
