#pragma once
// The sign of a triangle's area, exactly: what decides whether edges cross.

#include "geometry/point.hpp"

namespace kempe {

/// +1 if a, b, c turn to the left (counter-clockwise), -1 if to the right, 0 if they lie on one line. Exact
/// for all coordinates between 1e-100 and 1e100 in magnitude (and 0): first in floating point with Shewchuk's
/// error bound, then, if that cannot decide, by summing the six products without rounding. Source: J. R.
/// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997.
int orientation(const Point& a, const Point& b, const Point& c);

/// True if the closed segments a1-a2 and b1-b2 have a point in common. Exact, as above.
bool segments_meet(const Point& a1, const Point& a2, const Point& b1, const Point& b2);

/// The order of the sweep: by x, then by y.
inline bool sweeps_before(const Point& a, const Point& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace kempe
