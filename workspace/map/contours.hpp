#pragma once
// A quantity over an annulus of the tracer's plane as contour polygons.

#include <functional>
#include <vector>

#include "workspace/reach.hpp"

namespace kempe {

/// The places where a quantity is at least `level`.
struct ContourBand {
  double level;
  Region area;
};

/// Samples a grid of bearings and distances over an annulus.
struct ContourGrid {
  int bearings = 180;  ///< >= 3
  int distances = 40;  ///< >= 1 steps between the inner and the outer circle
};

/// For each level the part of the annulus where `quantity` >= level, by marching squares over the grid: exact
/// at grid points, linear between them (not certified). `quantity` takes a place in the table's frame, mm; a
/// value that is not finite counts as below every level.
std::vector<ContourBand> contours(const Annulus& annulus, const std::function<double(const Point&)>& quantity,
                                  const std::vector<double>& levels, const ContourGrid& grid = {});

/// Where the transmission angle is at least each level (rad): closed form, annuli with true arcs.
struct TransmissionBand {
  double level;
  ArcRegion area;
};
std::vector<TransmissionBand> transmission_contours(const CopyingLinkage& linkage,
                                                    const std::vector<double>& levels);

}  // namespace kempe
