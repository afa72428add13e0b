#pragma once
// Random linkages that stand on their post, and their links as section_forces.hpp takes them.

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <random>
#include <vector>

#include "synthesis/loads/sag.hpp"
#include "tests/random.hpp"
#include "tests/synthesis/loads/section_forces.hpp"
#include "workspace/contact/layer_demands.hpp"

namespace kempe::sag_case {

inline constexpr double gravity = 9.80665;

/// A linkage and its conditions.
struct SagCase {
  Complex k;
  Grounding grounding;
  SagConditions conditions;
  double VA, VB, opening;
};

inline SagCase random_case(std::mt19937_64& random) {
  using test::uniform;
  for (;;) {
    const double rotation =
        uniform(random, 0, 4) < 1 ? (uniform(random, 0, 1) < 0.5 ? 0 : pi) : uniform(random, -pi, pi);
    const Complex k = copy_ratio(std::exp(uniform(random, -1.5, 1.5)), rotation);
    if (std::abs(k - 1.0) < 0.1) continue;
    SagCase one{.k = k,
                .grounding = all_groundings[static_cast<std::size_t>(uniform(random, 0, 3))],
                .conditions = {},
                .VA = 0,
                .VB = 0,
                .opening = 0};
    const auto modes = assembly_modes(shape_of(k, one.grounding));
    const OpeningInterval openings =
        modes[static_cast<std::size_t>(uniform(random, 0, static_cast<double>(modes.size())))].openings;
    one.opening = openings.lower + uniform(random, 0.1, 0.9) * openings.width();
    one.VA = uniform(random, 40, 400);
    one.VB = uniform(random, 40, 400);
    const auto layers = layer_assignments(3);
    one.conditions = {
        .style = {.width = uniform(random, 8, 30),
                  .pin_diameter = uniform(random, 3, 8),
                  .thickness = uniform(random, 2, 8)},
        .layers = layers[static_cast<std::size_t>(uniform(random, 0, static_cast<double>(layers.size())))],
        .E = uniform(random, 2e3, 2e5),
        .G = uniform(random, 6e2, 8e4),
        .density = uniform(random, 500, 8000),
        .pen_mass = uniform(random, 0, 3),
        .tracer_mass = uniform(random, 0, 1),
        .tilt = uniform(random, 0, 1.5),
        .play = uniform(random, 0, 0.1),
        .grip = uniform(random, 2, 20)};
    return one;
  }
}

enum { V, A, B, C, X, Y };

/// The arms of a plate with its corner at 0, C at 1 and its third joint at `third`, by their joints.
inline std::vector<section_forces::Bar> bars_of_plate(int corner, int end, Complex third) {
  if (std::abs(third.imag()) > 1e-9) return {{corner, C}, {corner, end}};
  if (third.real() < 0) return {{end, corner}, {corner, C}};
  if (third.real() < 1) return {{corner, end}, {end, C}};
  return {{corner, C}, {C, end}};
}

/// Its links under their weights out of the plane, built here from the drawing of docs/notation.md.
inline section_forces::Structure structure_of(const SagCase& one) {
  const Complex s = one.grounding == Grounding::pole     ? one.k
                    : one.grounding == Grounding::tracer ? 1.0 - one.k
                                                         : 1.0 - 1.0 / one.k;
  const SagConditions& of = one.conditions;
  const double w = of.style.width, t = of.style.thickness, g = gravity * std::cos(of.tilt);
  const Complex p = one.VA, q = std::polar(one.VB, one.opening);
  section_forces::Structure it;
  it.places = {0, p, q, p + q, p + q / s, q + s * p};
  const double each_mm = of.density * 1e-9 * w * t * g, cap = of.density * 1e-9 * t * g * pi * w * w / 8;
  it.links = {{{V, A}, {{V, A}}, each_mm},
              {{V, B}, {{V, B}}, each_mm},
              {{A, C, X}, bars_of_plate(A, X, 1.0 / s), each_mm},
              {{B, C, Y}, bars_of_plate(B, Y, s), each_mm}};
  it.loads.assign(6, 0);
  const auto caps = [&](std::initializer_list<int> joints) {
    for (const int joint : joints) it.loads[static_cast<std::size_t>(joint)] += cap;
  };
  caps({V, A, V, B});
  for (const std::size_t plate : {2U, 3U}) {
    const auto& bars = it.links[plate].bars;
    caps({bars[0].from == bars[1].from ? bars[0].to : bars[0].from, bars[1].to});
  }
  const int pen = one.grounding == Grounding::pen ? V : Y;
  const int tracer = one.grounding == Grounding::pole ? X : one.grounding == Grounding::tracer ? V : Y;
  it.loads[static_cast<std::size_t>(pen)] += of.pen_mass * g;
  it.loads[static_cast<std::size_t>(tracer)] += of.tracer_mass * g;
  const double d = of.style.pin_diameter, pin = 200e3 * pi * d * d * d * d / 64;
  const auto& layer = of.layers.of;
  const auto between = [&](std::size_t a, std::size_t b) {
    return pin / (t * std::abs(layer[a] - layer[b]));
  };
  const auto post = [&](std::size_t a) { return pin / (t * (layer[a] - 0.5)); };
  // One post under both bars: the upper one's moment goes down it through the lower one's height.
  if (one.grounding == Grounding::pole && layer[0] < layer[1])
    it.joins = {{V, 0, -1, post(0)}, {V, 1, 0, between(0, 1)}};
  else if (one.grounding == Grounding::pole)
    it.joins = {{V, 1, -1, post(1)}, {V, 0, 1, between(0, 1)}};
  else
    it.joins = {{X, 2, -1, post(2)}, {V, 0, 1, between(0, 1)}};
  it.joins.insert(it.joins.end(),
                  {{A, 0, 2, between(0, 2)}, {B, 1, 3, between(1, 3)}, {C, 2, 3, between(2, 3)}});
  const double E = of.E;
  it.bending = E * w * t * t * t / 12;
  it.torsion = of.G * torsion_constant(w, t);
  return it;
}

}  // namespace kempe::sag_case
