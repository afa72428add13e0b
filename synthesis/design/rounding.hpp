#pragma once
// Lengths as a maker marks them out: rounded to what the tolerance can tell.

#include <optional>

#include "synthesis/design/design.hpp"

namespace kempe {

/// Lengths rounded to the nearest multiple of a power of ten, and what that costs.
struct RoundedLengths {
  double step = 0;        ///< mm: at most a fifth of the tolerance of a length; without one 0.01
  LinkLengths lengths{};  ///< mm, multiples of `step`; the parts' drawings keep the exact ones
  /// mm, first order: the worst copy error over the region of an instrument with just these lengths, and of one that is made
  /// to them within the tolerances. Absent where the region is not reached, or there is none.
  std::optional<double> copy_error{}, with_tolerance{};
};

/// Guarantees: no length is rounded by more than half a step; all keep shortest, longest, the strip and locked lengths of the spec as
/// the exact ones do, and with_tolerance keeps the limit on the copy error if the exact lengths keep it. The step becomes finer
/// until they do, down to a nanometre, where no rounding is left to speak of.
RoundedLengths rounded_lengths(const Design& design);

/// Decimals that a multiple of the step has.
int decimals_of(const RoundedLengths& rounded);

}  // namespace kempe
