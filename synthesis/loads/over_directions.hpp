#pragma once
// The most of a figure over all directions of a force.

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/point.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {

/// In how many parts of a turn a value is looked for: many where it has a kink wherever another set of points bears, and a top for the
/// tracer and one for the pen; a few where it is the largest of figures that each have two tops.
inline constexpr int parts_with_contacts = 16, parts_without = 4;

/// The most of what value(direction, rad) is over all directions, never below 0; NaN if it is NaN or infinite in one that is looked at.
template <class Value>
double most_over_directions(const Value& value, int parts = parts_with_contacts) {
  constexpr int steps = 40;
  const auto known = [&](double direction) {
    const double here = value(direction);
    return std::isfinite(here) ? here : infinity;
  };
  double most = 0;
  for (int i = 0; i < parts; ++i)
    most = std::max(most, known(top_over({2 * pi * i / parts, 2 * pi * (i + 1) / parts}, known, steps)));
  return std::isfinite(most) ? most : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace kempe
