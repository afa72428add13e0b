#pragma once
// Where a design is shown.

#include "synthesis/design/design.hpp"

namespace kempe {

/// A place of the region (of the workspace, if there is no region) where the design is good to look at: its
/// linkage assembles there.
Point place_to_show(const Design& design);

}  // namespace kempe
