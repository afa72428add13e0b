#pragma once
// What holds a function generator of smallest largest error: the ripples of its error and the limits.

#include <string>
#include <vector>

#include "synthesis/functions/error.hpp"

namespace kempe {

/// A local maximum of |e| over the range.
struct ErrorRipple {
  double x = 0, height = 0;  ///< height in rad
  int sign = 1;              ///< of e there
};

/// All of them, highest first; places to rounding for those within a tenth of the highest. At least one.
std::vector<ErrorRipple> ripples_of(const GeneratorError& error, const GeneratorVector& u);

/// A limit on a design.
struct GeneratorLimit {
  /// The spec's key; "dead point" where no transmission angle is asked for; "turning back".
  std::string name;
  Sloped excess;  ///< at most 0
};

/// All limits at u, always in the same order.
std::vector<GeneratorLimit> limits_of(const GeneratorError& error, const GeneratorVector& u);

/// A design with other unknowns, not yet driven.
FunctionDesign with_unknowns(const GeneratorError& error, const FunctionDesign& like,
                             const GeneratorVector& u);

}  // namespace kempe
