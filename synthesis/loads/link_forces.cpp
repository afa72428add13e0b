#include "synthesis/loads/link_forces.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

constexpr Complex left{0, 1};

template <class W>
W constant(Complex value) {
  return {value};
}

/// e^{i d}
OpeningJet turn_by(double opening) {
  const Complex e = std::polar(1.0, opening);
  return {e, left * e, -e};
}

OpeningJet cosine_of(double opening) { return {std::cos(opening), -std::sin(opening), -std::cos(opening)}; }

/// With e = e^{i d}, and cosine and cosecant of d.
template <class W>
LinkForcesOf<W> forces_from(Complex s, const W& e, const W& cosine, const W& cosecant) {
  const Complex side = left * (1.0 - s);
  const double length = std::abs(s);
  LinkForcesOf<W> forces;
  forces.bar_VA = side * (e * cosecant);
  forces.bar_VB = -side * cosecant;
  forces.A = {forces.bar_VA * cosine, -side * e};
  forces.C_of_ACX = {s * e - forces.bar_VA * cosine, left * e};
  forces.X = {length * e, length * left * e};
  forces.B = {forces.bar_VB * cosine, constant<W>(-side)};
  forces.C_of_BCY = {forces.bar_VA - constant<W>(s), constant<W>(-left * s)};
  forces.Y = {constant<W>(s / length), constant<W>(left * s / length)};
  forces.pin_C = {constant<W>(s) - forces.bar_VA, constant<W>(left * s)};
  return forces;
}

/// 1 / sin d
OpeningJet cosecant_of(double opening) {
  const double sine = std::sin(opening), cot = std::cos(opening) / sine;
  return {1 / sine, -cot / sine, (1 + 2 * cot * cot) / sine};
}

}  // namespace

OpeningJet operator*(Complex factor, const OpeningJet& jet) {
  return {factor * jet.value, factor * jet.first, factor * jet.second};
}

OpeningJet operator*(const OpeningJet& one, const OpeningJet& other) {
  return {one.value * other.value, one.first * other.value + one.value * other.first,
          one.second * other.value + 2.0 * one.first * other.first + one.value * other.second};
}

OpeningJet operator+(const OpeningJet& one, const OpeningJet& other) {
  return {one.value + other.value, one.first + other.first, one.second + other.second};
}

OpeningJet operator-(const OpeningJet& one, const OpeningJet& other) { return one + -1.0 * other; }

LinkForces link_forces(Complex s, double opening) {
  const double sine = std::sin(opening), cosine = std::cos(opening);
  return forces_from<Complex>(s, {cosine, sine}, cosine, 1 / sine);
}

LinkForceJets link_force_jets(Complex s, double opening) {
  return forces_from<OpeningJet>(s, turn_by(opening), cosine_of(opening), cosecant_of(opening));
}

Complex pen_factor(Complex k, Grounding grounding) {
  return pen_is_at_V(grounding) ? 1.0 / (shape_of(k, grounding) - 1.0) : Complex(1, 0);
}

ForceRange force_range(Complex x, Complex y) {
  const double sum = std::norm(x) + std::norm(y), difference = std::abs(x * x + y * y);
  return {std::sqrt(0.5 * (sum + difference)), std::sqrt(std::max(0.0, 0.5 * (sum - difference)))};
}

double PinForces::largest() const { return std::max({A, B, C, V, pole}); }

PinForces pin_forces(Complex k, Grounding grounding, double opening) {
  const LinkForces forces = link_forces(shape_of(k, grounding), opening);
  const double factor = std::abs(pen_factor(k, grounding));
  PinForces pins;
  pins.A = factor * std::abs(forces.bar_VA);
  pins.B = pins.V = factor * std::abs(forces.bar_VB);
  pins.C = factor * force_range(forces.pin_C[0], forces.pin_C[1]).most;
  pins.pole = std::abs(k - 1.0);
  return pins;
}

PinForces operator+(const PinForces& one, const PinForces& other) {
  return {one.A + other.A, one.B + other.B, one.C + other.C, one.V + other.V, one.pole + other.pole};
}

PinForces operator*(double times, const PinForces& forces) {
  return {times * forces.A, times * forces.B, times * forces.C, times * forces.V, times * forces.pole};
}

double hand_force(Complex k) { return std::abs(k); }

}  // namespace kempe
