#pragma once
// A place that a linkage was designed to reach.

#include <optional>

#include "kempe/point.hpp"

namespace kempe {

/// A place asked for, and the one that the linkage reaches. mm, rad, y upward.
struct PlaceAskedFor {
  Point at = Point::Zero();             ///< asked for, mm
  Point reached = Point::Zero();        ///< mm
  std::optional<double> angle;          ///< rad, direction of the body that carries the point; for poses only
  std::optional<double> reached_angle;  ///< rad; there where `angle` is
  double share = 0;                     ///< of the motion, 0 to 1, after which it is reached
};

}  // namespace kempe
