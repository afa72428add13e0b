#pragma once
// Points of the table's plane, and angles.

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace kempe {

/// A point or vector of the table's plane, mm; x to the right, y away from you.
using Point = Eigen::Vector2d;

/// A plane vector where a formula is a similarity: multiplication turns and scales.
using Complex = std::complex<double>;

/// Straight edges from point to point, mm.
using Polyline = std::vector<Point>;

/// Half a turn, rad.
inline constexpr double pi = 3.14159265358979323846;
/// The library's own unit of angles: 0.5 * rad.
inline constexpr double rad = 1;
/// A degree in rad: 30 * degree.
inline constexpr double degree = pi / 180;
/// An angle in degrees as radians.
inline constexpr double radians(double degrees) { return degrees * degree; }
/// An angle in radians as degrees.
inline constexpr double degrees(double radians) { return radians * (180 / pi); }

}  // namespace kempe
