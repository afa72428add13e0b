#pragma once
// A job seen from a place in its midst: coordinates far from the table's origin would cost digits in every difference
// of places, and bounds would need slack for them.

#include "specs/spec.hpp"

namespace kempe {

/// Where a job is best seen from: a fixed pole, else the middle of the region, rounded so that subtracting it changes
/// ordinary coordinates by nothing.
Point local_origin(const Spec& spec);

/// The same job with everything shifted: region, pole and obstacles. Nothing else of a spec knows a place.
Spec shifted(Spec spec, const Point& by);

/// The same linkage, its pole shifted.
CopyingLinkage shifted(const CopyingLinkage& linkage, const Point& by);

}  // namespace kempe
