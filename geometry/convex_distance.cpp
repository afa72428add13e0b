#include "geometry/convex_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kempe {
namespace {

std::size_t edge_count(ConvexCorners set) { return set.size() > 2 ? set.size() : set.size() - 1; }

Complex next(ConvexCorners set, std::size_t i) { return set[i + 1 == set.size() ? 0 : i + 1]; }

/// Side of its edges on which a polygon does not lie; 0 for a segment, which has two free sides.
double free_side(ConvexCorners set) {
  if (set.size() < 3) return 0;
  double area = 0;
  for (std::size_t i = 1; i + 1 < set.size(); ++i) area += cross(set[i] - set[0], set[i + 1] - set[0]);
  return area > 0 ? -1 : 1;
}

/// The widest separation along the normals of `edges`' edges.
void separate(ConvexCorners edges, ConvexCorners corners, bool corner_of_first, NearestFeatures& best) {
  const double outward = free_side(edges);
  for (std::size_t i = 0; i < edge_count(edges); ++i) {
    const Complex edge = next(edges, i) - edges[i];
    const double length =
        std::sqrt(std::norm(edge));  // lengths of links are far from overflow: no need of hypot
    if (!(length > 0)) continue;
    const Complex along = edge / length;
    for (const double side : {1.0, -1.0}) {
      if (outward * side < 0) continue;
      NearestFeatures here{infinity, corner_of_first, 0, i, (i + 1) % edges.size(), true, side};
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const double height = side * cross(along, corners[j] - edges[i]);
        if (height < here.distance) here.distance = height, here.corner = j;
      }
      if (here.distance > best.distance) best = here;
    }
  }
}

/// Share of a separation: by more no distance is smaller than it, whatever was rounded.
constexpr double separation_rounding = 1e-12;

/// True if two sets with this widest separation overlap. Of two segments in one line it is 0 but for rounding, however far apart they
/// are: there is no edge across the line.
bool overlap(ConvexCorners first, ConvexCorners second, double widest) {
  if (!(widest < 0) || widest == -infinity) return false;
  if (first.size() > 2 || second.size() > 2) return true;
  double extent = 0;
  for (const ConvexCorners& set : {first, second})
    for (const Complex& corner : set) extent = std::max(extent, std::abs(corner - first[0]));
  return widest < -separation_rounding * extent;
}

/// The smallest distance of `corners` from the corners and edges of `edges`; squared in `best` on the way.
void approach(ConvexCorners edges, ConvexCorners corners, bool corner_of_first, NearestFeatures& best) {
  for (std::size_t j = 0; j < corners.size(); ++j)
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double squared = std::norm(corners[j] - edges[i]);
      if (squared < best.distance) best = {squared, corner_of_first, j, i, i, false, 1};
    }
  for (std::size_t i = 0; i < edge_count(edges); ++i) {
    const Complex edge = next(edges, i) - edges[i];
    const double length_squared = std::norm(edge);
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const Complex to_corner = corners[j] - edges[i];
      const double along = dot(edge, to_corner);
      if (along <= 0 || along >= length_squared) continue;
      const double product = cross(edge, to_corner), squared = product * product / length_squared;
      if (squared < best.distance)
        best = {squared, corner_of_first, j, i, (i + 1) % edges.size(), true, product < 0 ? -1.0 : 1.0};
    }
  }
}

}  // namespace

NearestFeatures nearest_features(ConvexCorners first, ConvexCorners second) {
  NearestFeatures best{.distance = -infinity};
  separate(first, second, false, best);
  separate(second, first, true, best);
  if (best.is_edge && overlap(first, second, best.distance)) return best;
  best = {.distance = infinity};
  approach(first, second, false, best);
  approach(second, first, true, best);
  best.distance = std::sqrt(best.distance);
  return best;
}

