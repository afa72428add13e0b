#pragma once
// The top of a function that rises and then falls.

namespace kempe {

/// The place between `lower` and `upper` where `height(x)` is largest, by golden section: every step leaves 0.618 of the
/// interval. Where the function has several tops, one of them. Source: Kiefer, Proc. Amer. Math. Soc. 4 (1953).
template <typename Height>
double top_by_golden_section(const Height& height, double lower, double upper, int steps) {
  constexpr double golden = 0.6180339887498949;
  double left = upper - golden * (upper - lower), right = lower + golden * (upper - lower);
  double at_left = height(left), at_right = height(right);
  for (int i = 0; i < steps; ++i) {
    if (at_left > at_right) {
      upper = right, right = left, at_right = at_left;
      left = upper - golden * (upper - lower), at_left = height(left);
    } else {
      lower = left, left = right, at_left = at_right;
      right = lower + golden * (upper - lower), at_right = height(right);
    }
  }
  return 0.5 * (lower + upper);
}

}  // namespace kempe
