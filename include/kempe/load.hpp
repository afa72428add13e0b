#pragma once
// The force at the pen, the masses that pen and tracer carry, and what carries the instrument's weight.

#include <algorithm>
#include <optional>
#include <vector>

#include "kempe/body.hpp"

namespace kempe {

/// The load of a copying linkage: a force at the pen in any direction in the plane, while pole and tracer are held; the masses that
/// its points carry; and what holds all this up: the pole's post and the points that rest on the table. Needs a material (Spec::material).
struct Load {
  double pen_force = 0;          ///< N, > 0
  std::vector<Carrier> rests{};  ///< each once; empty: only the pole's post carries the weight
  double pen_mass = 0;           ///< kg, >= 0, carried by the pen: a router
  double tracer_mass = 0;        ///< kg, >= 0, carried by the tracer
  double tilt = 0;               ///< rad, 0 to pi/2, of the table from level about its x axis, y uphill
  std::optional<double>
      grip{};              ///< mm, > 0: of a pin in the link that turns on it; absent: the links' thickness
  double friction = 0.15;  ///< >= 0, coefficient of friction in the pins
  /// True if the table carries that point.
  bool rests_at(Carrier point) const { return std::find(rests.begin(), rests.end(), point) != rests.end(); }
  bool operator==(const Load&) const = default;
};

}  // namespace kempe
