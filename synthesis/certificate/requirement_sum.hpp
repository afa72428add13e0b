#pragma once
// Weighted sums of what every design keeps: its reach, its posts apart, its size at most the bound. All are quadratic in a, b
// and the pole's place, so a sum's largest value over a box is known; where it is negative the box holds no design. The
// weights that make it so are about those of the Karush-Kuhn-Tucker conditions.

#include <optional>
#include <vector>

#include "synthesis/certificate/design_cell.hpp"
#include "synthesis/certificate/region_places.hpp"

namespace kempe::certificate {

/// What the sums of one root know beside a cell.
struct SumTask {
  const Root* root = nullptr;
  const RegionPlaces* places = nullptr;
  std::optional<double> size_bound;  ///< mm; absent: the size is not bounded
  double least_radius = 0;           ///< mm: nearer to the pole the tracer's post would touch another
};

/// The best sum found for a cell.
struct BestSum {
  SumLeaf leaf;
  bool refutes = false;       ///< negative all over the cell, by more than rounding can change
  bool refutes_soon = false;  ///< so negative in the middle that cells a few times smaller will be refuted
  std::array<double, 4> share{};  ///< of each variable in what the cell's width adds to it
};
BestSum best_sum(const SumTask& task, const DesignCell& cell);

}  // namespace kempe::certificate
