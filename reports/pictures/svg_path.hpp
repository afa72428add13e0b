#pragma once
// Shapes as SVG path data: millimetres, y turned downward, arcs kept as true arcs.

#include <string>

#include "geometry/arc_polygon.hpp"

namespace kempe {

/// Closed sub-paths for all rings, for fill-rule evenodd. Corners closer than `detail` (mm, >= 0) to the last
/// one kept are left out: right for a picture, never for a part.
std::string svg_path(const ArcRegion& region, double detail);
std::string svg_path(const ArcPolygon& polygon, double detail);
std::string svg_path(const Region& region, double detail);
std::string svg_path(const Polygon& polygon, double detail);

/// An open line through the points.
std::string svg_line(const std::vector<Point>& points);

/// "x,y" with y turned downward.
std::string svg_point(const Point& point);

}  // namespace kempe
