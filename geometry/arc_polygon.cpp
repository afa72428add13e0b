#include "geometry/arc_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

/// Area between chord and arc, mm^2, with the sign of the bulge: c^2/4 (f - sin f)/(1 - cos f) for the sweep
/// f.
double segment_area(double squared_chord, double bulge) {
  const double sweep = 4 * std::atan(bulge);
  // The quotient cancels for small sweeps, where its series f/3 + f^3/90 is exact to rounding.
  const double quotient = std::abs(sweep) < 1e-2 ? sweep / 3 + sweep * sweep * sweep / 90
                                                 : (sweep - std::sin(sweep)) / (1 - std::cos(sweep));
  return 0.25 * squared_chord * quotient;
}

/// How many equal parts of `sweep` keep chord or tangent polygon of a circle within `tolerance` of it.
int parts_within(double radius, double sweep, double tolerance, bool tangent_polygon) {
  // A flattening coarser than a quarter turn a part would not be recognised as the arc.
  const double cosine = tangent_polygon ? radius / (radius + tolerance) : 1 - tolerance / radius;
  const double half = std::min(std::acos(std::clamp(cosine, -1.0, 1.0)), pi / 8);
  const double count = std::ceil(std::abs(sweep) / (2 * std::max(half, 1e-7)));
  return std::max(1, static_cast<int>(count));
}

/// The corners strictly between both ends of an edge, flattened.
void append_inner_corners(Ring& ring, const Point& from, const Point& to, double bulge, double tolerance,
                          bool tangent_polygon) {
  const Complex chord = as_complex(to - from);
  const double sweep = 4 * std::atan(bulge);
  // Centre: half the chord, then left of it by cot(sweep / 2) / 2 of its length.
  const Complex to_centre = 0.5 * chord * Complex(1, (1 - bulge * bulge) / (2 * bulge));
  const double radius = std::abs(to_centre);
  const Complex centre = as_complex(from) + to_centre;
  const int count = parts_within(radius, sweep, tolerance, tangent_polygon);
  const double step = sweep / count;
  const double stretch = tangent_polygon ? 1 / std::cos(0.5 * step) : 1;
  const double first = tangent_polygon ? 0.5 : 1;
  for (int i = 0; i < (tangent_polygon ? count : count - 1); ++i)
    ring.push_back(as_point(centre - to_centre * std::polar(stretch, (first + i) * step)));
}

Ring flattened(const ArcRing& ring, double tolerance, Flatten side) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ArcVertex& vertex = ring[i];
    const Point& next = ring[(i + 1) % ring.size()].at;
    result.push_back(vertex.at);
    if (vertex.bulge == 0 || next == vertex.at) continue;
    // The area lies left of every edge, so an arc to the left bulges out of it: its chords lie inside.
    const bool chords_shrink = vertex.bulge > 0;
    append_inner_corners(result, vertex.at, next, vertex.bulge, tolerance,
                         chords_shrink != (side == Flatten::shrinks));
  }
  return result;
}

}  // namespace

double signed_area(const ArcRing& ring) {
  if (ring.empty()) return 0;
  const Point origin = ring.front().at;
  double twice = 0, segments = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& from = ring[i].at;
    const Point& to = ring[(i + 1) % ring.size()].at;
    twice += cross(from - origin, to - origin);
    if (ring[i].bulge != 0) segments += segment_area((to - from).squaredNorm(), ring[i].bulge);
  }
  return 0.5 * twice + segments;
}

double area(const ArcPolygon& polygon) {
  double sum = signed_area(polygon.outer);
  for (const ArcRing& hole : polygon.holes) sum += signed_area(hole);
  return sum;
}

double area(const ArcRegion& region) {
  double sum = 0;
  for (const ArcPolygon& polygon : region) sum += area(polygon);
  return sum;
}

ArcRing circle(const Point& centre, double radius) {
  const Point arm(radius, 0);
  return {{centre + arm, 1}, {centre - arm, 1}};
}

ArcRing reversed(const ArcRing& ring) {
  ArcRing result;
  result.reserve(ring.size());
  for (std::size_t i = ring.size(); i-- > 0;)
    result.push_back({ring[i].at, -ring[(i + ring.size() - 1) % ring.size()].bulge});
  return result;
}

Polygon flattened(const ArcPolygon& polygon, double tolerance, Flatten side) {
  Polygon result{flattened(polygon.outer, tolerance, side), {}};
  for (const ArcRing& hole : polygon.holes) result.holes.push_back(flattened(hole, tolerance, side));
  return result;
}

Region flattened(const ArcRegion& region, double tolerance, Flatten side) {
  Region result;
  for (const ArcPolygon& polygon : region) result.polygons.push_back(flattened(polygon, tolerance, side));
  return result;
}

ArcRegion similar_image(const ArcRegion& region, Complex k, const Point& pole) {
  const auto move = [&](ArcRing& ring) {
    for (ArcVertex& vertex : ring) vertex.at = pole + as_point(k * as_complex(vertex.at - pole));
  };
  ArcRegion image = region;
  for (ArcPolygon& polygon : image) {
    move(polygon.outer);
    for (ArcRing& hole : polygon.holes) move(hole);
  }
  return image;
}

}  // namespace kempe
