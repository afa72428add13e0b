#pragma once
// How much of the region is lost, and to what.

#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// The shares of the region in each lost area, the largest first; shares below 1e-6 are left out. Exact
/// intersections; nothing if they would take seconds.
std::vector<RegionLoss> region_losses(const std::vector<LostArea>& lost, const Region& region);

/// "28.0 % of the region is lost, most of it (21.3 %) to contact of link BCY and side clamp."; empty without
/// losses.
std::string losses_sentence(const std::vector<RegionLoss>& losses);

}  // namespace kempe
