#pragma once
// What regions measure and contain.

#include "geometry/point.hpp"
#include "kempe/point.hpp"

namespace kempe {

struct Box {
  Point lower, upper;
};

/// Area enclosed by a ring, mm^2: positive if it runs counter-clockwise.
double signed_area(const Ring& ring);
/// Area of the region, mm^2.
double area(const Region& region);
/// The side of the squares of a grid, mm, of which about `places` corners lie in the region; larger where that grid over the region's box
/// would have more than some 100,000 corners, as of two specks far apart. The region must not be empty.
double grid_step(const Region& region, double places);
/// The ring without corners nearer than `detail` (mm, >= 0) to the last one kept: for pictures and
/// first guesses, never for a part.
Ring thinned(const Ring& ring, double detail);
/// Smallest axis-parallel box; the region must not be empty.
Box bounding_box(const Region& region);
/// True if the point lies inside or on the boundary (ray crossing; on-boundary cases decided in floating point).
bool contains(const Region& region, const Point& point);
/// Distance from a point to the region, mm; 0 inside.
double distance(const Region& region, const Point& point);
/// Smallest and largest distance from `centre` to points of the region, mm (smallest 0 if the centre lies inside).
struct DistanceRange {
  double nearest, farthest;
};
DistanceRange distance_range(const Region& region, const Point& centre);
/// The image under z -> pole + k (z - pole).
Region similar_image(const Region& region, Complex k, const Point& pole);

}  // namespace kempe
