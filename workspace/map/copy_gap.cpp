#include "workspace/map/copy_gap.hpp"

#include <fmt/format.h>

#include "geometry/regions/region_algebra.hpp"
#include "geometry/regions/region_growth.hpp"

namespace kempe {
namespace {

/// Exact Boolean operations on more corners than this would take seconds.
constexpr std::size_t most_region_corners = 4000;

std::size_t corners_of(const Region& region) {
  std::size_t count = 0;
  for (const Polygon& polygon : region.polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

}  // namespace

std::optional<CopyOverlap> copy_overlap(const MapTask& task, OverlapArea area) {
  if (!task.limits.copy_gap || task.region.empty()) return std::nullopt;
  const Region copy = similar_image(task.region, task.linkage.k(), task.linkage.pole());
  if (are_apart(task.region, copy, *task.limits.copy_gap)) return std::nullopt;
  const NearestPlaces nearest = *nearest_places(task.region, copy);
  const std::string found =
      nearest.distance > 0 ? fmt::format("are {:.2f} mm apart", nearest.distance) : "overlap";
  CopyOverlap overlap{
      fmt::format("overlap: the original and its copy {}; {:.2f} mm are required (sheets_gap_mm)", found,
                  *task.limits.copy_gap),
      nearest.on_one,
      {}};
  if (area == OverlapArea::left_out || corners_of(task.region) > most_region_corners) return overlap;
  if (const auto around = grown(copy, *task.limits.copy_gap))
    overlap.area = intersection(as_arcs(task.region), as_arcs(*around));
  return overlap;
}

}  // namespace kempe
