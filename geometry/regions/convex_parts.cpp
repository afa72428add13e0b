#include "geometry/regions/convex_parts.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/orientation.hpp"
#include "geometry/regions/triangulation.hpp"

namespace kempe {
namespace {

/// Triangles joined across their common edges (Hertel and Mehlhorn 1983: at most four times as many parts as the fewest).
class JoinedTriangles {
 public:
  explicit JoinedTriangles(Triangulation triangulation) : corners_(std::move(triangulation.corners)) {
    for (const auto& triangle : triangulation.triangles) add({triangle.begin(), triangle.end()});
    for (const auto& triangle : triangulation.triangles)
      for (std::size_t i = 0; i < 3; ++i) join_across({triangle[i], triangle[(i + 1) % 3]});
  }

  std::vector<ConvexPart> parts() const {
    std::vector<ConvexPart> result;
    for (const Corners& part : parts_)
      if (!part.empty()) result.push_back(without_flat_corners(part));
    return result;
  }

 private:
  using Corners = std::vector<std::size_t>;
  using Edge = std::pair<std::size_t, std::size_t>;  // with its part on the left

  void add(Corners part) {
    for (std::size_t i = 0; i < part.size(); ++i)
      part_of_[{part[i], part[(i + 1) % part.size()]}] = parts_.size();
    parts_.push_back(std::move(part));
  }

  bool turns_right(std::size_t a, std::size_t b, std::size_t c) const {
    return orientation(corners_[a], corners_[b], corners_[c]) < 0;
  }

  /// The part's corners, the edge's end first and its start last.
  Corners opened_at(const Edge& edge, std::size_t part) const {
    Corners corners = parts_[part];
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), edge.second), corners.end());
    return corners;
  }

  void join_across(const Edge& edge) {
    const Edge other_way{edge.second, edge.first};
    const auto left = part_of_.find(edge), right = part_of_.find(other_way);
    if (left == part_of_.end() || right == part_of_.end()) return;
    const std::size_t kept = left->second, taken = right->second;
    Corners corners = opened_at(edge, kept);
    const Corners more = opened_at(other_way, taken);
    if (turns_right(corners[corners.size() - 2], edge.first, more[1]) ||
        turns_right(more[more.size() - 2], edge.second, corners[1]))
      return;
    corners.insert(corners.end(), more.begin() + 1, more.end() - 1);
    for (std::size_t i = 0; i + 1 < more.size(); ++i) part_of_[{more[i], more[i + 1]}] = kept;
    part_of_.erase(edge);
    part_of_.erase(other_way);
    parts_[kept] = std::move(corners);
    parts_[taken].clear();
  }

  ConvexPart without_flat_corners(const Corners& part) const {
    ConvexPart result;
    const std::size_t n = part.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point& corner = corners_[part[i]];
      if (orientation(corners_[part[(i + n - 1) % n]], corner, corners_[part[(i + 1) % n]]) != 0)
        result.push_back(as_complex(corner));
    }
    return result;
  }

  std::vector<Point> corners_;
  std::vector<Corners> parts_;
  std::map<Edge, std::size_t> part_of_;
};

ConvexPart as_part(const Ring& ring) {
  ConvexPart whole;
  for (const Point& corner : ring) whole.push_back(as_complex(corner));
  return whole;
}

}  // namespace

bool is_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) < 0) return false;
  return true;
}

std::vector<ConvexPart> convex_parts(const Polygon& polygon) {
  if (polygon.holes.empty() && is_convex(polygon.outer)) return {as_part(polygon.outer)};
  std::vector<Ring> rings{polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  return JoinedTriangles(triangulated(rings)).parts();
}

}  // namespace kempe
