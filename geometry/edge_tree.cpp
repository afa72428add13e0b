#include "geometry/edge_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/segment_distance.hpp"
#include "geometry/slack.hpp"

namespace kempe {
namespace {

Box box_of(const EdgeTree::Edge& edge) { return {edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)}; }

Box hull_of(const Box& a, const Box& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

std::size_t corners_of(const Polygon& polygon) {
  std::size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
}

}  // namespace

EdgeTree::EdgeTree(const Polygon& polygon, const Point& origin) : EdgeTree(Region{{polygon}}, origin) {}

EdgeTree::EdgeTree(const Region& region, const Point& origin) {
  std::size_t count = 0;
  for (const Polygon& polygon : region.polygons) count += corners_of(polygon);
  edges_.reserve(count);
  for (const Polygon& polygon : region.polygons) {
    add(polygon.outer, origin);
    for (const Ring& hole : polygon.holes) add(hole, origin);
  }
  if (edges_.empty()) return;
  nodes_.reserve(2 * edges_.size() - 1);
  std::vector<std::uint32_t> order(edges_.size());
  std::iota(order.begin(), order.end(), 0U);
  build(order, 0, static_cast<std::uint32_t>(edges_.size()));
  std::vector<Edge> ordered;
  ordered.reserve(edges_.size());
  for (const std::uint32_t at : order) ordered.push_back(edges_[at]);
  edges_ = std::move(ordered);
}

void EdgeTree::add(const Ring& ring, const Point& origin) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges_.push_back({ring[i] - origin, ring[i + 1 == ring.size() ? 0 : i + 1] - origin});
}

void EdgeTree::build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t count) {
  const std::size_t here = nodes_.size();
  if (count == 1) {
    const Edge& edge = edges_[order[first]];
    nodes_.push_back({box_of(edge), first, 1, edge, 0});
    return;
  }
  nodes_.push_back({Box{Point::Zero(), Point::Zero()}, first, count});
  find_chord(order, nodes_[here]);
  const auto begin = order.begin() + first, end = begin + count, middle = begin + count / 2;
  Box centres{Point::Constant(infinity), Point::Constant(-infinity)};
  for (auto at = begin; at != end; ++at) {
    const Point sum = edges_[*at].from + edges_[*at].to;
    centres = {centres.lower.cwiseMin(sum), centres.upper.cwiseMax(sum)};
  }
  const Point extent = centres.upper - centres.lower;
  const Eigen::Index axis = extent.x() >= extent.y() ? 0 : 1;
  // No two edges tie: which of them a half gets does not depend on the C++ library.
  const auto place = [&](std::uint32_t at) {
    const Edge& edge = edges_[at];
    return std::tuple(edge.from[axis] + edge.to[axis], edge.from.x(), edge.from.y(), edge.to.x(), edge.to.y(),
                      at);
  };
  std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  build(order, first, count / 2);
  build(order, first + count / 2, count - count / 2);
  const auto index = static_cast<std::uint32_t>(here);
  nodes_[here].box = hull_of(nodes_[left(index)].box, nodes_[right(index)].box);
}

/// Before the edges are put in their order: `order` says which they are.
void EdgeTree::find_chord(const std::vector<std::uint32_t>& order, Node& node) const {
  const auto begin = order.begin() + node.first_edge, end = begin + node.edges;
  const auto [first, last] = std::minmax_element(begin, end);
  node.chord = {edges_[*first].from, edges_[*last].to};
  if (*last - *first + 1 != node.edges) return;
  double farthest = 0, magnitude = 0;
  for (std::uint32_t at = *first; at < *last; ++at) {
    const Point& joint = edges_[at].to;
    if (joint != edges_[at + 1].from) return;  // another ring begins
    farthest = std::max(farthest, squared_distance(joint, node.chord.from, node.chord.to));
    magnitude = std::max(magnitude, joint.cwiseAbs().maxCoeff());
  }
  node.stray = std::sqrt(farthest) * (1 + slack::rounding) + slack::rounding * magnitude;
}

bool EdgeTree::winds_around(const Point& point) const {
  int winding = 0;
  const auto on_ray = [&](const Box& box) {
    return box.lower.y() <= point.y() && point.y() <= box.upper.y() && point.x() <= box.upper.x();
  };
  for_each_edge(*this, on_ray, [&](const Edge& edge) {
    const bool up = edge.from.y() <= point.y() && point.y() < edge.to.y();
    const bool down = edge.to.y() <= point.y() && point.y() < edge.from.y();
    if (!up && !down) return;
    const double turn = cross(edge.to - edge.from, point - edge.from);
    if (up && turn > 0) ++winding;
    if (down && turn < 0) --winding;
  });
  return winding != 0;
}

double EdgeTree::magnitude() const {
  if (empty()) return 0;
  const Box& box = nodes_.front().box;
  return std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
}

}  // namespace kempe
