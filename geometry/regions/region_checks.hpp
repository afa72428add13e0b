#pragma once
// From rings as somebody drew them to a region that keeps its invariant, or what is wrong with them.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/region.hpp"

namespace kempe {

/// Coordinates may not exceed this, mm (ten kilometres): doubles then resolve 1e-9 mm.
inline constexpr double largest_coordinate = 1e7;
/// A ring must be at least this wide, mm, across the line from its first corner to the corner farthest from
/// it.
inline constexpr double smallest_ring_width = 1e-6;

/// Which ring is at fault, and why.
struct RingFault {
  enum class Kind {
    no_ring,       ///< there is no outer ring
    shape,         ///< a ring by itself: corners, coordinates, area
    self_contact,  ///< a ring crosses or touches itself
    contact,       ///< two rings cross or touch
    nesting        ///< a ring lies where it may not
  };
  Kind kind = Kind::no_ring;
  bool is_hole = false;
  std::size_t ring = 0;  ///< from 0, in the list of outer rings or of holes
  std::string found, allowed;
};

/// The ring without corners that repeat the one before (the last before the first, too).
Ring without_repeated_corners(const Ring& ring);

/// What is wrong with a ring by itself, apart from crossings: too few corners, coordinates that are not
/// finite or too large, zero area. Nothing if all is well. Expects no repeated corners.
struct ShapeFault {
  std::string found, allowed;
};
std::optional<ShapeFault> shape_fault(const Ring& ring);

/// Makes a region of outer rings and holes that may run either way round and repeat corners.
///  1. The result keeps the invariant of Polygon: simple rings that nowhere touch, outer ones counter-clockwise, holes
///     clockwise, each hole in the polygon that surrounds it. Islands in holes are polygons of their own.
///  2. Crossing, touching or overlapping rings, an outer ring in another without a hole between, a hole outside or
///     within a hole are refused: nothing is repaired in silence.
/// O(n log n) for n corners.
tl::expected<Region, RingFault> assemble_region(const std::vector<Ring>& outers,
                                                const std::vector<Ring>& holes);

/// "edge 3 from [1, 2] to [4, 5]": the edge that leaves corner `edge` (from 0; people count from 1).
std::string describe_edge(const Ring& ring, std::size_t edge);

}  // namespace kempe
