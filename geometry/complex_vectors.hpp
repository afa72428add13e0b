#pragma once
// Products of plane vectors written as complex numbers, and segment_distance.hpp's nearest place in the same numbers.

#include <algorithm>

#include "geometry/point.hpp"

namespace kempe {

/// A quarter turn to the left.
inline constexpr Complex i_unit{0, 1};

/// Re(conj(a) b) and Im(conj(a) b).
inline double dot(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }
inline double cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// a / b for vectors of ordinary size, by the plain formula: operator/ guards against overflow, at several times the cost.
inline Complex quotient(Complex a, Complex b) { return Complex(dot(b, a), cross(b, a)) / std::norm(b); }

/// The centre of the arc from a to b of which `bulge`, not 0, is the tangent of a quarter of the sweep (arc_polygon.hpp).
inline Complex arc_centre(Complex a, Complex b, double bulge) {
  return 0.5 * (a + b) + i_unit * (b - a) * (1 - bulge * bulge) / (4 * bulge);
}

/// The place nearest to `point` on the segment from a to b, as a share of the way.
inline double nearest_share(Complex point, Complex a, Complex b) {
  const Complex along = b - a;
  const double squared = std::norm(along);
  return squared > 0 ? std::clamp(dot(along, point - a) / squared, 0.0, 1.0) : 0;
}

}  // namespace kempe
