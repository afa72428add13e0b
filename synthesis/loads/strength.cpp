#include "synthesis/loads/strength.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/assembly_mode.hpp"

namespace kempe {
namespace {

/// What a joint's hole leaves of a link.
struct NetSection {
  NetSection(const LinkStyle& style, double hole)
      : area(style.thickness * (style.width - hole)),
        modulus(style.thickness * (std::pow(style.width, 3) - std::pow(hole, 3)) / (6 * style.width)) {}
  double area, modulus;  // mm^2; mm^3 in bending
};

double stress_of(const ArmForce& force, double length, const NetSection& net) {
  const Complex bending = length / net.modulus * force.across, pull = force.along / net.area;
  return std::max(std::abs(bending + pull), std::abs(bending - pull));
}

double stress_of_plate(const std::array<PlateArm, 2>& arms, double length, const ArmForce& corner,
                       const ArmForce& C, const ArmForce& third, const NetSection& net) {
  double largest = 0;
  for (const PlateArm& arm : arms) {
    const ArmForce& force =
        arm.end == PlateArm::End::corner ? corner : (arm.end == PlateArm::End::C ? C : third);
    largest = std::max(largest, stress_of(force, length * arm.length, net));
  }
  return largest;
}

}  // namespace

double LinkStresses::largest() const { return std::max({VA, VB, ACX, BCY}); }

LinkStresses link_stresses(Complex k, Grounding grounding, const LinkStyle& style, double hole,
                           const BarLengths& lengths, double opening) {
  if (!(hole < style.width)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const Complex s = shape_of(k, grounding);
  const LinkForces forces = link_forces(s, opening);
  const NetSection net(style, hole);
  const double factor = std::abs(pen_factor(k, grounding));
  return {.VA = factor * std::abs(forces.bar_VA) / net.area,
          .VB = factor * std::abs(forces.bar_VB) / net.area,
          .ACX = factor * stress_of_plate(plate_arms(1.0 / s, is_straight(s)), lengths.VB, forces.A,
                                          forces.C_of_ACX, forces.X, net),
          .BCY = factor * stress_of_plate(plate_arms(s, is_straight(s)), lengths.VA, forces.B,
                                          forces.C_of_BCY, forces.Y, net)};
}

double buckling_load(const LinkStyle& style, const Material& material, double length) {
  const double thin = std::min(style.width, style.thickness), wide = std::max(style.width, style.thickness);
  return pi * pi * material.E * wide * std::pow(thin, 3) / 12 / (length * length);
}

}  // namespace kempe
