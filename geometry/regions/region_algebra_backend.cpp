// Boolean sets of CGAL behind region_algebra.hpp.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/edge_tree.hpp"
#include "geometry/regions/region_algebra.hpp"

namespace kempe {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Set = CGAL::General_polygon_set_2<Traits>;
using ExactPolygon = Traits::General_polygon_2;
using ExactPolygonWithHoles = Traits::General_polygon_with_holes_2;
using Curve = Traits::Curve_2;
using MonotoneCurve = Traits::X_monotone_curve_2;
using ExactPoint = Kernel::Point_2;

ExactPoint exact(const Point& point) { return {point.x(), point.y()}; }

bool is_circle(const ArcRing& ring) {
  return ring.size() == 2 && std::abs(ring[0].bulge) == 1 && ring[0].bulge == ring[1].bulge;
}

void add_monotone(ExactPolygon& polygon, const Curve& curve) {
  std::vector<CGAL::Object> parts;
  Traits().make_x_monotone_2_object()(curve, std::back_inserter(parts));
  for (const CGAL::Object& part : parts) polygon.push_back(CGAL::object_cast<MonotoneCurve>(part));
}

void add_circle(ExactPolygon& polygon, const ArcRing& ring) {
  const ExactPoint a = exact(ring[0].at), b = exact(ring[1].at);
  const auto orientation = ring[0].bulge > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE;
  add_monotone(polygon,
               Curve(Kernel::Circle_2(CGAL::midpoint(a, b), CGAL::squared_distance(a, b) / 4, orientation)));
}

void add_edge(ExactPolygon& polygon, const Point& from, const Point& to, double bulge) {
  if (from == to) return;
  // The arc's middle lies bulge/2 of the chord beside the chord's middle, to its right for an arc to the
  // left.
  const Point chord = to - from;
  const Point middle = 0.5 * (from + to) + 0.5 * bulge * Point(chord.y(), -chord.x());
  const ExactPoint a = exact(from), b = exact(middle), c = exact(to);
  if (bulge == 0 || CGAL::orientation(a, b, c) == CGAL::COLLINEAR) {
    polygon.push_back(MonotoneCurve(a, c));
  } else {
    add_monotone(polygon, Curve(a, b, c));
  }
}

ExactPolygon exact(const ArcRing& ring) {
  ExactPolygon polygon;
  if (is_circle(ring)) {
    add_circle(polygon, ring);
  } else {
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_edge(polygon, ring[i].at, ring[(i + 1) % ring.size()].at, ring[i].bulge);
  }
  return polygon;
}

/// A ring run in the wanted direction; nothing if it has no area or is not finite.
std::optional<ArcRing> directed(const ArcRing& ring, bool counter_clockwise) {
  const double enclosed = signed_area(ring);
  if (!std::isfinite(enclosed) || enclosed == 0) return std::nullopt;
  return (enclosed > 0) == counter_clockwise ? ring : reversed(ring);
}

std::optional<ExactPolygonWithHoles> exact(const ArcPolygon& polygon) {
  const auto outer = directed(polygon.outer, true);
  if (!outer) return std::nullopt;
  ExactPolygonWithHoles result(exact(*outer));
  for (const ArcRing& hole : polygon.holes)
    if (const auto inner = directed(hole, false)) result.add_hole(exact(*inner));
  return result;
}

std::vector<ExactPolygonWithHoles> exact(const ArcRegion& region) {
  std::vector<ExactPolygonWithHoles> result;
  for (const ArcPolygon& polygon : region)
    if (auto one = exact(polygon)) result.push_back(std::move(*one));
  return result;
}

/// A region's polygons have disjoint interiors, but may touch: they are joined.
Set set_of(const ArcRegion& region) {
  const auto polygons = exact(region);
  Set set;
  set.join(polygons.begin(), polygons.end());
  return set;
}

Point rounded(const Traits::Point_2& point) {
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y())};
}

double bulge_of(const MonotoneCurve& curve) {
  if (curve.is_linear()) return 0;
  const double radius = std::sqrt(CGAL::to_double(curve.supporting_circle().squared_radius()));
  const double chord = (rounded(curve.target()) - rounded(curve.source())).norm();
  const double half =
      std::asin(std::min(1.0, 0.5 * chord / radius));  // an x-monotone arc is half a turn at most
  return (curve.orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1) * std::tan(0.5 * half);
}

