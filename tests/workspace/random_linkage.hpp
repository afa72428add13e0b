#pragma once
// Seeded random linkages and numbers for the laws of this room; the same on every machine.

#include <cmath>
#include <cstdint>
#include <random>

#include "kinematics/copying_linkage.hpp"
#include "tests/random.hpp"
#include "workspace/parts.hpp"

namespace kempe::test {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double lower, double upper) { return test::uniform(engine_, lower, upper); }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

 private:
  std::mt19937_64 engine_;
};

/// Any grounding, ratio, assembly mode; every fifth one with straight plates. Lengths 30..120 mm.
inline CopyingLinkage random_linkage(Dice& dice) {
  while (true) {
    const bool straight = dice.below(5) == 0;
    const double rotation = straight ? pi * dice.below(2) : dice.between(-pi, pi);
    const Complex k = copy_ratio(std::exp(dice.between(-1.2, 1.2)), rotation);
    if (std::abs(k - 1.0) < 0.1) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(dice.below(3))];
    const auto count = static_cast<int>(assembly_modes(shape_of(k, grounding)).size());
    const Point pole(dice.between(-50, 50), dice.between(-50, 50));
    return *CopyingLinkage::make(k, grounding, dice.between(30, 120), dice.between(30, 120),
                                 dice.below(count), pole);
  }
}

inline LayerAssignment random_layers(Dice& dice) {
  const auto all = layer_assignments(2 + dice.below(3));
  return all[static_cast<std::size_t>(dice.below(static_cast<int>(all.size())))];
}

inline LinkStyle random_style(Dice& dice) {
  const double width = dice.between(4, 14);
  return {width, width * dice.between(0.2, 1), 4,
          dice.below(2) == 0 ? PlateStyle::bent : PlateStyle::triangle};
}

}  // namespace kempe::test
