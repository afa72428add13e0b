#pragma once
// How near joints come to each other and to what is no pin, and the heights that things share.

#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// The openings at which the tracer covers the region, of those shown; all of these without a region, or where it covers none of it.
OpeningInterval openings_over_region(const Design& design);

/// The least distance of two joints over these openings, mm; exact.
double least_distance(const Design& design, Joint one, Joint other, const OpeningInterval& openings);

/// The least distance of a joint from the outline of a link that lacks it, mm; exact. Negative: within it.
double distance_from_link(const Design& design, Joint joint, Link link, const OpeningInterval& openings);

/// The linkage with the tracer at the places of the region that the verification drives to; none without a region.
std::vector<Pose> poses_over_region(const Design& design);

/// Heights above the lower side of layer 1, mm.
struct Heights {
  double from, to;
};
bool overlap(const Heights& one, const Heights& other);
Heights heights_of(int layer, double thickness);
/// What begins in layer 1 goes down to the table, also where the linkage is raised; what ends in the highest layer goes up without end.
Heights heights_of(int lowest, int highest, double thickness);

}  // namespace kempe