ArcRing rounded(const ExactPolygon& polygon) {
  ArcRing ring;
  for (auto curve = polygon.curves_begin(); curve != polygon.curves_end(); ++curve)
    ring.push_back({rounded(curve->source()), bulge_of(*curve)});
  return ring;
}

ArcRegion rounded(const Set& set) {
  std::vector<ExactPolygonWithHoles> polygons;
  set.polygons_with_holes(std::back_inserter(polygons));
  ArcRegion region;
  for (const ExactPolygonWithHoles& polygon : polygons) {
    ArcPolygon& result = region.emplace_back();
    result.outer = rounded(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      result.holes.push_back(rounded(*hole));
  }
  return region;
}

bool exactly_contains(const ArcRegion& outer, const ArcRegion& inner) {
  Set rest = set_of(inner);
  rest.difference(set_of(outer));
  return rest.is_empty();
}

/// mm: arcs are followed to this, so boundaries as far apart as four times this keep apart themselves.
constexpr double flat_to = 1e-3;

/// What doubles can tell: the boundaries keep apart, so every ring lies on one side of the other region.
std::optional<bool> surely_contains(const ArcRegion& outer, const ArcRegion& inner) {
  const Region flat_outer = flattened(outer, flat_to, Flatten::shrinks);
  const Region flat_inner = flattened(inner, flat_to, Flatten::grows);
  const auto nearest = [](const Region& one, const Region& other) {
    const EdgeTree tree(other, Point::Zero());
    double least = std::numeric_limits<double>::infinity();
    const auto visit_ring = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const Box box{a.cwiseMin(b), a.cwiseMax(b)};
        for_each_edge(
            tree, [&](const Box& there) { return distance(box, there) < std::min(least, 0.1); },
            [&](const EdgeTree::Edge& edge) {
              least =
                  std::min(least, distance(box, {edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)}));
            });
      }
    };
    for (const Polygon& polygon : one.polygons) {
      visit_ring(polygon.outer);
      for (const Ring& hole : polygon.holes) visit_ring(hole);
    }
    return least;
  };
  if (nearest(flat_inner, flat_outer) < 4 * flat_to) return std::nullopt;
  const EdgeTree outer_tree(flat_outer, Point::Zero()), inner_tree(flat_inner, Point::Zero());
  for (const Polygon& polygon : flat_inner.polygons) {
    if (!outer_tree.winds_around(polygon.outer.front())) return false;
    for (const Ring& hole : polygon.holes)
      if (!outer_tree.winds_around(hole.front())) return false;
  }
  for (const Polygon& polygon : flat_outer.polygons) {
    if (inner_tree.winds_around(polygon.outer.front())) return false;
    for (const Ring& hole : polygon.holes)
      if (inner_tree.winds_around(hole.front())) return false;
  }
  return true;
}

}  // namespace

ArcRegion as_arcs(const Region& region) {
  const auto ring_of = [](const Ring& ring) {
    ArcRing result;
    for (const Point& point : ring) result.push_back({point, 0});
    return result;
  };
  ArcRegion result;
  for (const Polygon& polygon : region.polygons) {
    ArcPolygon& arcs = result.emplace_back(ArcPolygon{ring_of(polygon.outer), {}});
    for (const Ring& hole : polygon.holes) arcs.holes.push_back(ring_of(hole));
  }
  return result;
}

ArcRegion united(const std::vector<ArcRegion>& regions) {
  std::vector<ExactPolygonWithHoles> all;
  for (const ArcRegion& region : regions)
    for (auto& polygon : exact(region)) all.push_back(std::move(polygon));
  Set set;
  set.join(all.begin(), all.end());
  return rounded(set);
}

ArcRegion intersection(const ArcRegion& one, const ArcRegion& other) {
  Set set = set_of(one);
  set.intersection(set_of(other));
  return rounded(set);
}

ArcRegion difference(const ArcRegion& whole, const ArcRegion& taken) {
  Set set = set_of(whole);
  set.difference(set_of(taken));
  return rounded(set);
}

bool contains(const ArcRegion& outer, const ArcRegion& inner) {
  if (inner.empty()) return true;
  if (outer.empty()) return !set_of(inner).is_empty() ? false : true;
  if (const auto sure = surely_contains(outer, inner)) return *sure;
  return exactly_contains(outer, inner);
}

}  // namespace kempe
