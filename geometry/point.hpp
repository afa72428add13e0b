#pragma once
// Points and similarities of the plane, and the passage between the two ways of writing them.

#include <Eigen/Core>
#include <complex>

namespace kempe {

/// A point or vector of the table's plane, mm.
using Point = Eigen::Vector2d;

/// A plane vector where a formula is a similarity: multiplication turns and scales.
using Complex = std::complex<double>;

inline Complex as_complex(const Point& point) { return {point.x(), point.y()}; }
inline Point as_point(Complex z) { return {z.real(), z.imag()}; }

/// z component of the cross product a x b.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double radians(double degrees) { return degrees * (pi / 180); }
inline constexpr double degrees(double radians) { return radians * (180 / pi); }

/// scale * exp(i rotation); exact at whole quarter turns, where sin and cos round.
Complex copy_ratio(double scale, double rotation);

}  // namespace kempe
