#pragma once
// Distances as the verification measures them: edge by edge. Not geometry/segment_distance.hpp, by which the map keeps clear: a fault
// there must show here.

#include <vector>

#include "geometry/region.hpp"
#include "kempe/mechanism.hpp"
#include "workspace/parts.hpp"

namespace kempe::plain {

/// A point, a segment, or the corners of a polygon in either direction, mm.
using Corners = std::vector<Point>;

/// A hull's joints in a pose.
Corners corners_of(const JointHull& hull, const Pose& pose);

/// The place of a segment from `from` along `along` that is nearest to a point, as a share of the way.
double nearest_share(const Point& point, const Point& from, const Point& along);

/// Between two segments, mm; 0 if they cross.
double distance(const Point& a, const Point& b, const Point& c, const Point& d);

/// The smallest between the edges of one and those of the other, mm.
double distance_of_edges(const Corners& one, const Corners& other);

/// True if the polygon holds the point; false for fewer than three corners.
bool holds(const Corners& polygon, const Point& point);

/// Between two sets with what polygons enclose, mm; 0 if they overlap.
double distance(const Corners& one, const Corners& other);

/// A lower bound of that distance.
double distance_of_boxes(const Corners& one, const Corners& other);
double distance_of_boxes(const Corners& one, const Box& other);

}  // namespace kempe::plain
