#include "geometry/regions/ring_loops.hpp"

#include <algorithm>
#include <iterator>

#include "geometry/orientation.hpp"
#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/ring_sweep.hpp"

namespace kempe {
namespace {

struct Segment {
  Point from, to;
};

Segment edge_of(const Ring& ring, std::size_t edge) { return {ring[edge], ring[(edge + 1) % ring.size()]}; }

bool lies_on(const Point& point, const Segment& segment) {
  return segments_meet(point, point, segment.from, segment.to);
}

/// A point of both segments, which meet: an end if one lies on the other, else the crossing, rounded.
Point meeting_point(const Segment& a, const Segment& b) {
  for (const Point& end : {a.from, a.to}) {
    if (lies_on(end, b)) return end;
  }
  for (const Point& end : {b.from, b.to}) {
    if (lies_on(end, a)) return end;
  }
  const Point along = b.to - b.from;
  const double from_side = cross(along, a.from - b.from), to_side = cross(along, a.to - b.from);
  const double share = std::clamp(from_side / (from_side - to_side), 0.0, 1.0);
  return a.from + share * (a.to - a.from);
}

bool are_neighbours(const Ring& ring, const RingContact& contact) {
  const std::size_t first = contact.first.edge, second = contact.second.edge;
  return second == first + 1 || (first == 0 && second + 1 == ring.size());
}

/// The ring without the corner between two edges that fold back onto each other.
Ring without_spike(Ring ring, const RingContact& contact) {
  const std::size_t tip =
      contact.second.edge == contact.first.edge + 1 ? contact.second.edge : contact.first.edge;
  ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(tip));
  return ring;
}

/// The two rings that arise when a ring is cut and rejoined where edges first < second meet.
std::pair<Ring, Ring> split(const Ring& ring, const RingContact& contact) {
  const std::size_t first = contact.first.edge, second = contact.second.edge;
  const Point at = meeting_point(edge_of(ring, first), edge_of(ring, second));
  const auto corner = [&](std::size_t i) { return ring.begin() + static_cast<std::ptrdiff_t>(i); };
  Ring between{at}, around{at};
  between.insert(between.end(), corner(first + 1), corner(second + 1));
  around.insert(around.end(), corner(second + 1), ring.end());
  around.insert(around.end(), ring.begin(), corner(first + 1));
  return {std::move(between), std::move(around)};
}

}  // namespace

std::optional<std::vector<Ring>> simple_loops(const Ring& ring, std::size_t corner_visits) {
  std::vector<Ring> simple, open{ring};
  // Every split leaves two rings with fewer corners than the one before, so this ends.
  while (!open.empty()) {
    Ring current = without_repeated_corners(open.back());
    open.pop_back();
    if (current.size() < 3) continue;
    if (current.size() > corner_visits) return std::nullopt;
    corner_visits -= current.size();
    const auto nesting = examine_rings({current});
    if (nesting) {
      if (!nesting->counter_clockwise[0]) std::reverse(current.begin(), current.end());
      simple.push_back(std::move(current));
    } else if (are_neighbours(current, nesting.error())) {
      open.push_back(without_spike(std::move(current), nesting.error()));
    } else {
      auto [between, around] = split(current, nesting.error());
      open.push_back(std::move(around));
      open.push_back(std::move(between));
    }
  }
  return simple;
}

}  // namespace kempe
