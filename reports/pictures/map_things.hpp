#pragma once
// The things on the map's picture: obstacles, sheets, the region and its copy, the footprint, contours.

#include <string>
#include <vector>

#include "reports/pictures/map_scene.hpp"

namespace kempe {

/// The things from the table upward; each enters its layer into the legend. Names of sheets and contours stand where `placer`
/// has room for them, or not at all.
std::string map_things(const MapScene& scene, std::vector<MapLayer>& layers, LabelPlacer& placer);

}  // namespace kempe
