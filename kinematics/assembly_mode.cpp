#include "kinematics/assembly_mode.hpp"

#include <cmath>

#include "kinematics/slack.hpp"

namespace kempe {
namespace {

/// arg s brought into [0, pi); exactly 0 for straight plates.
double dead_point_opening(Complex shape) {
  double angle = std::arg(shape);
  if (angle < 0) angle += pi;
  return angle < slack::straight_plates || pi - angle < slack::straight_plates ? 0 : angle;
}

}  // namespace

bool is_straight(Complex shape) { return dead_point_opening(shape) == 0; }

std::vector<AssemblyMode> assembly_modes(Complex shape) {
  const double dead = dead_point_opening(shape);
  const bool straight = dead == 0;
  const Side plate = straight ? Side::on_line : side_of(shape.imag());
  const LoopSides below{Side::right, opposite(plate), plate}, above{Side::left, opposite(plate), plate};
  if (straight) return {{0, {-pi, 0}, below}, {1, {0, pi}, above}};
  return {{0, {-pi, dead - pi}, below},
          {1, {dead - pi, 0}, below},
          {2, {0, dead}, above},
          {3, {dead, pi}, above}};
}

}  // namespace kempe
