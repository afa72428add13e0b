#include "synthesis/loads/strength.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/assembly_mode.hpp"

namespace kempe {
namespace {

double stress_of(const ArmForce& force, double length, const SectionModuli& net) {
  const Complex bending = length / net.in_plane * force.across, pull = force.along / net.area;
  return std::max(std::abs(bending + pull), std::abs(bending - pull));
}

double stress_of_plate(const std::array<PlateArm, 2>& arms, double length, const ArmForce& corner,
                       const ArmForce& C, const ArmForce& third, const SectionModuli& net) {
  double largest = 0;
  for (const PlateArm& arm : arms) {
    const ArmForce& force =
        arm.end == PlateArm::End::corner ? corner : (arm.end == PlateArm::End::C ? C : third);
    largest = std::max(largest, stress_of(force, length * arm.length, net));
  }
  return largest;
}

}  // namespace

double torsion_modulus(double width, double thickness) {
  const double wide = std::max(width, thickness), thin = std::min(width, thickness), ratio = thin / wide;
  const double share = 1 + ratio * (0.6095 + ratio * (0.8865 + ratio * (-1.8023 + 0.91 * ratio)));
  return wide * thin * thin / (3 * share);
}

SectionModuli section_moduli(const LinkStyle& style, double hole) {
  const double w = style.width, t = style.thickness, left = w - hole;
  return {.area = t * left,
          .in_plane = t * (std::pow(w, 3) - std::pow(hole, 3)) / (6 * w),
          .out_of_plane = left * t * t / 6,
          .twist = torsion_modulus(left, t)};
}

double largest_stress(const PieceForces& forces, const SectionModuli& at_ends, const SectionModuli& between) {
  const auto with_twist = [&](double stress, const SectionModuli& moduli) {
    return std::hypot(stress, std::sqrt(3.0) * forces.twist / moduli.twist);
  };
  double corner = 0;
  for (const std::size_t end : {0U, 1U}) {
    const double pull = end == 0 ? forces.pull : forces.pull + forces.pull_growth;
    corner = std::max(
        corner, std::abs(pull) / at_ends.area + (std::abs(forces.in_plane[end]) / at_ends.in_plane +
                                                 std::abs(forces.out_of_plane[end]) / at_ends.out_of_plane));
  }
  const double largest = with_twist(corner, at_ends);
  if (forces.own_weight == 0 && forces.own_weight_in_plane == 0) return largest;
  // Where a corner's stress along the piece, a parabola, is at its top.
  double inside = 0;
  for (const double side : {-1.0, 1.0})
    for (const double face : {-1.0, 1.0}) {
      const auto bending = [&](std::size_t end) {
        return side * forces.in_plane[end] / between.in_plane +
               face * forces.out_of_plane[end] / between.out_of_plane;
      };
      const double bow = face * forces.own_weight / between.out_of_plane +
                         side * forces.own_weight_in_plane / between.in_plane,
                   rise = bending(1) - bending(0) + forces.pull_growth / between.area,
                   x = 0.5 * (rise + bow) / bow;
      if (x > 0 && x < 1)
        inside = std::max(inside,
                          std::abs(forces.pull / between.area + bending(0) + x * rise + x * (1 - x) * bow));
    }
  return std::max(largest, with_twist(inside, between));
}

double LinkStresses::largest() const { return std::max({VA, VB, ACX, BCY}); }

LinkStresses operator+(const LinkStresses& one, const LinkStresses& other) {
  return {one.VA + other.VA, one.VB + other.VB, one.ACX + other.ACX, one.BCY + other.BCY};
}

LinkStresses operator*(double times, const LinkStresses& stresses) {
  return {times * stresses.VA, times * stresses.VB, times * stresses.ACX, times * stresses.BCY};
}

LinkStresses link_stresses(Complex k, Grounding grounding, const LinkStyle& style, double hole,
                           const BarLengths& lengths, double opening) {
  if (!(hole < style.width)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const Complex s = shape_of(k, grounding);
  const LinkForces forces = link_forces(s, opening);
  const SectionModuli net = section_moduli(style, hole);
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
