#include "geometry/regions/region_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/regions/ring_sweep.hpp"

namespace kempe {
namespace {

std::string describe(const Point& point) { return fmt::format("[{}, {}]", point.x(), point.y()); }

/// The ring's width across the line from its first corner to the corner farthest from it: at most twice the
/// least width that any direction sees, and never below it.
double width_across(const Ring& ring) {
  const Point& origin = ring.front();
  const auto farthest = std::max_element(ring.begin(), ring.end(), [&](const Point& a, const Point& b) {
    return (a - origin).squaredNorm() < (b - origin).squaredNorm();
  });
  const Point along = (*farthest - origin).stableNormalized();
  double lowest = 0, highest = 0;
  for (const Point& corner : ring) {
    const double offset = cross(along, corner - origin);
    lowest = std::min(lowest, offset);
    highest = std::max(highest, offset);
  }
  return highest - lowest;
}

/// The rings of a region to be, outer rings first.
struct RingList {
  std::vector<Ring> rings;
  std::size_t outer_count;
  bool is_hole(std::size_t ring) const { return ring >= outer_count; }
  std::size_t number(std::size_t ring) const { return is_hole(ring) ? ring - outer_count : ring; }

  /// "polygon 2" or "hole 1"; of a single ring, nothing.
  std::string label(std::size_t ring) const {
    if (rings.size() == 1) return "";
    return fmt::format("{} {}", is_hole(ring) ? "hole" : "polygon", number(ring) + 1);
  }
  std::string label_before(std::size_t ring, std::string_view text) const {
    return rings.size() == 1 ? std::string(text) : label(ring) + ": " + std::string(text);
  }
  RingFault fault(RingFault::Kind kind, std::size_t ring, std::string found, std::string allowed) const {
    return {kind, is_hole(ring), number(ring), std::move(found), std::move(allowed)};
  }
};

RingFault contact_fault(const RingList& list, const RingContact& contact) {
  const auto& [first, second] = contact;
  const std::string first_edge = describe_edge(list.rings[first.ring], first.edge);
  const std::string second_edge = describe_edge(list.rings[second.ring], second.edge);
  if (first.ring == second.ring) {
    return list.fault(
        RingFault::Kind::self_contact, first.ring,
        list.label_before(first.ring, fmt::format("the ring crosses or touches itself: {} meets {}",
                                                  first_edge, second_edge)),
        "a simple ring, whose edges meet only at the corners between neighbours");
  }
  return list.fault(RingFault::Kind::contact, second.ring,
                    fmt::format("{} and {} cross or touch: {} meets {}", list.label(first.ring),
                                list.label(second.ring), first_edge, second_edge),
                    "rings that do not touch");
}

/// Outer rings lie free or in a hole, holes in an outer ring.
std::optional<RingFault> nesting_fault(const RingList& list, const RingNesting& nesting) {
  for (std::size_t ring = 0; ring < list.rings.size(); ++ring) {
    const std::optional<std::size_t> parent = nesting.parent[ring];
    if (list.is_hole(ring) && !parent) {
      return list.fault(RingFault::Kind::nesting, ring, list.label(ring) + " lies outside every polygon",
                        "holes inside a polygon");
    }
    if (parent && list.is_hole(ring) == list.is_hole(*parent)) {
      return list.fault(RingFault::Kind::nesting, ring,
                        fmt::format("{} lies inside {}", list.label(ring), list.label(*parent)),
                        list.is_hole(ring)
                            ? "holes that do not touch"
                            : "polygons beside each other; what is left out belongs among the holes");
    }
  }
  return std::nullopt;
}

Region gather(RingList&& list, const RingNesting& nesting) {
  Region region;
  region.polygons.resize(list.outer_count);
  for (std::size_t ring = 0; ring < list.rings.size(); ++ring) {
    Ring& corners = list.rings[ring];
    if (nesting.counter_clockwise[ring] == list.is_hole(ring)) std::reverse(corners.begin(), corners.end());
    if (list.is_hole(ring)) {
      region.polygons[*nesting.parent[ring]].holes.push_back(std::move(corners));
    } else {
      region.polygons[ring].outer = std::move(corners);
    }
  }
  return region;
}

}  // namespace

std::string describe_edge(const Ring& ring, std::size_t edge) {
  return fmt::format("edge {} from {} to {}", edge + 1, describe(ring[edge]),
                     describe(ring[(edge + 1) % ring.size()]));
}

Ring without_repeated_corners(const Ring& ring) {
  Ring result;
  result.reserve(ring.size());
  std::unique_copy(ring.begin(), ring.end(), std::back_inserter(result));
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

std::optional<ShapeFault> shape_fault(const Ring& ring) {
  for (const Point& corner : ring) {
    // Written so that NaN fails it too.
    if (corner.cwiseAbs().maxCoeff() <= largest_coordinate) continue;
    return ShapeFault{"a corner at " + describe(corner),
                      fmt::format("coordinates from {0} to {1} mm", -largest_coordinate, largest_coordinate)};
  }
  if (ring.size() < 3) {
    return ShapeFault{fmt::format("a ring of {} different corners", ring.size()), "at least 3 corners"};
  }
  const double width = width_across(ring);
  if (width < smallest_ring_width) {
    return ShapeFault{fmt::format("a ring of no area: it is {:.3g} mm wide", width),
                      fmt::format("rings at least {} mm wide", smallest_ring_width)};
  }
  return std::nullopt;
}

tl::expected<Region, RingFault> assemble_region(const std::vector<Ring>& outers,
                                                const std::vector<Ring>& holes) {
  RingList list{{}, outers.size()};
  if (outers.empty())
    return tl::unexpected(
        RingFault{RingFault::Kind::no_ring, false, 0, "no polygon", "at least one polygon"});
  for (const Ring& ring : outers) list.rings.push_back(without_repeated_corners(ring));
  for (const Ring& ring : holes) list.rings.push_back(without_repeated_corners(ring));
  for (std::size_t ring = 0; ring < list.rings.size(); ++ring) {
    if (auto fault = shape_fault(list.rings[ring])) {
      return tl::unexpected(
          list.fault(RingFault::Kind::shape, ring, list.label_before(ring, fault->found), fault->allowed));
    }
  }
  const auto nesting = examine_rings(list.rings);
  if (!nesting) return tl::unexpected(contact_fault(list, nesting.error()));
  if (auto fault = nesting_fault(list, *nesting)) return tl::unexpected(*fault);
  return gather(std::move(list), *nesting);
}

}  // namespace kempe
