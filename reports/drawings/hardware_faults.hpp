#pragma once
// Heads, nuts and ends of screws and pins against all that may meet them.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// What the hardware of a design does that contact is not certified for, and lengths that nobody makes; a sentence each. Exact
/// over the certified opening: heads, nuts and the ends of screws and pins against each other, against posts, and against links in the
/// layers where they stand; of links first what happens over the region, and only where that is nothing what happens outside it.
/// Bodies are taken for discs as large as they reach from their point. Obstacles are measured with the tracer at the places of the
/// region that the verification drives to, unless an own link's certified contact answers for what stands on it.
std::vector<std::string> hardware_faults(const Design& design);

}  // namespace kempe