namespace {

bool is_beyond(double separation, double enough) {
  return separation - separation_rounding * std::abs(separation) > enough;
}

/// The direction of a set's edge, of size 1; 0 if the edge has no length.
Complex direction_of(ConvexCorners set, std::size_t edge) {
  const Complex along = next(set, edge) - set[edge];
  const double length = std::sqrt(std::norm(along));
  return length > 0 ? along / length : 0;
}

/// The wider of `widest` and the separations along the normals of `edges`' edges; the first one beyond `enough`, if any is.
template <typename DirectionOf>
double separation(ConvexCorners edges, double free_side, const DirectionOf& direction_of,
                  ConvexCorners corners, double widest, double enough) {
  for (std::size_t i = 0; i < edge_count(edges); ++i) {
    const Complex along = direction_of(i);
    if (along == 0.0) continue;
    double lowest = infinity, highest = -infinity;
    for (const Complex& corner : corners) {
      const double height = cross(along, corner - edges[i]);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    if (free_side >= 0) widest = std::max(widest, lowest);
    if (free_side <= 0) widest = std::max(widest, -highest);
    if (is_beyond(widest, enough)) return widest;
  }
  return widest;
}

double separation(ConvexCorners edges, ConvexCorners corners, double widest, double enough) {
  const auto direction = [&](std::size_t i) { return direction_of(edges, i); };
  return separation(edges, free_side(edges), direction, corners, widest, enough);
}

/// Of two sets that are apart.
double squared_apart(ConvexCorners first, ConvexCorners second) {
  double least = infinity;
  for (const Complex& one : first)
    for (const Complex& other : second) least = std::min(least, std::norm(one - other));
  const auto beside_edges = [&](ConvexCorners edges, ConvexCorners corners) {
    for (std::size_t i = 0; i < edge_count(edges); ++i) {
      const Complex edge = next(edges, i) - edges[i];
      const double length_squared = std::norm(edge);
      for (const Complex& corner : corners) {
        const Complex to_corner = corner - edges[i];
        const double along = dot(edge, to_corner);
        if (along <= 0 || along >= length_squared) continue;
        const double product = cross(edge, to_corner);
        least = std::min(least, product * product / length_squared);
      }
    }
  };
  beside_edges(first, second);
  beside_edges(second, first);
  return least;
}

/// The distance of two sets whose widest separation is known.
double with_separation(ConvexCorners first, ConvexCorners second, double widest, double enough) {
  if (is_beyond(widest, enough) || overlap(first, second, widest)) return widest;
  return std::sqrt(squared_apart(first, second));
}

}  // namespace

double convex_distance(ConvexCorners first, ConvexCorners second, double enough) {
  double widest = separation(first, second, -infinity, enough);
  if (is_beyond(widest, enough)) return widest;
  widest = separation(second, first, widest, enough);
  return with_separation(first, second, widest, enough);
}

FixedConvex::FixedConvex(std::vector<Complex> corners)
    : corners_(std::move(corners)), free_side_(kempe::free_side(corners_)) {
  for (std::size_t i = 0; i < edge_count(corners_); ++i) directions_.push_back(direction_of(corners_, i));
}

double convex_distance(ConvexCorners moving, const FixedConvex& fixed, double enough) {
  const auto direction = [&](std::size_t i) { return fixed.directions()[i]; };
  double widest = separation(fixed.corners(), fixed.free_side(), direction, moving, -infinity, enough);
  if (is_beyond(widest, enough)) return widest;
  widest = separation(moving, fixed.corners(), widest, enough);
  return with_separation(moving, fixed.corners(), widest, enough);
}

double distance_from(Complex point, ConvexCorners set) {
  const double outward = free_side(set);
  double least_squared = std::norm(point - set[0]), highest = -infinity;
  for (std::size_t i = 0; i < edge_count(set); ++i) {
    const Complex edge = next(set, i) - set[i], to_point = point - set[i];
    const double length_squared = std::norm(edge);
    if (!(length_squared > 0)) continue;
    const double share = std::clamp(dot(edge, to_point) / length_squared, 0.0, 1.0);
    least_squared = std::min(least_squared, std::norm(to_point - share * edge));
    if (set.size() > 2)
      highest = std::max(highest, outward * cross(edge, to_point) / std::sqrt(length_squared));
  }
  return highest < 0 && highest > -infinity ? highest : std::sqrt(least_squared);
}

}  // namespace kempe
