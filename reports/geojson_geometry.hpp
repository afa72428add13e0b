#pragma once
// Regions as GeoJSON geometry (the structure of RFC 7946; the coordinates are mm in the table's frame).

#include <nlohmann/json.hpp>

#include "specs/region.hpp"

namespace kempe {

/// [x, y]; the numbers must be finite.
nlohmann::ordered_json position(const Point& point);

/// {"type": "MultiPolygon", "coordinates": ...}: rings closed by repeating the first position, outer rings
/// counter-clockwise, holes clockwise.
nlohmann::ordered_json multi_polygon(const Region& region);

}  // namespace kempe
