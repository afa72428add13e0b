#pragma once
// Exact algebra of regions bounded by segments and circular arcs. CGAL's Boolean sets stand behind it;
// doubles decide first wherever they can.
//
// Coordinates are taken as the exact numbers that the doubles are, an arc as the circle through its ends and
// its middle (a ring of two half arcs as the exact circle). All rings must be simple and finite; outer rings
// and holes are told by their place in ArcPolygon, their direction is put right. Rings without area are left
// out. No function throws.

#include <optional>

#include "geometry/arc_polygon.hpp"
#include "geometry/edge_tree.hpp"

namespace kempe {

/// A straight-edged region as a region of arcs.
ArcRegion as_arcs(const Region& region);

/// Everything in one of the regions at least.
ArcRegion united(const std::vector<ArcRegion>& regions);
/// Everything in both.
ArcRegion intersection(const ArcRegion& one, const ArcRegion& other);
/// Everything in `whole` and not in `taken`.
ArcRegion difference(const ArcRegion& whole, const ArcRegion& taken);

/// True if no part of `inner` with an area lies outside `outer`. Microseconds to milliseconds where the
/// boundaries keep apart; where they touch or cross, the exact difference decides.
bool contains(const ArcRegion& outer, const ArcRegion& inner);

/// True if the regions' interiors are disjoint and no two of their points are nearer than `gap` (mm, >= 0):
/// exact, and touching at distance `gap` counts as kept.
bool are_apart(const Region& one, const Region& other, double gap);

/// Where two regions come nearest, mm; distance 0 if they overlap (then both places are one). Floating point.
struct NearestPlaces {
  double distance;
  Point on_one, on_other;
};
/// Nothing if one of them is empty.
std::optional<NearestPlaces> nearest_places(const Region& one, const Region& other);
/// The same of edges alone, whatever they enclose, by trees that are there already; nothing where none are nearer than `enough`, mm.
std::optional<NearestPlaces> nearest_edges(const EdgeTree& one, const EdgeTree& other, double enough);

}  // namespace kempe
