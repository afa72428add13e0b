#pragma once
// A sequence that scatters starts evenly.

#include <cstddef>

namespace kempe {

/// The n-th number of van der Corput's sequence in a base, in [0, 1): the digits of n behind the point, backwards (Halton, 1960, uses one prime
/// base a dimension).
inline double van_der_corput(std::size_t n, unsigned base) {
  double result = 0, digit = 1;
  for (; n > 0; n /= base) {
    digit /= base;
    result += digit * static_cast<double>(n % base);
  }
  return result;
}

}  // namespace kempe
