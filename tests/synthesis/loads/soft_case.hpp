#pragma once
// Random designs as far as the error budget reads them, over a small region, and what is wrong with instruments that are made by them.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "tests/synthesis/loads/soft_instrument.hpp"
#include "workspace/reach.hpp"

namespace kempe::soft_instrument {

using wrong_instruments::Chance;
using wrong_instruments::Flaws;

inline const Material soft_materials[] = {
    {"steel", 200e3, 7850, 235}, {"aluminium", 70e3, 2700, 150}, {"PLA", 3e3, 1240, 26}};

/// A design as far as the budget reads it, over a square, and the middle of that square.
struct SoftCase {
  Design design;
  Point middle;
  double half;  ///< mm, of the square's side

  Stuff stuff() const {
    return {design.style, design.material->E,
            pin_compliance(design.linkage.grounding(), design.layers, design.style, design.hardware)};
  }
};

/// Ratios, groundings, sections, layers and materials of every kind, one in four straight; well away from dead and change points. The force is such that
/// the links alone give way by a tenth of a millimetre or so.
inline SoftCase soft_case(Chance& chance) {
  for (;;) {
    const double rotation =
        chance.one_in(4) ? pi * static_cast<double>(chance.below(2)) : chance.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.2, 1.2)), rotation);
    const Grounding grounding = all_groundings[chance.below(3)];
    const Complex s = shape_of(k, grounding);
    // A plate that is nearly flat but not quite is toleranced by lengths that say little (docs/tolerance.md).
    const double flatness = std::abs(s.imag()) / std::max({1.0, std::abs(s), std::abs(s - 1.0)});
    if (std::abs(k - 1.0) < 0.3 || (!is_straight(s) && flatness < 0.3)) continue;
    const auto modes = assembly_modes(s);
    const auto& mode = modes[chance.below(modes.size())];
    if (mode.openings.width() < radians(80)) continue;
    const auto linkage =
        CopyingLinkage::make(k, grounding, chance.uniform(90, 250), chance.uniform(90, 250), mode.number,
                             {chance.uniform(-50, 50), chance.uniform(-50, 50)});
    const double opening =
        chance.uniform(mode.openings.lower + radians(35), mode.openings.upper - radians(35));
    const Point middle = linkage->tracer_at(opening, chance.uniform(-pi, pi));
    const double half = 0.04 * (middle - linkage->pole()).norm();
    if (!openings_over(*linkage, wrong_instruments::square_about(middle, half))) continue;
    SoftCase result{{.linkage = *linkage}, middle, half};
    Design& design = result.design;
    design.scale = std::abs(k);
    design.rotation = std::arg(k);
    design.region = wrong_instruments::square_about(middle, half);
    design.style.width = chance.uniform(12, 25);
    design.style.thickness = chance.uniform(3, 8);
    design.style.pin_diameter = chance.uniform(4, 8);
    const auto assignments = layer_assignments(2 + static_cast<int>(chance.below(2)));
    design.layers = assignments[chance.below(assignments.size())];
    design.material = soft_materials[chance.below(3)];
    design.tolerance = Tolerance{chance.uniform(0.01, 0.05), chance.uniform(0.01, 0.05)};
    const double for_each_newton = LoadErrorProfile(k, grounding, design.style, *design.material, 1)
                                       .at({linkage->VA(), linkage->VB()}, opening)
                                       .worst;
    design.load = Load{.pen_force = chance.uniform(0.03, 0.2) / for_each_newton};
    return result;
  }
}

inline Point drawn_pen(const CopyingLinkage& linkage, const Point& tracer) {
  return linkage.pole() + as_point(linkage.k() * as_complex(Point(tracer - linkage.pole())));
}

/// The pen's displacement by a unit of each source, by differences of instruments that do not give way.
struct SeenSensitivities {
  std::array<Point, 8> length;
  std::array<std::array<Point, 2>, 5> pin;
};
inline std::optional<SeenSensitivities> seen_sensitivities(const SoftCase& of, const Point& tracer) {
  constexpr double step = 1e-3;
  const auto moved = [&](const auto& set) -> std::optional<Point> {
    std::array<Point, 2> pens;
    for (int side = 0; side < 2; ++side) {
      Flaws flaws;
      set(flaws, side == 0 ? -step : step);
      const auto pen = SoftInstrument(of.design.linkage, of.stuff(), flaws, {0, false}).pen(tracer, {0, 0});
      if (!pen) return std::nullopt;
      pens[static_cast<std::size_t>(side)] = *pen;
    }
    return Point((pens[1] - pens[0]) / (2 * step));
  };
  SeenSensitivities seen;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto way = moved([&](Flaws& flaws, double size) { flaws.length[i] = size; });
    if (!way) return std::nullopt;
    seen.length[i] = *way;
  }
  for (std::size_t i = 0; i < 5; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const auto way = moved([&](Flaws& flaws, double size) { flaws.pin[i][axis] = size; });
      if (!way) return std::nullopt;
      seen.pin[i][static_cast<std::size_t>(axis)] = *way;
    }
  return seen;
}

/// Lengths and play that move the pen farthest along `way`.
inline Flaws worst_flaws(const SeenSensitivities& seen, const Tolerance& tolerance, const Point& way) {
  Flaws flaws;
  for (std::size_t i = 0; i < 8; ++i)
    flaws.length[i] = std::copysign(tolerance.length, seen.length[i].dot(way));
  for (std::size_t i = 0; i < 5; ++i) {
    const Point slope{seen.pin[i][0].dot(way), seen.pin[i][1].dot(way)};
    if (slope.norm() > 0) flaws.pin[i] = 0.5 * tolerance.play / slope.norm() * slope;
  }
  return flaws;
}

}  // namespace kempe::soft_instrument
