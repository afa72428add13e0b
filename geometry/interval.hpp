#pragma once
// Interval arithmetic for proofs: +, -, *, / and square roots rounded outwards by the processor, and enclosures of the few
// sines, cosines and arcs that proofs need. It brings CGAL along: only *_backend.cpp files include it.
//
// The C library promises nothing about its functions while the processor rounds upwards. Those here ask it with the
// processor rounding to nearest, where its results are off by less than one unit in the last place, and widen them by four.

#include <CGAL/Interval_nt.h>

#include "geometry/complex_vectors.hpp"

namespace kempe {

/// A range of reals. Its operators are only valid while an OutwardRounding lives.
using Interval = CGAL::Interval_nt<false>;

/// Switches the processor to upward rounding as long as it lives, and back to what it was.
using OutwardRounding = Interval::Protector;

/// Switches the processor to rounding to nearest as long as it lives, and back to what it was.
class NearestRounding {
 public:
  NearestRounding() : before_(CGAL::FPU_get_and_set_cw(CGAL_FE_TONEAREST)) {}
  ~NearestRounding() { CGAL::FPU_set_cw(before_); }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  CGAL::FPU_CW_t before_;
};

/// `value` give or take sixteen units in the last place of itself or of 1, whichever is larger: room for the roundings of a
/// short formula without cancellation.
Interval widened(double value);

/// Enclosures over all angles (rad) of the interval.
Interval cosine(const Interval& angle);
Interval sine(const Interval& angle);

/// All angles of [0, pi] whose cosine lies in the interval, rad; a cosine beyond -1 or 1 counts as -1 or 1.
Interval arc_cosine(const Interval& cosine);

/// Natural logarithms of all numbers of the interval, which are positive.
Interval logarithm(const Interval& positive);

/// A complex number known to within a rectangle.
struct IntervalComplex {
  Interval re, im;
};
inline IntervalComplex exactly(Complex z) { return {Interval(z.real()), Interval(z.imag())}; }
/// Both parts known to sixteen units in the last place of |z|.
IntervalComplex widened(Complex z);
/// exp(i angle).
inline IntervalComplex direction_at(const Interval& angle) { return {cosine(angle), sine(angle)}; }

inline IntervalComplex operator+(const IntervalComplex& u, const IntervalComplex& v) {
  return {u.re + v.re, u.im + v.im};
}
inline IntervalComplex operator-(const IntervalComplex& u, const IntervalComplex& v) {
  return {u.re - v.re, u.im - v.im};
}
inline IntervalComplex operator*(const IntervalComplex& u, const IntervalComplex& v) {
  return {u.re * v.re - u.im * v.im, u.re * v.im + u.im * v.re};
}
inline IntervalComplex operator*(const Interval& factor, const IntervalComplex& z) {
  return {factor * z.re, factor * z.im};
}
inline Interval squared_length(const IntervalComplex& z) { return CGAL::square(z.re) + CGAL::square(z.im); }
inline Interval length(const IntervalComplex& z) { return CGAL::sqrt(squared_length(z)); }
inline IntervalComplex operator/(const IntervalComplex& u, const IntervalComplex& v) {
  const Interval square = squared_length(v);
  return {(u.re * v.re + u.im * v.im) / square, (u.im * v.re - u.re * v.im) / square};
}

}  // namespace kempe
