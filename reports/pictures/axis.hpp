#pragma once
// One side of a chart: values, and where they stand in the picture.

#include <vector>

#include "reports/pictures/round_step.hpp"

namespace kempe {

/// Values from `lower` to `upper` stand between `from` and `to`, in the picture's units; `step` lies between two ticks.
struct Axis {
  double lower, upper, step, from, to;

  double at(double value) const { return from + (value - lower) / (upper - lower) * (to - from); }
  std::vector<double> ticks() const { return multiples_within(step, lower, upper); }
};

/// The axis of the values themselves, with about so many ticks.
inline Axis axis_over(double lower, double upper, int ticks, double from, double to) {
  return {lower, upper, round_step((upper - lower) / ticks), from, to};
}

}  // namespace kempe
