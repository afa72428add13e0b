#pragma once
// What the map's benches map: the plagiograph report's mechanism with 6 mm links in two layers; obstacles are stars of 20
// corners strewn over the pen's reach, smaller the more there are, so that something stays free.

#include <cmath>
#include <complex>
#include <random>

#include "workspace/map/workspace_map.hpp"

namespace kempe::bench {

class Dice {
 public:
  double between(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_{5};
};

inline Polygon star(Dice& dice, const Point& centre, double size, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.outer.push_back(centre + as_point(std::polar(size * dice.between(0.6, 1), 2 * pi * i / corners)));
  return polygon;
}

inline Polygon disc(const Point& centre, double radius, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.outer.push_back(centre + as_point(std::polar(radius, 2 * pi * i / corners)));
  return polygon;
}

inline MapTask report_task() {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  return {linkage, {6, 3, 4, PlateStyle::bent}, {}, {.clearance = 0.5, .transmission = radians(20)}};
}

inline MapTask task_with(int obstacles) {
  MapTask task = report_task();
  Dice dice;
  for (int i = 0; i < obstacles; ++i) {
    const Point centre = as_point(std::polar(dice.between(96, 125), dice.between(-pi, pi)));
    task.obstacles.push_back({star(dice, centre, 14 / std::sqrt(obstacles + 4.0), 20), 1, 2, {}});
  }
  return task;
}

}  // namespace kempe::bench
