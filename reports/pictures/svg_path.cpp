#include "reports/pictures/svg_path.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

/// The ring without corners that lie closer than `detail` to the one before.
ArcRing thinned(const ArcRing& ring, double detail) {
  ArcRing kept;
  for (const ArcVertex& vertex : ring) {
    if (!kept.empty() && (vertex.at - kept.back().at).norm() < detail) {
      kept.back().bulge = vertex.bulge;  // the short edge goes, the edge that leaves this corner stays
    } else {
      kept.push_back(vertex);
    }
  }
  return kept;
}

/// The middle of an edge's arc: it rises chord / 2 times the bulge to the right of the chord.
Point middle_of_arc(const ArcVertex& from, const Point& to) {
  const Point chord = to - from.at;
  return from.at + 0.5 * chord + 0.5 * from.bulge * Point(chord.y(), -chord.x());
}

void append_point(std::string& path, const Point& point) {
  append_coordinate(path, point.x());
  path += ',';
  append_coordinate(path, -point.y());
}

/// The edge from one corner to the next: a straight line, or a true arc of radius chord (1 + b^2) / (4 |b|).
/// With y downward a counter-clockwise arc (bulge > 0) has sweep-flag 0. Wide arcs are written as two halves:
/// near a half circle the rounding of the ends would move the centre that a reader finds from them.
void append_edge(std::string& path, const ArcVertex& from, const Point& to) {
  const double chord = (to - from.at).norm();
  const double b = from.bulge;
  if (std::abs(b) < 1e-9 || chord == 0) {
    path += 'L';
    return append_point(path, to);
  }
  if (std::abs(b) > 0.4) {
    const Point middle = middle_of_arc(from, to);
    const double half = std::tan(0.5 * std::atan(b));
    append_edge(path, {from.at, half}, middle);
    return append_edge(path, {middle, half}, to);
  }
  const std::string radius = coordinate(chord * (1 + b * b) / (4 * std::abs(b)));
  path.append(1, 'A').append(radius).append(1, ',').append(radius).append(b > 0 ? " 0 0 0 " : " 0 0 1 ");
  append_point(path, to);
}

std::string ring_path(const ArcRing& full, double detail) {
  const ArcRing ring = thinned(full, detail);
  if (ring.size() < 2) return {};
  std::string path = "M";
  append_point(path, ring.front().at);
  for (std::size_t i = 0; i < ring.size(); ++i) append_edge(path, ring[i], ring[(i + 1) % ring.size()].at);
  return path + "Z";
}

ArcRing straight(const Ring& ring) {
  ArcRing edges;
  edges.reserve(ring.size());
  for (const Point& corner : ring) edges.push_back({corner, 0});
  return edges;
}

}  // namespace

std::string svg_point(const Point& point) {
  std::string text;
  append_point(text, point);
  return text;
}

std::string svg_line(const std::vector<Point>& points) {
  std::string path;
  for (const Point& point : points) path += fmt::format("{}{}", path.empty() ? 'M' : 'L', svg_point(point));
  return path;
}

std::string svg_path(const ArcPolygon& polygon, double detail) {
  std::string path = ring_path(polygon.outer, detail);
  for (const ArcRing& hole : polygon.holes) path += ring_path(hole, detail);
  return path;
}

std::string svg_path(const ArcRegion& region, double detail) {
  std::string path;
  for (const ArcPolygon& polygon : region) path += svg_path(polygon, detail);
  return path;
}

std::string svg_path(const Polygon& polygon, double detail) {
  std::string path = ring_path(straight(polygon.outer), detail);
  for (const Ring& hole : polygon.holes) path += ring_path(straight(hole), detail);
  return path;
}

std::string svg_path(const Region& region, double detail) {
  std::string path;
  for (const Polygon& polygon : region.polygons) path += svg_path(polygon, detail);
  return path;
}

}  // namespace kempe
