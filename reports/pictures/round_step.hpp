#pragma once
// Steps that people count in.

#include <cmath>
#include <vector>

namespace kempe {

/// The least of 1, 2, 5 times a power of ten that is not below `wanted` (> 0) but for rounding.
inline double round_step(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (wanted <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

/// The decimals that tell multiples of a step apart.
inline int decimals_of_step(double step) {
  return step > 0 ? static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) : 0;
}

/// The multiples of `step` from `lower` to `upper`; a billionth of a step outside still counts. Few are expected; none where
/// there is no step to count in, as for a range of no width.
inline std::vector<double> multiples_within(double step, double lower, double upper) {
  std::vector<double> multiples;
  if (!(step > 0) || !std::isfinite(lower / step) || !std::isfinite(upper / step)) return multiples;
  const auto last = std::llround(std::floor(upper / step + 1e-9));
  for (auto i = std::llround(std::ceil(lower / step - 1e-9)); i <= last; ++i)
    multiples.push_back(static_cast<double>(i) * step);
  return multiples;
}

}  // namespace kempe
