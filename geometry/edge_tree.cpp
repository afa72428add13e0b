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

/// Each place gets the edge that `order` says, without a second list: edges of a region may be millions.
void put_in_order(std::vector<EdgeTree::Edge>& edges, std::vector<std::uint32_t> order) {
  for (std::uint32_t first = 0; first < order.size(); ++first) {
    const EdgeTree::Edge kept = edges[first];
    std::uint32_t at = first;
    for (std::uint32_t next = order[at]; next != first; next = order[at]) {
      edges[at] = edges[next];
      order[at] = at;
      at = next;
    }
    edges[at] = kept;
    order[at] = at;
  }
}

std::size_t corners_of(const Polygon& polygon) {
  std::size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
}

}  // namespace

EdgeTree::EdgeTree(const Polygon& polygon, const Point& origin) : EdgeTree(Region{{polygon}}, origin) {}

EdgeTree::EdgeTree(const Region& region, const Point& origin, Chords chords) {
  std::size_t count = 0;
  for (const Polygon& polygon : region.polygons) count += corners_of(polygon);
  edges_.reserve(count);
  for (const Polygon& polygon : region.polygons) {
    add(polygon.outer, origin);
    for (const Ring& hole : polygon.holes) add(hole, origin);
  }
  if (edges_.empty()) return;
  nodes_.reserve(2 * edges_.size() - 1);
  if (chords == Chords::kept) chords_.reserve(2 * edges_.size() - 1);
  std::vector<std::uint32_t> order(edges_.size());  // the edges of nodes by their numbers along the rings
  std::iota(order.begin(), order.end(), 0U);
  build(order, 0, static_cast<std::uint32_t>(edges_.size()), chords);
  put_in_order(edges_, std::move(order));
}

void EdgeTree::add(const Ring& ring, const Point& origin) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges_.push_back({ring[i] - origin, ring[i + 1 == ring.size() ? 0 : i + 1] - origin});
}

void EdgeTree::build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t count,
                     Chords chords) {
  const std::size_t here = nodes_.size();
  nodes_.push_back({box_of(edges_[order[first]]), first, count});
  if (chords == Chords::kept) chords_.push_back(chord_of({order.data() + first, count}));
  if (count == 1) return;
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
  build(order, first, count / 2, chords);
  build(order, first + count / 2, count - count / 2, chords);
  const auto index = static_cast<std::uint32_t>(here);
  nodes_[here].box = hull_of(nodes_[left(index)].box, nodes_[right(index)].box);
}

EdgeTree::Chord EdgeTree::chord_of(std::span<const std::uint32_t> some) const {
  const auto [first, last] = std::minmax_element(some.begin(), some.end());
  Chord chord{edges_[*first], 0};
  if (some.size() == 1) return chord;
  bool follow_each_other = *last - *first + 1 == some.size();
  for (std::uint32_t at = *first; follow_each_other && at < *last; ++at)
    follow_each_other = edges_[at].to == edges_[at + 1].from;  // else another ring begins
  if (follow_each_other) chord.segment.to = edges_[*last].to;
  double farthest = 0, magnitude = 0;
  for (const std::uint32_t at : some)
    for (const Point& corner : {edges_[at].from, edges_[at].to}) {
      farthest = std::max(farthest, squared_distance(corner, chord.segment.from, chord.segment.to));
      magnitude = std::max(magnitude, corner.cwiseAbs().maxCoeff());
    }
  chord.stray = std::sqrt(farthest) * (1 + slack::rounding) + slack::rounding * magnitude;
  return chord;
}

bool EdgeTree::winds_around(const Point& point) const {
  if (empty() || (point.array() < nodes_.front().box.lower.array()).any()) return false;
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
