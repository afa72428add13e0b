#include "workspace/map/losses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/regions/region_algebra.hpp"

namespace kempe {
namespace {

/// Exact intersections take about 30 us a corner.
constexpr std::size_t most_lost_corners = 30'000;
/// Smaller shares are slivers.
constexpr double least_lost_share = 1e-6;

std::size_t corners_of(const ArcRegion& region) {
  std::size_t count = 0;
  for (const ArcPolygon& polygon : region) {
    count += polygon.outer.size();
    for (const ArcRing& hole : polygon.holes) count += hole.size();
  }
  return count;
}

}  // namespace

std::string_view name(Cause cause) {
  switch (cause) {
    case Cause::out_of_reach: return "out of reach";
    case Cause::beyond_change_point: return "beyond the change point";
    case Cause::transmission_below_limit: return "transmission below the limit";
    case Cause::self_contact:
    case Cause::obstacle_contact: return "contact";
    case Cause::copy_overlap: break;
  }
  return "overlap of original and copy";
}

std::vector<RegionLoss> region_losses(const std::vector<LostArea>& lost, const Region& region) {
  const double whole = area(region);
  const ArcRegion arcs = as_arcs(region);
  std::size_t corners = corners_of(arcs) * lost.size();
  for (const LostArea& one : lost) corners += corners_of(one.area);
  if (!(whole > 0) || corners > most_lost_corners) return {};
  std::vector<RegionLoss> losses;
  for (const LostArea& one : lost) {
    const double share = area(intersection(one.area, arcs)) / whole;
    if (share > least_lost_share) losses.push_back({one.cause, one.parts, share});
  }
  std::stable_sort(losses.begin(), losses.end(),
                   [](const RegionLoss& a, const RegionLoss& b) { return a.share > b.share; });
  return losses;
}

std::string losses_sentence(const std::vector<RegionLoss>& losses) {
  if (losses.empty()) return {};
  double sum = 0;
  for (const RegionLoss& loss : losses) sum += loss.share;
  const RegionLoss& most = losses.front();
  std::string to(name(most.cause));
  if (most.parts.size() == 2) to += " of " + most.parts[0] + " and " + most.parts[1];
  if (losses.size() == 1) return fmt::format("{:.1f} % of the region is lost to this: {}.", 100 * sum, to);
  return fmt::format("{:.1f} % of the region is lost, the largest share ({:.1f} %) to: {}.", 100 * sum,
                     100 * most.share, to);
}

}  // namespace kempe
