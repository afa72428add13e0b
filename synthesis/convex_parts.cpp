#include "synthesis/convex_parts.hpp"

#include <algorithm>
#include <limits>

namespace kempe {
namespace {

bool turns_left(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a) > 0; }

bool is_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return true;
}

bool cross_properly(const Point& a, const Point& b, const Point& c, const Point& d) {
  return turns_left(a, b, c) != turns_left(a, b, d) && turns_left(c, d, a) != turns_left(c, d, b);
}

/// The corner of `ring` nearest to `from` that the straight cut reaches without crossing the ring.
std::size_t visible_corner(const Ring& ring, const Point& from) {
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double distance = (ring[i] - from).squaredNorm();
    if (distance >= nearest) continue;
    bool free = true;
    for (std::size_t j = 0; j < ring.size() && free; ++j) {
      const Point &a = ring[j], &b = ring[(j + 1) % ring.size()];
      free = a == ring[i] || b == ring[i] || !cross_properly(from, ring[i], a, b);
    }
    if (free) best = i, nearest = distance;
  }
  return best;
}

/// One ring that runs around the polygon and, along cuts there and back, around its holes.
Ring joined_ring(const Polygon& polygon) {
  Ring ring = polygon.outer;
  std::vector<Ring> holes = polygon.holes;
  const auto rightmost = [](auto& hole) {
    return std::max_element(hole.begin(), hole.end(),
                            [](const Point& a, const Point& b) { return a.x() < b.x(); });
  };
  std::sort(holes.begin(), holes.end(),
            [&](const Ring& a, const Ring& b) { return rightmost(a)->x() > rightmost(b)->x(); });
  for (Ring& hole : holes) {
    std::rotate(hole.begin(), rightmost(hole), hole.end());
    hole.push_back(hole.front());
    const auto at = ring.begin() + static_cast<std::ptrdiff_t>(visible_corner(ring, hole.front()));
    hole.push_back(*at);
    ring.insert(at + 1, hole.begin(), hole.end());
  }
  return ring;
}

bool is_ear(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
  if (!turns_left(a, b, c)) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const Point& other) {
    return other != a && other != b && other != c && turns_left(a, b, other) && turns_left(b, c, other) &&
           turns_left(c, a, other);
  });
}

}  // namespace

std::vector<ConvexPart> convex_parts(const Polygon& polygon) {
  if (polygon.holes.empty() && is_convex(polygon.outer)) {
    ConvexPart whole;
    for (const Point& corner : polygon.outer) whole.push_back(as_complex(corner));
    return {whole};
  }
  std::vector<ConvexPart> parts;
  Ring ring = joined_ring(polygon);
  while (ring.size() >= 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(ring, ear)) ++ear;
    if (ear == ring.size()) ear = 0;  // only corners without area are left to clip
    const std::size_t n = ring.size();
    const Point a = ring[(ear + n - 1) % n], b = ring[ear], c = ring[(ear + 1) % n];
    if (turns_left(a, b, c)) parts.push_back({as_complex(a), as_complex(b), as_complex(c)});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return parts;
}

}  // namespace kempe
