#pragma once
// How well readings fit: the residual of each, and whether all together contradict what was stated.

#include "kempe/point.hpp"

namespace kempe {

/// How one reading fits.
struct ReadingFit {
  Point departure = Point::Zero();  ///< read less wanted: what the instrument did wrong, mm
  Point left = Point::Zero();  ///< read less fitted: what no correction of the free measures takes away, mm
  /// Length of `left` in units of its own uncertainty, without this reading's own influence
  double studentised = 0;
  double leverage = 0;   ///< 0..1: how much this reading decides its own fit
  bool outlier = false;  ///< named: chance would name any reading in at most one of a thousand fits
};

/// What is left, against what the stated uncertainties let expect.
struct FitCheck {
  double chi_squared = 0;    ///< sum of squares in stated uncertainties, readings and lengths in use
  int freedom = 0;           ///< its degrees of freedom, >= 1
  double probability = 1;    ///< of a larger one by chance
  bool contradicts() const;  ///< less than once in a thousand fits
};

}  // namespace kempe
