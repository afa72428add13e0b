#include "geometry/regions/region_growth.hpp"

#include <fmt/format.h>

#include <optional>

namespace kempe {
namespace {

/// The first ring that is no polygon by itself.
std::optional<RingFault> fault_of_one(const std::vector<Ring>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto alone = assemble_region({rings[i]}, {});
    if (alone) continue;
    RingFault fault = alone.error();
    fault.ring = i;
    fault.found = fmt::format("polygon {}: {}", i + 1, fault.found);
    return fault;
  }
  return std::nullopt;
}

/// A fault of the union, told of the rings that were given: those of the union itself stand at the first
/// polygon.
RingFault in_given_rings(RingFault fault, std::size_t hole_count) {
  if (!fault.is_hole || fault.ring >= hole_count) {
    fault.is_hole = false;
    fault.ring = 0;
  }
  fault.found = "once overlapping polygons are united: " + fault.found;
  return fault;
}

}  // namespace

tl::expected<Region, RingFault> assemble_united_region(const std::vector<Ring>& outers,
                                                       const std::vector<Ring>& holes) {
  auto region = assemble_region(outers, holes);
  if (region || region.error().kind != RingFault::Kind::contact || region.error().is_hole) return region;
  if (const auto fault = fault_of_one(outers)) return tl::unexpected(*fault);
  const auto sum = united(outers);
  if (!sum) {
    RingFault fault = region.error();
    fault.found += " (they cannot be united: " + sum.error() + ")";
    return tl::unexpected(fault);
  }
  std::vector<Ring> united_outers, all_holes = holes;
  for (const Polygon& polygon : sum->polygons) {
    united_outers.push_back(polygon.outer);
    all_holes.insert(all_holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return assemble_region(united_outers, all_holes).map_error([&](const RingFault& fault) {
    return in_given_rings(fault, holes.size());
  });
}

}  // namespace kempe
