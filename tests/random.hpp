#pragma once
// Random numbers for tests, the same on every machine: the distributions of the standard library are not.

#include <random>

namespace kempe::test {

/// Evenly spread over [0, 1), in steps of 2^-53.
inline double share(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Evenly spread over [lower, upper).
inline double uniform(std::mt19937_64& random, double lower, double upper) {
  return lower + (upper - lower) * share(random);
}

}  // namespace kempe::test
