#pragma once
// Annular sectors about the origin against segments.

#include <optional>

#include "geometry/edge_tree.hpp"

namespace kempe {

/// The points at distances [inner, outer] (mm) and bearings [from, to] (rad, to - from < pi) from the origin.
struct Sector {
  double inner, outer;
  double from, to;
};

/// A point of the segment in the sector; nothing if there is none. Exact up to rounding.
std::optional<Point> point_in(const Sector& sector, const EdgeTree::Edge& edge);

/// A box around the sector.
Box box_around(const Sector& sector);

}  // namespace kempe
