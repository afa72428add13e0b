#pragma once
// Does one connected component of the free cells hold the whole region?

#include "workspace/contact/subdivision.hpp"
#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// Decides the coverage of the task's region. `charts` are the subdivided free intervals of the opening,
/// refined as far as the map asked; cells that meet the region are refined further here until each is decided
/// or a limit of work is reached or `stop` is set, so that the answer is certain or says that it is not.
Coverage coverage_of(const MapTask& task, const std::vector<Subdivision>& charts, const EdgeTree& region,
                     const StopFlag& stop = {});

}  // namespace kempe
