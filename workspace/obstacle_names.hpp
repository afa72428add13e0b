#pragma once
// What parts and people call an obstacle by: its layers and its name.

#include <string>
#include <vector>

#include "workspace/parts.hpp"

namespace kempe {

/// True if the part stands in one of the obstacle's layers.
inline bool share_layer(const Part& part, const Obstacle& obstacle) {
  return part.lowest_layer <= obstacle.highest_layer && obstacle.lowest_layer <= part.highest_layer;
}

/// The obstacle's name, or "obstacle 2": numbered from 1 in the order of the list.
inline std::string obstacle_name(const std::vector<Obstacle>& obstacles, std::size_t index) {
  const std::string& given = obstacles[index].name;
  return given.empty() ? "obstacle " + std::to_string(index + 1) : given;
}

}  // namespace kempe
