#pragma once
// What the independent check of a design found.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kempe/point.hpp"

namespace kempe {

/// Something that a design or its file states and that does not hold.
struct BrokenLimit {
  std::string limit;                 ///< its key: "limits.clearance_mm", "obstacles", "region"
  std::optional<double> attained{};  ///< in the key's unit; absent where no number says it
  std::optional<double> allowed{};   ///< the same
  std::optional<Point> where{};      ///< the tracer's place, mm; absent where it is no one place
  std::string sentence;              ///< for a person
};

/// What came of building the linkage from its eight lengths alone and driving the tracer over the region, with the general
/// solver: no formula of the synthesis has a part in it.
struct Verification {
  std::size_t samples = 0;       ///< places visited
  double copy_error_max = 0;     ///< mm
  double loop_residual_max = 0;  ///< mm
  double scale = 0;              ///< of the similarity fitted to the driven pairs
  double rotation = 0;           ///< of the same, rad
  int flips = 0;                 ///< changes of assembly mode seen
  bool holds = false;            ///< everything that was looked at, at the places visited
  /// Driven over the free workspace: there is no region, or none of it within reach
  bool over_workspace = false;
  std::string failure{};              ///< a sentence; empty if it holds
  std::vector<BrokenLimit> broken{};  ///< the first breach of each limit
};

}  // namespace kempe
