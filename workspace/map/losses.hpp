#pragma once
// What is lost: parts of the plane that the tracer cannot use, with their causes, and how much of the region each takes.

#include <string>
#include <string_view>
#include <vector>

#include "geometry/arc_polygon.hpp"

namespace kempe {

/// Why a part of the plane is lost.
enum class Cause {
  out_of_reach,
  beyond_change_point,
  transmission_below_limit,
  self_contact,
  obstacle_contact,
  copy_overlap
};
/// "out of reach", "beyond the change point", "transmission below the limit", "contact", "contact", "sheet
/// overlap".
std::string_view name(Cause cause);

/// A lost part of the plane with its cause.
struct LostArea {
  Cause cause;
  std::vector<std::string> parts;  ///< the two parts in contact ("link ACX", "obstacle 2"); else empty
  ArcRegion area;
};

/// A share of the region that is lost, and to what.
struct RegionLoss {
  Cause cause;
  std::vector<std::string> parts;
  double share;  ///< of the region's area
};

/// The shares of the region in each lost area, the largest first; shares below 1e-6 are left out. Exact
/// intersections; nothing if they would take seconds.
std::vector<RegionLoss> region_losses(const std::vector<LostArea>& lost, const Region& region);

/// "28.0 % of the region is lost, the largest share (21.3 %) to: contact of link BCY and side clamp."; empty without
/// losses.
std::string losses_sentence(const std::vector<RegionLoss>& losses);

}  // namespace kempe
