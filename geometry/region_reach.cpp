#include "geometry/region_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/convex_hull.hpp"
#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

constexpr std::size_t edges_per_leaf = 8;

/// Nodes still to be looked at: of a tree walked in depth never more than one a level, and one.
class OpenNodes {
 public:
  bool empty() const { return count_ == 0; }
  void push(std::size_t node) { nodes_[count_++] = node; }
  std::size_t pop() { return nodes_[--count_]; }

 private:
  std::array<std::size_t, 40> nodes_{0};
  std::size_t count_ = 1;  // the root
};

void append_edges(const Ring& ring, std::vector<BoundaryEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

double squared_distance(const Box& box, const Point& point) {
  return (point - point.cwiseMax(box.lower).cwiseMin(box.upper)).squaredNorm();
}

Box joined(const Box& a, const Box& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

const Box no_box{Point(infinity, infinity), Point(-infinity, -infinity)};

/// Does the edge cross the ray from `point` towards +x? Half open, so that a corner counts once.
bool crosses_ray(const BoundaryEdge& edge, const Point& point) {
  if ((edge.from.y() > point.y()) == (edge.to.y() > point.y())) return false;
  const double share = (point.y() - edge.from.y()) / (edge.to.y() - edge.from.y());
  return edge.from.x() + share * (edge.to.x() - edge.from.x()) > point.x();
}

}  // namespace

RegionReach::RegionReach(const Region& region) {
  std::vector<Point> corners;
  for (const Polygon& polygon : region.polygons) {
    append_edges(polygon.outer, edges_);
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes) append_edges(hole, edges_);
  }
  hull_ = convex_hull(std::move(corners));
  box_ = no_box;
  for (const Point& corner : hull_) box_ = joined(box_, {corner, corner});
  build_tree();
}

void RegionReach::build_tree() {
  const std::size_t runs = (edges_.size() + edges_per_leaf - 1) / edges_per_leaf;
  while (leaves_ < runs) leaves_ *= 2;
  tree_.assign(2 * leaves_ - 1, no_box);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    Box& box = tree_[leaves_ - 1 + i / edges_per_leaf];
    box = joined(joined(box, {edges_[i].from, edges_[i].from}), {edges_[i].to, edges_[i].to});
  }
  for (std::size_t node = leaves_ - 1; node-- > 0;)
    tree_[node] = joined(tree_[2 * node + 1], tree_[2 * node + 2]);
}

RegionReach::Nearest RegionReach::nearest(const Point& from) const {
  Nearest best{.distance = infinity};
  double best2 = infinity;
  OpenNodes open;
  while (!open.empty()) {
    const std::size_t node = open.pop();
    if (squared_distance(tree_[node], from) > best2) continue;
    if (node + 1 < leaves_) {
      const std::size_t left = 2 * node + 1;
      const bool left_first = squared_distance(tree_[left], from) <= squared_distance(tree_[left + 1], from);
      open.push(left_first ? left + 1 : left);
      open.push(left_first ? left : left + 1);
      continue;
    }
    const std::size_t first = (node + 1 - leaves_) * edges_per_leaf;
    for (std::size_t i = first; i < std::min(first + edges_per_leaf, edges_.size()); ++i) {
      const Point place = nearest_on_segment(from, edges_[i].from, edges_[i].to);
      const double distance2 = (place - from).squaredNorm();
      if (distance2 > best2 || (distance2 == best2 && i > best.edge)) continue;
      best2 = distance2;
      best.edge = i;
      best.place = place;
    }
  }
  best.distance = std::sqrt(best2) * (contains(from) ? -1 : 1);
  return best;
}

RegionReach::Farthest RegionReach::farthest(const Point& from) const {
  Farthest best{.distance = -1};
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const double distance2 = (hull_[i] - from).squaredNorm();
    if (distance2 > best.distance) best = {distance2, i};
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

DistanceRange RegionReach::range(const Point& from) const {
  return {std::max(0.0, nearest(from).distance), farthest(from).distance};
}

double RegionReach::distance_from_box(const Point& point) const {
  return std::sqrt(squared_distance(box_, point));
}

bool RegionReach::contains(const Point& point) const {
  bool inside = false;
  OpenNodes open;
  while (!open.empty()) {
    const std::size_t node = open.pop();
    const Box& box = tree_[node];
    if (point.y() < box.lower.y() || point.y() > box.upper.y() || point.x() > box.upper.x()) continue;
    if (node + 1 < leaves_) {
      open.push(2 * node + 2);
      open.push(2 * node + 1);
      continue;
    }
    const std::size_t first = (node + 1 - leaves_) * edges_per_leaf;
    for (std::size_t i = first; i < std::min(first + edges_per_leaf, edges_.size()); ++i)
      inside ^= crosses_ray(edges_[i], point);
  }
  return inside;
}

}  // namespace kempe
