#pragma once
// Products of plane vectors written as complex numbers.

#include "geometry/point.hpp"

namespace kempe {

/// Re(conj(a) b) and Im(conj(a) b).
inline double dot(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }
inline double cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

}  // namespace kempe
