#include "reports/geojson_geometry.hpp"

namespace kempe {
namespace {

using nlohmann::ordered_json;

ordered_json closed_ring(const Ring& ring) {
  ordered_json positions = ordered_json::array();
  for (const Point& point : ring) positions.push_back(position(point));
  if (!ring.empty()) positions.push_back(position(ring.front()));
  return positions;
}

}  // namespace

ordered_json position(const Point& point) { return ordered_json::array({point.x(), point.y()}); }

ordered_json multi_polygon(const Region& region) {
  ordered_json coordinates = ordered_json::array();
  for (const Polygon& polygon : region.polygons) {
    ordered_json rings = ordered_json::array({closed_ring(polygon.outer)});
    for (const Ring& hole : polygon.holes) rings.push_back(closed_ring(hole));
    coordinates.push_back(std::move(rings));
  }
  return {{"type", "MultiPolygon"}, {"coordinates", std::move(coordinates)}};
}

}  // namespace kempe
