#pragma once
// Points of the table's plane.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "kempe/units.hpp"

namespace kempe {

/// A point or vector of the table's plane, mm; x to the right, y away from you.
using Point = Eigen::Vector2d;

/// A plane vector where a formula is a similarity: multiplication turns and scales.
using Complex = std::complex<double>;

/// Straight edges from point to point, mm.
using Polyline = std::vector<Point>;

}  // namespace kempe
