#pragma once
// Convex polygons, and hulls by Andrew's monotone chain: A. M. Andrew, Inf. Proc. Letters 9 (1979).

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// Whether a place lies in a convex polygon, given counter-clockwise, or on its edge; everywhere if it has no corner.
bool lies_within(const std::vector<Point>& polygon, const Point& place);

/// Corners of the convex hull, counter-clockwise from the leftmost (of several the lowest), none between two others on a
/// line. Fewer than three if all points lie on one line. Exact: decided by orientation().
std::vector<Point> convex_hull(std::vector<Point> points);

/// The same of points sorted by sweeps_before, for innermost loops: writes the corners to `hull`, which has room for one more
/// than there are points, and returns their number. `turns_left(a, b, c)` decides whether b is a corner. Equal points may
/// follow each other.
template <class TurnsLeft>
std::size_t hull_of_sorted(std::span<const Point> points, std::span<Point> hull,
                           const TurnsLeft& turns_left) {
  std::size_t count = 0;
  const auto add = [&](const Point& next, std::size_t keep) {
    while (count > keep && !turns_left(hull[count - 2], hull[count - 1], next)) --count;
    hull[count++] = next;
  };
  for (const Point& point : points) add(point, 1);
  const std::size_t lower = count;
  for (std::size_t i = points.size(); i-- > 1;) add(points[i - 1], lower);
  if (count > 1) --count;  // the last corner is the first again
  if (count == 2 && hull[0] == hull[1]) count = 1;
  return count;
}

}  // namespace kempe
