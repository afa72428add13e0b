// Where a plagiograph of given lengths can go beside a vice and a lamp's foot, and what its pen draws there.

#include <iostream>
#include <kempe/kempe.hpp>
#include <variant>

namespace {

/// A circle that the tracer shall follow, mm.
kempe::Polyline circle(const kempe::Point& centre, double radius) {
  kempe::Polyline line = kempe::Region::circle(centre, radius).polygons.front().outer;
  line.push_back(line.front());
  return line;
}

kempe::Spec task() {
  kempe::Spec spec;
  spec.copy = kempe::Copy::of(1.4, 90 * kempe::degree);
  spec.mechanism = kempe::MechanismSpec{
      .grounding = kempe::Grounding::pole, .VA = 50 * kempe::mm, .VB = 35 * kempe::mm, .assembly_mode = 3};
  spec.limits.transmission = 15 * kempe::degree;
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;
  spec.obstacles.push_back({.shape = kempe::Region::rectangle({20, -60}, {40, 20}).polygons.front(),
                            .lowest_layer = 1,
                            .highest_layer = 8,
                            .name = "vice"});
  spec.obstacles.push_back({.shape = kempe::Region::circle({-60, 40}, 12).polygons.front(),
                            .lowest_layer = 1,
                            .highest_layer = 8,
                            .name = "foot of the lamp"});
  return spec;
}

}  // namespace

int main() {
  const kempe::Outcome outcome = kempe::map(task());
  if (!outcome) {
    std::cerr << outcome.reason() << '\n';
    return 1;
  }
  const kempe::Map& map = outcome->map();
  std::cout << "free " << map.collision_free_area() << " mm2 of " << map.reachable_area()
            << " mm2 within reach\n";
  for (const kempe::Loss& loss : map.losses()) {
    std::cout << "lost " << loss.area << " mm2: " << loss.cause;
    for (const std::string& part : loss.parts) std::cout << ", " << part;
    std::cout << '\n';
  }
  std::cout << "(70, 0): " << map.at({70, 0}).sentence << '\n';

  const auto traced = kempe::trace(*outcome, {circle({66, 0}, 4)});
  if (const auto* copy = std::get_if<kempe::CopiedDrawing>(&traced))
    std::cout << "drawn " << copy->drawn_length << " mm, missing " << copy->missing_length << " mm\n";
}
