#pragma once
// Stock lengths that keep a ratio: multiples of a grid, or from a list.
//
// The lengths that are measured between holes on one line are VA = BC, VB = AC, AX = VB/|s| and BY = |s| VA; CX and CY
// follow from the plates' angle. All four lie on the grid without touching k if |s| = n/m is rational: then VA must be a
// multiple of m, VB of n grid steps. Else the ratio BY/VA = AC/AX is the fraction next to |s| for which a design exists,
// the angle of the plates stays, and k is off by a stated error: the copy is still an exact similarity, only of a
// slightly different scale.

#include <vector>

#include "geometry/point.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// Lengths that VA and VB may have so that BY = ratio VA and AX = VB / ratio are stock lengths too and every locked length is
/// kept, ascending, mm.
struct RatioLengths {
  double ratio = 1;  ///< |s| that they give
  std::vector<double> VA{}, VB{};
};
/// For a linkage of this shape s if there are any, else an empty list.
RatioLengths stock_lengths_for(const StockLengths& stock_lengths, Complex shape, double longest);
/// The other ratios that the stock lengths allow for plates of this angle, the nearest to |s| first, at most `count`.
std::vector<RatioLengths> nearest_stock_lengths(const StockLengths& stock_lengths, Complex shape,
                                                double longest, int count);

}  // namespace kempe
