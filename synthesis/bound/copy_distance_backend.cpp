#include "geometry/interval.hpp"
#include "synthesis/bound/copy_distance.hpp"

namespace kempe::bounding {
namespace {

IntervalComplex place_of(const PlaceOnSegment& at) {
  const IntervalComplex from = exactly(as_complex(at.from));
  return from + Interval(at.share) * (exactly(as_complex(at.to)) - from);
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

}  // namespace kempe::bounding
