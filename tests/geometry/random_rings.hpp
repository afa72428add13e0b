#pragma once
// Rings to try things on: the same on every machine for the same generator.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/region.hpp"
#include "tests/random.hpp"

namespace kempe {

using test::uniform;

/// A simple counter-clockwise ring about the origin: corners at increasing angles, none of them 180 degrees
/// apart.
inline Ring star_ring(std::mt19937_64& random, int corners, double radius) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + uniform(random, 0.05, 0.45)) / corners;
    ring.push_back(as_point(std::polar(uniform(random, 0.3, 1) * radius, angle)));
  }
  return ring;
}

/// Corners at random, on a grid of whole numbers if `grid` > 0: often crossing, touching, folded back.
inline Ring tangled_ring(std::mt19937_64& random, int corners, int grid) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double x = uniform(random, 0, 1);
    Point corner(x, uniform(random, 0, 1));
    if (grid > 0) corner = (corner * grid).array().floor().matrix();
    ring.push_back(corner);
  }
  return ring;
}

}  // namespace kempe
