#pragma once
// Chebyshev's precision points: where an approximate linkage is made exact so that its structural error
// ripples evenly.

#include <vector>

namespace kempe {

/// The n Chebyshev points of [lower, upper], from the upper end downward: x_j = a + h cos((2j-1) pi / 2n)
/// with a = (lower+upper)/2, h = (upper-lower)/2, j = 1..n. Unit: that of the interval. Empty for n < 1.
std::vector<double> chebyshev_points(double lower, double upper, int n);

}  // namespace kempe
