#include "synthesis/loads/pin_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "specs/hardware.hpp"
#include "synthesis/loads/steel.hpp"

namespace kempe {
namespace {

/// What h^3 / EI is divided by: both ends kept from tilting, or one.
constexpr double clamped_ends = 12, one_end_free = 3;

double compliance_of(double diameter, double height, double ends) {
  const double area = 0.25 * pi * diameter * diameter, inertia = pi * std::pow(diameter, 4) / 64;
  return std::pow(height, 3) / (ends * steel::E * inertia) + 10 * height / (9 * steel::G * area);
}

}  // namespace

double upright_pin(double diameter, double height) { return compliance_of(diameter, height, clamped_ends); }

PinCompliance pin_compliance(Grounding grounding, const LayerAssignment& layers, const LinkStyle& style,
                             const JointHardware& hardware) {
  const auto between = [&](Joint joint, Link one, Link other) {
    return upright_pin(pin_at(style, hardware, joint),
                       style.thickness * std::abs(layers[one] - layers[other]));
  };
  const Joint pole = roles_of(grounding).pole;
  const int highest = pole == Joint::V ? std::max(layers[Link::VA], layers[Link::VB]) : layers[Link::ACX];
  return {
      .A = between(Joint::A, Link::VA, Link::ACX),
      .B = between(Joint::B, Link::VB, Link::BCY),
      .C = between(Joint::C, Link::ACX, Link::BCY),
      .V = between(Joint::V, Link::VA, Link::VB),
      .pole = compliance_of(pin_at(style, hardware, pole), style.thickness * (highest - 0.5), one_end_free)};
}

}  // namespace kempe
