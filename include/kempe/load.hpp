#pragma once
// What pushes at the pen, and what carries the instrument's weight.

#include <algorithm>
#include <vector>

#include "kempe/body.hpp"

namespace kempe {

/// The load of a copying linkage: a force at the pen in any direction in the plane, while pole and tracer are held; and the points
/// that the table carries besides the pole's post. Needs a material (Spec::material).
struct Load {
  double pen_force = 0;          ///< N, > 0
  std::vector<Carrier> rests{};  ///< each once; empty: only the pole's post carries the weight
  /// True if the table carries that point.
  bool rests_at(Carrier point) const { return std::find(rests.begin(), rests.end(), point) != rests.end(); }
  bool operator==(const Load&) const = default;
};

}  // namespace kempe
