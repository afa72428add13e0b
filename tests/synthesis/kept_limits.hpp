#pragma once
// Does a mechanism keep everything that its spec asks for? Decided by the map and by the figures of the assembled design:
// nothing of the search, nothing of the bound.

#include <algorithm>
#include <string>

#include "synthesis/design/assemble.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::test {

/// Distance of two segments, by their ends.
inline double distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto to_segment = [](const Point& z, const Point& from, const Point& to) {
    const Point along = to - from;
    const double share = along.squaredNorm() > 0 ? (z - from).dot(along) / along.squaredNorm() : 0;
    return (z - from - std::clamp(share, 0.0, 1.0) * along).norm();
  };
  const auto side = [](const Point& from, const Point& to, const Point& z) {
    return cross(to - from, z - from);
  };
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
}

/// Distance of the region from its copy, 0 if they overlap; by every pair of edges.
inline double gap_between_sheets(const Region& region, Complex k, const Point& pole) {
  const Region copy = similar_image(region, k, pole);
  double gap = std::numeric_limits<double>::infinity();
  for (const Polygon& one : region.polygons)
    for (const Polygon& other : copy.polygons) {
      if (contains(region, other.outer[0]) || contains(copy, one.outer[0])) return 0;
      for (std::size_t i = 0; i < one.outer.size(); ++i)
        for (std::size_t j = 0; j < other.outer.size(); ++j)
          gap = std::min(gap, distance(one.outer[i], one.outer[(i + 1) % one.outer.size()], other.outer[j],
                                       other.outer[(j + 1) % other.outer.size()]));
    }
  return gap;
}

/// The first limit of the spec that the mechanism does not certainly keep; "" if it keeps all. Certain is what the map proved,
/// and every figure beyond its limit by a share of 1e-9 at least (`slack`: so much of a limit may be missed instead).
inline std::string first_limit_missed(const Spec& spec, const Design& design, double slack = -1e-9) {
  const auto below = [slack](double value, double least) { return value < least * (1 - slack); };
  const auto above = [slack](double value, double most) { return value > most * (1 + slack); };
  const CopyingLinkage& linkage = design.linkage;
  if (!design.map.coverage.covered) return "region";
  const auto lengths = linkage.lengths().values();
  const double pin = spec.links.style.pin_diameter, wall = spec.links.wall.value_or(pin / 10);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (below(lengths[i], spec.links.shortest)) return "shortest_mm";
    if (above(lengths[i], spec.links.longest)) return "longest_mm";
    if (spec.limits.longest_strip && above(lengths[i] + spec.links.style.width, *spec.limits.longest_strip))
      return "longest_strip_mm";
    if (below(lengths[i], pin + std::max(spec.cutting.hole_fit, 0.0) + wall)) return "wall_mm";
    const auto& locked = spec.links.stock_lengths.locked[i];
    if (locked && std::abs(lengths[i] - *locked) > 1e-9 * *locked) return "locked length";
  }
  if (design.layers.highest() > spec.links.layers) return "layers";
  const auto& groundings = spec.objective.groundings;
  if (std::find(groundings.begin(), groundings.end(), linkage.grounding()) == groundings.end())
    return "groundings";
  if (below(design.quality.transmission_min, spec.limits.transmission)) return "transmission_deg";
  if (below(design.quality.clearance_min, spec.limits.clearance)) return "clearance_mm";
  if (spec.limits.copy_gap) {
    const double gap = gap_between_sheets(spec.region, linkage.k(), linkage.pole());
    if (gap <= 0 || below(gap, *spec.limits.copy_gap)) return "sheets_gap_mm";
  }
  if (spec.limits.copy_error && above(design.quality.copy_error_worst.value_or(0), *spec.limits.copy_error))
    return "copy_error_mm";
  return "";
}

}  // namespace kempe::test
