#pragma once
// Regions from GeoJSON (RFC 7946), its coordinates taken as millimetres in the table's frame.

#include "specs/drawings/region_file.hpp"

namespace kempe {

/// Reads a FeatureCollection, a Feature, a GeometryCollection, a Polygon or a MultiPolygon: all polygons in
/// it make one region. Rings may run either way round; a third coordinate is passed over; null geometries
/// are, too. Any other geometry and a repeated key are refused; polygons that overlap or touch are united.
/// Errors name the place in the file
/// ("features[2].geometry.coordinates[0]") as key.
tl::expected<Region, InputError> read_geojson_region(std::string_view contents, const std::string& file_name,
                                                     const RegionFileOptions& options);

}  // namespace kempe
