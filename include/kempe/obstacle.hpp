#pragma once
// What stands in the way.

#include <string>

#include "kempe/region.hpp"

namespace kempe {

/// Something in the way of links, pins and posts, in some of the layers.
struct Obstacle {
  Polygon shape;          ///< mm, without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "obstacle 2" unless the spec names it; empty if not from a spec
};

}  // namespace kempe
