#pragma once
// Is a point of the linkage in an obstacle in every design of a cell, with the tracer at a place? In intervals.

#include <optional>

#include "synthesis/certificate/design_cell.hpp"

namespace kempe::certificate {

/// Where a material point stands in the middle design, and how far it may be from there in any other, mm.
struct PointRange {
  Point middle = Point::Zero();
  double away = 0;
};

/// `from`: the point V + of_a p + of_b q/s less the pole's joint; of what is `seen_from_a_joint` less that joint, and then the range is
/// of the difference. `copied`: is_copied() of it. Nothing if some design of the cell cannot be proven to reach the place, which does not
/// matter for a copied point.
std::optional<PointRange> point_over(const Root& root, const DesignCell& cell, const Point& place,
                                     const bounding::MaterialPoint& from, bool copied,
                                     bool seen_from_a_joint = false);

}  // namespace kempe::certificate
