#include "synthesis/convex_parts.hpp"

#include <algorithm>
#include <utility>

namespace kempe {
namespace {

bool turns_left(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a) > 0; }

bool is_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return true;
}

/// An edge that rises, whichever way it was drawn.
struct RisingEdge {
  Point lower, upper;

  double x_at(double y) const {
    if (y == lower.y()) return lower.x();
    if (y == upper.y()) return upper.x();
    return lower.x() + (y - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x());
  }
};

std::vector<RisingEdge> rising_edges(const Polygon& polygon) {
  std::vector<RisingEdge> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (a.y() < b.y()) edges.push_back({a, b});
      if (a.y() > b.y()) edges.push_back({b, a});
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return edges;
}

/// What lies between two edges from one height to another, without corners that stand twice.
ConvexPart trapezoid(const RisingEdge& left, const RisingEdge& right, double bottom, double top) {
  ConvexPart part;
  for (const Complex corner : {Complex(left.x_at(bottom), bottom), Complex(right.x_at(bottom), bottom),
                               Complex(right.x_at(top), top), Complex(left.x_at(top), top)})
    if (part.empty() || (part.back() != corner && part.front() != corner)) part.push_back(corner);
  return part;
}

/// A polygon with holes as trapezoids: between the heights of neighbouring corners the edges do not meet, and every second
/// space between them is inside. Spaces between the same two edges above each other are one part.
std::vector<ConvexPart> trapezoids(const Polygon& polygon) {
  const std::vector<RisingEdge> edges = rising_edges(polygon);
  std::vector<double> heights;
  for (const RisingEdge& edge : edges) heights.insert(heights.end(), {edge.lower.y(), edge.upper.y()});
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<ConvexPart> parts;
  using Sides = std::pair<const RisingEdge*, const RisingEdge*>;
  std::vector<std::pair<Sides, double>> open;  // and from which height on
  for (std::size_t i = 0; i < heights.size(); ++i) {
    std::vector<std::pair<double, const RisingEdge*>> across;
    if (i + 1 < heights.size())
      for (const RisingEdge& edge : edges)
        if (edge.lower.y() <= heights[i] && edge.upper.y() >= heights[i + 1])
          across.emplace_back(edge.x_at(0.5 * (heights[i] + heights[i + 1])), &edge);
    std::sort(across.begin(), across.end());
    std::vector<std::pair<Sides, double>> next;
    for (std::size_t j = 0; j + 1 < across.size(); j += 2)
      next.push_back({{across[j].second, across[j + 1].second}, heights[i]});
    for (const auto& [sides, since] : open) {
      const Sides here = sides;
      const auto same =
          std::find_if(next.begin(), next.end(), [here](const auto& other) { return other.first == here; });
      if (same != next.end())
        same->second = since;
      else
        parts.push_back(trapezoid(*sides.first, *sides.second, since, heights[i]));
    }
    open = std::move(next);
  }
  return parts;
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
  if (!polygon.holes.empty()) return trapezoids(polygon);
  if (is_convex(polygon.outer)) {
    ConvexPart whole;
    for (const Point& corner : polygon.outer) whole.push_back(as_complex(corner));
    return {whole};
  }
  std::vector<ConvexPart> parts;
  Ring ring = polygon.outer;
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
