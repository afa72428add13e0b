#pragma once
// The quotient of complex numbers as libgcc rounds it. The C++ library of WebAssembly scales by a power of two and divides by
// |w|^2, whose last digit is another; with this, both give the same bits.

#include <cmath>
#include <limits>

namespace kempe {

struct Quotient {
  double re, im;
};

/// (a + b i) / (c + d i), finite and c + d i not zero, by Smith's ratio of the smaller to the larger part of the denominator.
/// Baudin and Smith, A robust complex division in Scilab (2012): another order of operations where the ratio underflows, and
/// scaling where a part is near the ends of the doubles' range.
inline Quotient quotient_as_libgcc(double a, double b, double c, double d) {
  using Limits = std::numeric_limits<double>;
  constexpr double large = Limits::max() / 2, small = Limits::min(), growth = 1 / Limits::epsilon();
  constexpr double still_grows = large * Limits::epsilon();
  const auto scale = [&](double factor) { a *= factor, b *= factor, c *= factor, d *= factor; };
  const bool steep = std::fabs(c) < std::fabs(d);
  const double largest = steep ? std::fabs(d) : std::fabs(c);
  if (largest >= large) scale(0.5);
  if (largest < Limits::epsilon()) {
    scale(growth);
  } else if ((std::fabs(a) < small && std::fabs(b) < still_grows && largest < still_grows) ||
             (std::fabs(b) < small && std::fabs(a) < still_grows && largest < still_grows)) {
    scale(growth);
  }
  if (steep) {
    const double ratio = c / d, denominator = c * ratio + d;
    if (std::fabs(ratio) > small) return {(a * ratio + b) / denominator, (b * ratio - a) / denominator};
    return {(c * (a / d) + b) / denominator, (c * (b / d) - a) / denominator};
  }
  const double ratio = d / c, denominator = d * ratio + c;
  if (std::fabs(ratio) > small) return {(b * ratio + a) / denominator, (b - a * ratio) / denominator};
  return {(d * (b / c) + a) / denominator, (b - d * (a / c)) / denominator};
}

}  // namespace kempe
