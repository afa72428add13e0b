// Distance of straight-edged regions: a tree of boxes and doubles first, exact arithmetic where they cannot
// tell.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/edge_tree.hpp"
#include "geometry/regions/region_algebra.hpp"
#include "geometry/segment_distance.hpp"
#include "geometry/slack.hpp"

namespace kempe {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Visit>
void for_each_ring(const Region& region, Visit visit) {
  for (const Polygon& polygon : region.polygons) {
    visit(polygon.outer);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
}

Box box_of(const EdgeTree::Edge& edge) { return {edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)}; }

/// Calls visit(edge of one, edge of other) for the pairs whose boxes are nearer than `near()`.
template <class Near, class Visit>
void for_near_pairs(const Region& one, const EdgeTree& other, Near near, Visit visit) {
  for_each_ring(one, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const EdgeTree::Edge edge{ring[i], ring[(i + 1) % ring.size()]};
      const Box box = box_of(edge);
      for_each_edge(
          other, [&](const Box& there) { return distance(box, there) <= near(); },
          [&](const EdgeTree::Edge& there) { visit(edge, there); });
    }
  });
}

/// Nearest points of two segments that do not cross.
void offer(NearestPlaces& best, const EdgeTree::Edge& one, const EdgeTree::Edge& other) {
  const auto offer_pair = [&](const Point& a, const Point& b) {
    if (const double here = (a - b).norm(); here < best.distance) best = {here, a, b};
  };
  const auto on = [](const EdgeTree::Edge& edge, const Point& point) -> Point {
    return edge.from + nearest_share(point, edge.from, edge.to) * (edge.to - edge.from);
  };
  if (properly_cross(one.from, one.to, other.from, other.to)) {
    const Point along = one.to - one.from, across = other.to - other.from;
    const Point meeting = one.from + cross(other.from - one.from, across) / cross(along, across) * along;
    best = {0, meeting, meeting};
    return;
  }
  for (const Point& end : {one.from, one.to}) offer_pair(end, on(other, end));
  for (const Point& end : {other.from, other.to}) offer_pair(on(one, end), end);
}

/// A corner of one region inside the other and no nearer than `depth` to its edges: then they overlap though no edges
/// cross.
std::optional<Point> corner_inside(const Region& one, const Region& other, double depth = 0) {
  std::optional<Point> found;
  const EdgeTree tree(other, Point::Zero());
  const auto is_deep = [&](const Point& corner) {
    bool deep = true;
    for_each_edge(
        tree,
        [&](const Box& box) {
          return deep && distance(box, {corner, corner}) < depth;
        },
        [&](const EdgeTree::Edge& edge) { deep = deep && distance(corner, edge.from, edge.to) >= depth; });
    return deep;
  };
  for_each_ring(one, [&](const Ring& ring) {
    if (!found && tree.winds_around(ring.front()) && is_deep(ring.front())) found = ring.front();
  });
  return found;
}

Kernel::Segment_2 exact_segment(const EdgeTree::Edge& edge) {
  return {{edge.from.x(), edge.from.y()}, {edge.to.x(), edge.to.y()}};
}

/// Edges of the two cross, exactly: then their interiors meet beside the crossing.
bool boundaries_cross(const Region& one, const Region& other) {
  const EdgeTree tree(other, Point::Zero());
  const auto parts = [](const EdgeTree::Edge& edge, const EdgeTree::Edge& ends) {
    const Kernel::Segment_2 along = exact_segment(edge), across = exact_segment(ends);
    const auto left = [&](const Kernel::Point_2& end) {
      return CGAL::orientation(along.source(), along.target(), end);
    };
    return left(across.source()) * left(across.target()) < 0;
  };
  bool cross = false;
  for_near_pairs(
      one, tree, [&] { return cross ? -1.0 : 0.0; },
      [&](const EdgeTree::Edge& a, const EdgeTree::Edge& b) {
        cross = cross || (parts(a, b) && parts(b, a));
      });
  return cross;
}

/// No two edges are nearer than `gap`, exactly.
bool edges_are_apart(const Region& one, const Region& other, double gap, double slack) {
  const EdgeTree tree(other, Point::Zero());
  const Kernel::FT squared = Kernel::FT(gap) * Kernel::FT(gap);
  bool apart = true;
  for_near_pairs(
      one, tree, [&] { return apart ? gap + slack : -1.0; },
      [&](const EdgeTree::Edge& a, const EdgeTree::Edge& b) {
        if (CGAL::squared_distance(exact_segment(a), exact_segment(b)) < squared) apart = false;
      });
  return apart;
}

}  // namespace

std::optional<NearestPlaces> nearest_places(const Region& one, const Region& other) {
  if (one.empty() || other.empty()) return std::nullopt;
  if (const auto corner = corner_inside(one, other)) return NearestPlaces{0, *corner, *corner};
  if (const auto corner = corner_inside(other, one)) return NearestPlaces{0, *corner, *corner};
  const EdgeTree tree(other, Point::Zero());
  NearestPlaces best{std::numeric_limits<double>::infinity(), Point::Zero(), Point::Zero()};
  for_near_pairs(
      one, tree,
      [&] { return best.distance > 0 ? best.distance : -1.0; },  // nothing is nearer than a crossing
      [&](const EdgeTree::Edge& a, const EdgeTree::Edge& b) { offer(best, a, b); });
  return best;
}

std::optional<NearestPlaces> nearest_edges(const EdgeTree& one, const EdgeTree& other, double enough) {
  if (one.empty() || other.empty()) return std::nullopt;
  NearestPlaces best{enough, Point::Zero(), Point::Zero()};
  const bool one_is_smaller = one.node(0).edges <= other.node(0).edges;
  const EdgeTree &few = one_is_smaller ? one : other, &many = one_is_smaller ? other : one;
  for (std::uint32_t i = 0; i < few.node(0).edges && best.distance > 0; ++i) {
    const EdgeTree::Edge& edge = few.edge(i);
    const Box box = box_of(edge);
    for_each_edge(
        many, [&](const Box& there) { return best.distance > 0 && distance(box, there) < best.distance; },
        [&](const EdgeTree::Edge& there) {
          one_is_smaller ? offer(best, edge, there) : offer(best, there, edge);
        });
  }
  return best.distance < enough ? std::optional(best) : std::nullopt;
}

bool are_apart(const Region& one, const Region& other, double gap) {
  const auto nearest = nearest_places(one, other);
  if (!nearest) return true;
  const double size = std::max(
      {std::abs(gap), EdgeTree(one, Point::Zero()).magnitude(), EdgeTree(other, Point::Zero()).magnitude()});
  const double slack = slack::rounding * size;  // below it exact arithmetic decides
  if (nearest->distance > gap + slack) return true;
  if (nearest->distance < gap - slack) return false;
  if (gap > slack) return edges_are_apart(one, other, gap, slack);
  // Interiors must be disjoint: a matter of areas, not of distance.
  if (corner_inside(one, other, slack) || corner_inside(other, one, slack) || boundaries_cross(one, other))
    return false;
  return intersection(as_arcs(one), as_arcs(other)).empty() && edges_are_apart(one, other, gap, slack);
}

}  // namespace kempe
