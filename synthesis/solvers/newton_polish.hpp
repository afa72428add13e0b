#pragma once
// The last digits by our own Newton step, so that they do not depend on a solver's version or on the BLAS
// installed.

#include "synthesis/solvers/smooth_program.hpp"

namespace kempe {

/// From a point close to a solution: guesses the active constraints and bounds, and solves the first order
/// conditions
///   grad f = sum multiplier * grad g,  g = 0  on the active ones
/// by Newton's method with the program's exact Hessian. Returns the start where that does not converge.
/// Directions that nothing determines are left alone (least norm steps).
DesignVector newton_polish(const SmoothProgram& program, const DesignVector& start);

}  // namespace kempe
