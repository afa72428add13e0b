#pragma once
// Figures of the designs of a box to first order about its middle, in intervals: for the proven bound's backends.
//
//   f = middle + sum of along[i] y_i + off,  |y_i| <= 1
//
// for every design, y_i its coordinates from the middle in half widths of the box. What a figure is off by goes with the square of the box's
// width. A sum or product of such figures is one, and so is a function of one, by its second derivative.

#include <array>
#include <cstddef>

#include "geometry/interval.hpp"

namespace kempe::bounding {

struct FirstOrder {
  static constexpr std::size_t coordinates = 4;

  Interval middle{0};
  std::array<Interval, coordinates> along{Interval(0), Interval(0), Interval(0), Interval(0)};
  Interval off{0};

  /// All of it over the box, less the middle.
  Interval spread() const {
    Interval sum = off;
    for (const Interval& slope : along) sum += slope * Interval(-1, 1);
    return sum;
  }
  Interval all() const { return middle + spread(); }
};

inline FirstOrder constant(const Interval& value) {
  FirstOrder f;
  f.middle = value;
  return f;
}

inline FirstOrder operator+(const FirstOrder& f, const FirstOrder& g) {
  FirstOrder sum = f;
  sum.middle += g.middle;
  for (std::size_t i = 0; i < FirstOrder::coordinates; ++i) sum.along[i] += g.along[i];
  sum.off += g.off;
  return sum;
}

inline FirstOrder operator*(const Interval& factor, const FirstOrder& f) {
  FirstOrder product = f;
  product.middle *= factor;
  for (Interval& slope : product.along) slope *= factor;
  product.off *= factor;
  return product;
}

inline FirstOrder operator-(const FirstOrder& f, const FirstOrder& g) { return f + Interval(-1) * g; }

inline FirstOrder operator*(const FirstOrder& f, const FirstOrder& g) {
  FirstOrder product;
  product.middle = f.middle * g.middle;
  for (std::size_t i = 0; i < FirstOrder::coordinates; ++i)
    product.along[i] = f.middle * g.along[i] + g.middle * f.along[i];
  product.off = f.middle * g.off + g.middle * f.off + f.spread() * g.spread();
  return product;
}

/// A function of f, by its value and slope at f's middle and its second derivatives over all of f.
inline FirstOrder function_of(const FirstOrder& f, const Interval& value, const Interval& slope,
                              const Interval& second) {
  FirstOrder result = slope * f;
  result.middle = value;
  result.off += second * CGAL::square(f.spread()) * Interval(0.5);
  return result;
}

/// 1 / root(f) and root(f), of what is positive all over the box.
inline FirstOrder inverse_root(const FirstOrder& f) {
  const Interval all = f.all(), value = 1.0 / CGAL::sqrt(f.middle);
  return function_of(f, value, -0.5 * value / f.middle, 0.75 / (all * all * CGAL::sqrt(all)));
}
inline FirstOrder root(const FirstOrder& f) {
  const Interval all = f.all(), value = CGAL::sqrt(f.middle);
  return function_of(f, value, 0.5 / value, -0.25 / (all * CGAL::sqrt(all)));
}

struct FirstOrderComplex {
  FirstOrder re, im;
};

inline FirstOrderComplex constant(const IntervalComplex& z) { return {constant(z.re), constant(z.im)}; }
inline FirstOrderComplex conjugate(const FirstOrderComplex& z) { return {z.re, Interval(-1) * z.im}; }
inline FirstOrderComplex operator+(const FirstOrderComplex& u, const FirstOrderComplex& v) {
  return {u.re + v.re, u.im + v.im};
}
inline FirstOrderComplex operator-(const FirstOrderComplex& u, const FirstOrderComplex& v) {
  return {u.re - v.re, u.im - v.im};
}
inline FirstOrderComplex operator*(const FirstOrder& factor, const FirstOrderComplex& z) {
  return {factor * z.re, factor * z.im};
}
inline FirstOrderComplex operator*(const IntervalComplex& u, const FirstOrderComplex& v) {
  return {u.re * v.re - u.im * v.im, u.re * v.im + u.im * v.re};
}
inline FirstOrderComplex operator*(const FirstOrderComplex& u, const FirstOrderComplex& v) {
  return {u.re * v.re - u.im * v.im, u.re * v.im + u.im * v.re};
}

}  // namespace kempe::bounding
