#pragma once
// Random numbers from a seed, the same on every machine: the distributions of the standard library are not.

#include <cmath>
#include <cstdint>
#include <random>

#include "geometry/point.hpp"

namespace kempe {

/// A stream of random numbers; the seed alone decides it. Two draws never stand in one argument list, where the compiler
/// chooses which comes first.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : bits_(seed) {}

  /// Evenly spread over [0, 1), in steps of 2^-53.
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Evenly spread over [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * share(); }
  /// Evenly spread over [-largest, largest).
  double symmetric(double largest = 1) { return largest * (2 * share() - 1); }
  /// Normal with mean 0 and standard deviation 1: G. E. P. Box, M. E. Muller, Ann. Math. Statist. 29 (1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - share()));
    return radius * std::cos(2 * pi * share());
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace kempe
