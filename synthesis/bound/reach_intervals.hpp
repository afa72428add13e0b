#pragma once
// Ranges, and the reach equation (c r)^2 = w (H(t) + cos psi), in intervals: for the proven bound's backends.

#include "geometry/interval.hpp"
#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

inline Interval whole(const Range& range) { return {range.lower, range.upper}; }

/// About: for what need not be proven.
inline double middle_of(const Interval& x) { return 0.5 * (x.inf() + x.sup()); }
inline Complex middle_of(const IntervalComplex& z) { return {middle_of(z.re), middle_of(z.im)}; }

/// H(t) = (t + 1/t)/2.
inline Interval H_at(double t) { return (Interval(t) + 1.0 / Interval(t)) / 2.0; }

/// Its slope along the logarithm of t.
inline Interval H_slope(const Interval& t) { return (t - 1.0 / t) / 2.0; }

/// H over a range of t: convex, least at 1.
Interval H_over(const Range& t);

/// a = VA and b = VB/|s| from t and w.
struct Lengths {
  Interval a, b;
};
inline Lengths lengths_of(double t, double w) {
  return {CGAL::sqrt(Interval(w) / (2.0 * Interval(t))), CGAL::sqrt(Interval(w) * Interval(t) / 2.0)};
}

/// (c r)^2 for a range of distances r, mm^2.
inline Interval chain_squared(const ModeFacts& mode, const Interval& distance) {
  return CGAL::square(widened(mode.chain) * distance);
}

}  // namespace kempe::bounding
