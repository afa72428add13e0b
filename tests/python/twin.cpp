// The task of every line of the input, filled in field by field as a program of C++ does, and what comes of it: on each line the
// number of bytes, then design.json or the reason why there is no design.
//
// A line: scale, rotation (deg), the region's rectangle (x, y, width, height, mm), width and pin of the links, clearance (mm),
// transmission (deg), layers, 1 for a pole within a square of 20 mm, 1 for an obstacle, 1 to maximize the transmission.

#include <iostream>
#include <kempe/kempe.hpp>
#include <string>

namespace {

struct Task {
  double scale, rotation, x, y, width, height, link_width, pin, clearance, transmission;
  int layers;
  bool has_area, has_obstacle, is_steep;
};

std::istream& operator>>(std::istream& in, Task& t) {
  return in >> t.scale >> t.rotation >> t.x >> t.y >> t.width >> t.height >> t.link_width >> t.pin >>
         t.clearance >> t.transmission >> t.layers >> t.has_area >> t.has_obstacle >> t.is_steep;
}

kempe::Spec spec_of(const Task& t) {
  kempe::Spec spec;
  spec.copy = kempe::Copy::of(t.scale, t.rotation * kempe::degree);
  spec.region = kempe::Region::rectangle({t.x, t.y}, {t.width, t.height});
  spec.links.style.width = t.link_width;
  spec.links.style.pin_diameter = t.pin;
  spec.links.layers = t.layers;
  spec.limits.clearance = t.clearance;
  spec.limits.transmission = t.transmission * kempe::degree;
  if (t.has_area) spec.pole.place = kempe::Region::rectangle({-10, -10}, {20, 20});
  if (t.has_obstacle)
    spec.obstacles.push_back({.shape = kempe::Region::rectangle({20, -160}, {40, 20}).polygons.front(),
                              .lowest_layer = 1,
                              .highest_layer = 8,
                              .name = "vice"});
  if (t.is_steep) spec.objective.objective = kempe::Objective::transmission;
  return spec;
}

}  // namespace

int main() {
  kempe::Options options;
  options.largest_sheets = false;
  options.diagnose = false;
  for (Task task{}; std::cin >> task;) {
    const kempe::Outcome outcome = kempe::design(spec_of(task), options);
    const std::string text = outcome ? kempe::verified_json(*outcome) : outcome.reason();
    std::cout << text.size() << '\n' << text;
  }
}
