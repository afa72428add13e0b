#pragma once
// The areas of the map's picture: reachable, usable, free, uncertain, and what is lost with its causes.

#include <string>
#include <vector>

#include "reports/pictures/map_scene.hpp"

namespace kempe {

/// The areas from the table upward; each enters its layer into the legend, the map's first.
std::string map_areas(const MapScene& scene, std::vector<MapLayer>& layers);

}  // namespace kempe
