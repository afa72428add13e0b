#pragma once
// Polygons whose edges are straight or circular arcs: outlines of links, areas of the map.

#include <vector>

#include "geometry/region.hpp"

namespace kempe {

/// A corner and the edge that leaves it. bulge = tan(sweep / 4), positive to the left (counter-clockwise), 0:
/// straight.
struct ArcVertex {
  Point at;
  double bulge = 0;
};
/// A closed ring; a full circle is two half arcs (bulge 1 each).
using ArcRing = std::vector<ArcVertex>;

/// Outer ring counter-clockwise, holes clockwise.
struct ArcPolygon {
  ArcRing outer;
  std::vector<ArcRing> holes;
};
/// Polygons with disjoint interiors.
using ArcRegion = std::vector<ArcPolygon>;

/// Area enclosed, mm^2: exact up to rounding, the arcs' segments included; positive if counter-clockwise.
double signed_area(const ArcRing& ring);
double area(const ArcPolygon& polygon);
double area(const ArcRegion& region);

/// A full circle, counter-clockwise.
ArcRing circle(const Point& centre, double radius);
/// The ring run the other way.
ArcRing reversed(const ArcRing& ring);

/// On which side of the true curve a flattened one may lie.
enum class Flatten {
  shrinks,  ///< the result lies inside the region: right for free sets
  grows     ///< the result contains the region: right for forbidden sets
};
/// Straight-edged rings within `tolerance` (mm, > 0) of the arcs, on the stated side.
Polygon flattened(const ArcPolygon& polygon, double tolerance, Flatten side);
Region flattened(const ArcRegion& region, double tolerance, Flatten side);

/// The image under z -> pole + k (z - pole).
ArcRegion similar_image(const ArcRegion& region, Complex k, const Point& pole);

}  // namespace kempe
