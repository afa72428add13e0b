#pragma once
// Are rings simple and apart, how do they run and which lies in which: one sweep over all of them.

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/region.hpp"

namespace kempe {

/// An edge of one of several rings: from corner `edge` to the next corner (both from 0).
struct RingEdge {
  std::size_t ring, edge;
  bool operator==(const RingEdge&) const = default;
};

/// Two edges that have a point in common and should not.
struct RingContact {
  RingEdge first, second;
};

/// How rings that nowhere meet lie to each other.
struct RingNesting {
  std::vector<bool> counter_clockwise;  ///< of each ring
  /// The smallest ring around each; nothing for the outermost.
  std::vector<std::optional<std::size_t>> parent;
};

/// Examines rings of at least three corners in which no corner equals the next one and all coordinates are
/// finite.
///  1. Either no ring crosses or touches itself or another, and their directions and nesting come back,
///  2. or two edges that meet come back: neighbours on a ring only if they fold back onto each other.
/// Exact decisions (orientation.hpp); time O(n log n) for n corners in all, whatever their shape.
/// Source: M. I. Shamos and D. Hoey, Geometric intersection problems, 1976; stops at the first contact.
tl::expected<RingNesting, RingContact> examine_rings(const std::vector<Ring>& rings);

}  // namespace kempe
