#pragma once
// The plane about the pole in rings and bins of the angle, and which of them are filled.

#include <array>
#include <cstddef>
#include <vector>

#include "workspace/sweep/bearings.hpp"

namespace kempe::sweep {

/// Filled by angles ring by ring; a difference array a ring.
class PolarBins {
 public:
  /// `rings` up to `radius` (mm), `bins` of a whole turn.
  PolarBins(int rings, int bins, double radius);

  int rings() const { return rings_; }
  int bins() const { return bins_; }
  /// Width of a ring, mm.
  double step() const { return step_; }
  /// Distance of a ring's middle from the pole, mm.
  double middle(int ring) const { return (ring + 0.5) * step_; }

  /// Fills all bins that hold some of the angles.
  void fill(int ring, const Bearings& angles);
  /// Runs of filled bins of a ring, [from, to).
  std::vector<std::array<int, 2>> runs(int ring) const;
  /// Of all that is filled, mm^2.
  double area() const;

 private:
  std::size_t at(int ring, int bin) const;
  void add(int ring, int from, int to);

  int rings_, bins_;
  double step_;
  std::vector<int> change_;
};

}  // namespace kempe::sweep
