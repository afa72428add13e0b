#pragma once
// Regions as GeoJSON geometry (the structure of RFC 7946; the coordinates are mm in the table's frame).

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/region.hpp"

namespace kempe {

/// [x, y]; the numbers must be finite.
nlohmann::ordered_json position(const Point& point);

/// {"type": "MultiPolygon", "coordinates": ...}: rings closed by repeating the first position, outer rings
/// counter-clockwise, holes clockwise.
nlohmann::ordered_json multi_polygon(const Region& region);

/// Appends the text that multi_polygon(region).dump(indent) has where it stands `depth` levels deep (indent as there: -1
/// for one line), without ever holding the values, which take twice the text's memory.
void append_multi_polygon(std::string& text, const Region& region, int indent, int depth);

}  // namespace kempe
