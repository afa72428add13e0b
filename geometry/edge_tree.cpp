#include "geometry/edge_tree.hpp"

#include <algorithm>
#include <tuple>

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
  build(0, static_cast<std::uint32_t>(edges_.size()));
}

void EdgeTree::add(const Ring& ring, const Point& origin) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges_.push_back({ring[i] - origin, ring[i + 1 == ring.size() ? 0 : i + 1] - origin});
}

void EdgeTree::build(std::uint32_t first, std::uint32_t count) {
  const std::size_t here = nodes_.size();
  nodes_.push_back({box_of(edges_[first]), first, count});
  if (count == 1) return;
  const auto begin = edges_.begin() + first, end = begin + count, middle = begin + count / 2;
  Box centres{Point::Constant(std::numeric_limits<double>::infinity()),
              Point::Constant(-std::numeric_limits<double>::infinity())};
  for (auto edge = begin; edge != end; ++edge) {
    const Point sum = edge->from + edge->to;
    centres = {centres.lower.cwiseMin(sum), centres.upper.cwiseMax(sum)};
  }
  const Point extent = centres.upper - centres.lower;
  const Eigen::Index axis = extent.x() >= extent.y() ? 0 : 1;
  // No two edges tie: which of them a half gets does not depend on the C++ library.
  const auto place = [axis](const Edge& edge) {
    return std::tuple(edge.from[axis] + edge.to[axis], edge.from.x(), edge.from.y(), edge.to.x(),
                      edge.to.y());
  };
  std::nth_element(begin, middle, end, [&](const Edge& a, const Edge& b) { return place(a) < place(b); });
  build(first, count / 2);
  build(first + count / 2, count - count / 2);
  const auto index = static_cast<std::uint32_t>(here);
  nodes_[here].box = hull_of(nodes_[left(index)].box, nodes_[right(index)].box);
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
