#pragma once
// The stations of the verification: where the tracer is driven.

#include <vector>

#include "synthesis/verification/verification.hpp"

namespace kempe {

/// Places that the tracer visits, in order, as seen from the pole: the corners and long edges of every ring, the
/// nearest and the farthest place, then a hatch of the inside in two directions.
std::vector<Point> stations_over(const Region& region, const Point& pole, const VerificationOptions& options);

}  // namespace kempe
