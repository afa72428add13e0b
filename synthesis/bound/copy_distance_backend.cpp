#include <algorithm>
#include <vector>

#include "geometry/interval.hpp"
#include "geometry/orientation.hpp"
#include "geometry/segment_distance.hpp"
#include "synthesis/bound/copy_distance.hpp"

namespace kempe::bounding {
namespace {

IntervalComplex place_of(const PlaceOnSegment& at) {
  const IntervalComplex from = exactly(as_complex(at.from));
  return from + Interval(at.share) * (exactly(as_complex(at.to)) - from);
}

/// Whether an upward ray from a point crosses an edge, exactly.
bool ray_crosses(const BoundaryEdge& edge, const Point& point) {
  if ((edge.from.x() > point.x()) == (edge.to.x() > point.x())) return false;
  return orientation(edge.from, edge.to, point) == (edge.to.x() > edge.from.x() ? -1 : 1);
}

}  // namespace

double copy_distance_at_most(Complex k, const PlaceOnSegment& copied, const PlaceOnSegment& other,
                             const Point& pole, double radius) {
  const OutwardRounding guard;
  const IntervalComplex ratio = widened(k), at = exactly(as_complex(pole));
  const IntervalComplex image = at + ratio * (place_of(copied) - at);
  const Interval moved = length(exactly(1.0) - ratio) * Interval(radius);
  return (length(image - place_of(other)) + moved).sup();
}

bool copy_surely_inside(Complex k, const Point& copied, const RegionReach& region, const Point& pole,
                        double radius) {
  const Point middle = pole + as_point(k * as_complex(copied - pole));
  bool inside = false;
  for (const BoundaryEdge& edge : region.edges()) inside ^= ray_crosses(edge, middle);
  if (!inside) return false;
  std::vector<Complex> directions;  // to the middle from the nearest place of each edge
  for (const BoundaryEdge& edge : region.edges())
    directions.push_back(as_complex(middle - nearest_on_segment(middle, edge.from, edge.to)));
  const OutwardRounding guard;
  const IntervalComplex ratio = widened(k), at = exactly(as_complex(pole));
  const IntervalComplex image = at + ratio * (exactly(as_complex(copied)) - at);
  const Interval moved = length(exactly(1.0) - ratio) * Interval(radius);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const IntervalComplex n = exactly(directions[i]);
    const auto along_n = [&](const IntervalComplex& z) { return n.re * z.re + n.im * z.im; };
    const auto& edge = region.edges()[i];
    const double least = std::min(along_n(image - exactly(as_complex(edge.from))).inf(),
                                  along_n(image - exactly(as_complex(edge.to))).inf());
    // The middle may be beside the image, by no more than both are off.
    const double beside =
        std::min(along_n(exactly(as_complex(middle)) - exactly(as_complex(edge.from))).inf(),
                 along_n(exactly(as_complex(middle)) - exactly(as_complex(edge.to))).inf());
    if (!(least > (length(n) * moved).sup() && beside > 0)) return false;
  }
  return true;
}

}  // namespace kempe::bounding
