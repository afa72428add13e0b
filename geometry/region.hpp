#pragma once
// Plane regions with straight edges: what the tracer must cover, where the pole may stand, what is in the way.

#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// A closed ring of points, mm; the last point is not the first repeated.
using Ring = std::vector<Point>;

/// Invariant (kept by the reader, assumed by all others): rings are simple and do not cross, the outer ring runs
/// counter-clockwise, holes run clockwise and lie inside.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
  bool operator==(const Polygon&) const = default;
};

/// A set of polygons with disjoint interiors, mm.
struct Region {
  std::vector<Polygon> polygons;
  bool empty() const { return polygons.empty(); }
  bool operator==(const Region&) const = default;
};

struct Box {
  Point lower, upper;
};

/// Area enclosed by a ring, mm^2: positive if it runs counter-clockwise.
double signed_area(const Ring& ring);
/// Area of the region, mm^2.
double area(const Region& region);
/// The ring without corners nearer than `detail` (mm, >= 0) to the last one kept: for pictures, never for a part.
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
