#pragma once
// Points and similarities of the plane, and the passage between the two ways of writing them.

#include <limits>

#include "kempe/point.hpp"

namespace kempe {

inline Complex as_complex(const Point& point) { return {point.x(), point.y()}; }
inline Point as_point(Complex z) { return {z.real(), z.imag()}; }

/// z component of the cross product a x b.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vector turned left by a right angle.
inline Point left_of(const Point& v) { return {-v.y(), v.x()}; }

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// scale * exp(i rotation); exact at whole quarter turns, where sin and cos round.
Complex copy_ratio(double scale, double rotation);

}  // namespace kempe
