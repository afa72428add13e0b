#pragma once
// Lengths that the workshop dictates: multiples of a grid, or from a list of stock lengths.
//
// The lengths that are measured between holes on one line are VA = BC, VB = AC, AX = VB/|s| and BY = |s| VA; CX and CY
// follow from the plates' angle. All four lie on the grid without touching k if |s| = n/m is rational: then VA must be a
// multiple of m, VB of n grid steps. Else the ratio BY/VA = AC/AX is the fraction next to |s| for which a design exists,
// the angle of the plates stays, and k is off by a stated error: the copy is still an exact similarity, only of a
// slightly different scale.

#include <vector>

#include "specs/spec.hpp"

namespace kempe {

/// Lengths that VA and VB may have so that BY = ratio VA and AX = VB / ratio are workshop lengths too, ascending, mm.
struct WorkshopLengths {
  double ratio = 1;  ///< |s| that they give
  std::vector<double> VA{}, VB{};
};
/// For the exact |s| if there are any, else empty lists.
WorkshopLengths workshop_lengths(const WorkshopSpec& workshop, double scale_of_shape, double longest);
/// The other ratios that the workshop's lengths allow, the nearest to `scale_of_shape` first, at most `count`.
std::vector<WorkshopLengths> nearest_workshop_lengths(const WorkshopSpec& workshop, double scale_of_shape,
                                                      double longest, int count);

}  // namespace kempe
