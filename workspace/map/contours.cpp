// Marching squares on a grid of bearing and distance. Each cell gives the polygon of its part above the
// level; sides that two cells share cancel, and what is left is chained. Points are named by the grid, so
// that neighbours agree exactly.

#include "workspace/map/contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "geometry/edge_tree.hpp"

namespace kempe {
namespace {

/// A grid corner (kind 0), or the crossing on the grid line that leaves it along the bearing (1) or the
/// distance (2).
struct Node {
  int bearing, distance, kind;
  // clang-tidy 14 takes the 0 of what follows for a pointer. NOLINTNEXTLINE(modernize-use-nullptr)
  auto operator<=>(const Node&) const = default;
};

/// Sides of an outline, from node to node.
using Sides = std::set<std::pair<Node, Node>>;

class Sheet {
 public:
  Sheet(const Annulus& annulus, const std::function<double(const Point&)>& quantity, const ContourGrid& grid)
      : annulus_(annulus), grid_(grid) {
    for (int d = 0; d <= grid.distances; ++d)
      for (int b = 0; b < grid.bearings; ++b) {
        const double value = quantity(corner(b, d));
        values_.push_back(std::isfinite(value) ? value : -std::numeric_limits<double>::infinity());
      }
  }

  Region above(double level) const {
    Sides sides;
    for (int d = 0; d < grid_.distances; ++d)
      for (int b = 0; b < grid_.bearings; ++b) add_cell(sides, b, d, level);
    return nested(chained(sides, level));
  }

 private:
  int wrapped(int bearing) const { return bearing == grid_.bearings ? 0 : bearing; }
  double value(int b, int d) const {
    return values_[static_cast<std::size_t>(d) * static_cast<std::size_t>(grid_.bearings) +
                   static_cast<std::size_t>(wrapped(b))];
  }
  Point corner(double b, double d) const {
    const double radius = annulus_.inner + (annulus_.outer - annulus_.inner) * d / grid_.distances;
    return annulus_.centre + as_point(std::polar(radius, 2 * pi * b / grid_.bearings));
  }

  /// A side of a cell's polygon; the same side run the other way by the neighbour takes it out again.
  static void add_side(Sides& sides, const Node& from, const Node& to) {
    if (sides.erase({to, from}) == 0) sides.emplace(from, to);
  }

  /// The part of a cell above the level: corners above, and crossings between corners on different sides, in
  /// order.
  void add_cell(Sides& sides, int b, int d, double level) const {
    // Counter-clockwise in the plane: outwards first, then on along the bearing.
    const int right = wrapped(b + 1);
    const Node corners[4] = {{b, d, 0}, {b, d + 1, 0}, {right, d + 1, 0}, {right, d, 0}};
    const Node crossings[4] = {{b, d, 2}, {b, d + 1, 1}, {right, d, 2}, {b, d, 1}};
    bool above[4];
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double here = value(corners[i].bearing, corners[i].distance);
      above[i] = here >= level;
      sum += here;
    }
    if (above[0] == above[2] && above[1] == above[3] && above[0] != above[1] && !(sum >= 4 * level)) {
      // A saddle below the level: the corners above are apart.
      for (int i = 0; i < 4; ++i)
        if (above[i]) add_polygon(sides, {crossings[(i + 3) % 4], corners[i], crossings[i]});
      return;
    }
    std::vector<Node> polygon;
    for (int i = 0; i < 4; ++i) {
      if (above[i]) polygon.push_back(corners[i]);
      if (above[i] != above[(i + 1) % 4]) polygon.push_back(crossings[i]);
    }
    add_polygon(sides, polygon);
  }
  static void add_polygon(Sides& sides, const std::vector<Node>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      add_side(sides, polygon[i], polygon[(i + 1) % polygon.size()]);
  }

  Point place(const Node& node, double level) const {
    if (node.kind == 0) return corner(node.bearing, node.distance);
    const int b = node.bearing + (node.kind == 1), d = node.distance + (node.kind == 2);
    const double here = value(node.bearing, node.distance), there = value(b, d);
    double share = (level - here) / (there - here);
    if (!std::isfinite(share)) share = std::isfinite(here) ? 0 : 1;  // next to a place without a value
    share = std::clamp(share, 1e-9, 1 - 1e-9);                       // no two crossings in one point
    return corner(node.bearing + share * (node.kind == 1), node.distance + share * (node.kind == 2));
  }

  std::vector<Ring> chained(Sides& sides, double level) const {
    std::vector<Ring> rings;
    while (!sides.empty()) {
      Ring ring;
      for (auto at = sides.begin(); at != sides.end();) {
        ring.push_back(place(at->first, level));
        const Node onward = at->second;
        sides.erase(at);
        at = sides.lower_bound({onward, Node{-1, -1, -1}});
        if (at != sides.end() && at->first != onward) at = sides.end();
      }
      if (ring.size() > 2) rings.push_back(std::move(ring));
    }
    return rings;
  }

  /// Each hole to the smallest outer ring around it.
  static Region nested(std::vector<Ring> rings) {
    Region region;
    std::vector<Ring> holes;
    for (Ring& ring : rings) {
      if (signed_area(ring) > 0) {
        region.polygons.push_back({std::move(ring), {}});
      } else {
        holes.push_back(std::move(ring));
      }
    }
    std::sort(region.polygons.begin(), region.polygons.end(),
              [](const Polygon& a, const Polygon& b) { return signed_area(a.outer) < signed_area(b.outer); });
    for (Ring& hole : holes)
      for (Polygon& polygon : region.polygons)
        if (signed_area(polygon.outer) > -signed_area(hole) &&
            EdgeTree(Polygon{polygon.outer, {}}, Point::Zero()).winds_around(hole.front())) {
          polygon.holes.push_back(std::move(hole));
          break;
        }
    return region;
  }

  Annulus annulus_;
  ContourGrid grid_;
  std::vector<double> values_;
};

}  // namespace

std::vector<ContourBand> contours(const Annulus& annulus, const std::function<double(const Point&)>& quantity,
                                  const std::vector<double>& levels, const ContourGrid& grid) {
  if (annulus.empty() || grid.bearings < 3 || grid.distances < 1) return {};
  const Sheet sheet(annulus, quantity, grid);
  std::vector<ContourBand> bands;
  for (const double level : levels) bands.push_back({level, sheet.above(level)});
  return bands;
}

std::vector<TransmissionBand> transmission_contours(const CopyingLinkage& linkage,
                                                    const std::vector<double>& levels) {
  std::vector<TransmissionBand> bands;
  for (const double level : levels) bands.push_back({level, as_region(usable_annulus(linkage, level))});
  return bands;
}

}  // namespace kempe
