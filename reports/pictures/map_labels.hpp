#pragma once
// The words on the map's picture: joints, region, copy and obstacles, each at a place clear of lines and of other words.

#include <string>

#include "reports/pictures/map_scene.hpp"

namespace kempe {

/// All words as one group; of many obstacles those nearest to the pole are named. `placer` knows then what is taken.
std::string map_labels(const MapScene& scene, LabelPlacer& placer);

}  // namespace kempe
