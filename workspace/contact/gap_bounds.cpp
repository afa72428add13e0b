#include "workspace/contact/gap_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/segment_distance.hpp"
#include "geometry/slack.hpp"

namespace kempe {

MovingHull::MovingHull(const MovingJoints& joints, const PointHull& hull, const HalfSides& half)
    : corners_{}, size_(static_cast<std::size_t>(hull.count)), half_(half), reach_(0) {
  for (std::size_t i = 0; i < size_; ++i) {
    corners_[i] = &joints.of(hull.points[i]);
    reach_ = std::max(reach_, corners_[i]->reach);
  }
}

namespace {

/// The nearest points of a hull and an edge: the hull's lies `share` of the way from corner `from` to corner
/// `to`.
struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  std::size_t from = 0, to = 0;
  double share = 0;
  Point apart = Point::Zero();  ///< hull's point - edge's point
};

/// The nearest points of an edge and the hull's side between two corners, unless `nearest` is nearer.
void take_side(Nearest& nearest, const MovingHull& hull, std::size_t one, std::size_t other,
               const EdgeTree::Edge& edge) {
  const Point &a = hull[one].at, &b = hull[other].at, &c = edge.from, &d = edge.to;
  const Point ab = b - a, cd = d - c, ca = a - c, cb = b - c, da = a - d;
  const double cd_ca = cross(cd, ca), cd_cb = cross(cd, cb);
  if (cd_ca * cd_cb < 0 && cross(ab, ca) * cross(ab, da) < 0) {  // they cross
    nearest = {0, one, other, cd_ca / (cd_ca - cd_cb), Point::Zero()};
    return;
  }
  const auto inverse = [](double squared) {  // of a point, or nearly one: 0, which takes its first end
    return squared > std::numeric_limits<double>::min() ? 1 / squared : 0;
  };
  const double per_ab = inverse(ab.squaredNorm()), per_cd = inverse(cd.squaredNorm());
  const auto share = [](double of_way) { return std::clamp(of_way, 0.0, 1.0); };
  // Sides that do not cross are nearest at an end of one of them.
  const std::array<double, 4> shares{0, 1, share(-ca.dot(ab) * per_ab), share(-da.dot(ab) * per_ab)};
  const std::array<Point, 4> apart{ca - share(ca.dot(cd) * per_cd) * cd, cb - share(cb.dot(cd) * per_cd) * cd,
                                   ca + shares[2] * ab, da + shares[3] * ab};
  std::size_t least = 0;
  std::array<double, 4> squared;
  for (std::size_t i = 0; i < 4; ++i) {
    squared[i] = apart[i].squaredNorm();
    if (squared[i] < squared[least]) least = i;
  }
  if (squared[least] < nearest.squared) nearest = {squared[least], one, other, shares[least], apart[least]};
}

Nearest nearest_points(const MovingHull& hull, const EdgeTree::Edge& edge) {
  Nearest nearest;
  if (hull.size() == 1) {
    const Point& at = hull[0].at;
    nearest.apart = at - (edge.from + nearest_share(at, edge.from, edge.to) * (edge.to - edge.from));
    nearest.squared = nearest.apart.squaredNorm();
    return nearest;
  }
  take_side(nearest, hull, 0, 1, edge);
  if (hull.size() == 2) return nearest;
  take_side(nearest, hull, 1, 2, edge);
  take_side(nearest, hull, 2, 0, edge);
  if (inside({{hull[0].at, hull[1].at, hull[2].at}, 3}, edge.from)) nearest.squared = 0;
  return nearest;
}

/// n.dz/dt for a joint that turns about the origin.
double turning_along(const Point& normal, const Point& at) { return cross(at, normal); }

struct Lower {
  double distance, by_opening, by_bearing;
};

Lower separation(const MovingHull& hull, const EdgeTree::Edge& edge, const Point& normal) {
  Lower least{std::numeric_limits<double>::infinity(), 0, 0};
  const double edge_side = std::max(normal.dot(edge.from), normal.dot(edge.to));
  for (std::size_t corner = 0; corner < hull.size(); ++corner) {
    const MovingJoint& joint = hull[corner];
    const double by_opening = std::abs(normal.dot(joint.by_opening)) * hull.half().opening;
    const double by_bearing = std::abs(turning_along(normal, joint.at)) * hull.half().bearing;
    const double distance = normal.dot(joint.at) - edge_side - by_opening - by_bearing - joint.rest;
    if (distance < least.distance) least = {distance, by_opening, by_bearing};
  }
  return least;
}

/// A lower bound of the distance between an edge and the line through the hull's nearest side, on whose other side the hull lies (see the
/// header). `normal` points from the edge to the side.
double beside_line(const MovingHull& hull, const Nearest& nearest, const EdgeTree::Edge& edge,
                   const Point& normal) {
  const MovingJoint &a = hull[nearest.from], &b = hull[nearest.to];
  const auto [half_opening, half_bearing] = hull.half();
  const Point along = b.at - a.at;
  const double length = along.norm();
  const Point u = along / length, left = left_of(u), n = left.dot(normal) < 0 ? Point(-left) : left;
  const Point opened = half_opening * a.by_opening, turned = half_bearing * left_of(a.at);
  const Point opens = half_opening * (b.by_opening - a.by_opening), turns = half_bearing * left_of(along);
  const double rests = a.rest + b.rest;
  const double longer = std::abs(u.dot(opens)) + std::abs(u.dot(turns)) + rests;
  const double tilted = opens.norm() + turns.norm() + rests;
  double least = infinity;
  for (const Point& end : {edge.from, edge.to}) {
    const Point from_end = a.at - end;
    const double beside = n.dot(from_end), share = -u.dot(from_end) / length;
    const Point by_opening = opened + share * opens, by_bearing = turned + share * turns;
    const double rest = std::abs(1 - share) * a.rest + std::abs(share) * b.rest;
    const double moved = by_opening.norm() + by_bearing.norm() + rest;
    const double nearer = std::abs(n.dot(by_opening)) + std::abs(n.dot(by_bearing)) + rest;
    const double rounded = slack::rounding * (a.far + b.far + end.norm()) * (1 + from_end.norm() / length);
    least =
        std::min(least, beside - nearer - (std::abs(beside) * longer + tilted * moved) / length - rounded);
  }
  return least > 0 ? least * length / std::hypot(length + longer, tilted) : least;
}

/// True if the hull's nearest point lies within a side that all of the hull is on one side of: it stays so, as a hull's corners are points
/// of one link.
bool is_beside(const MovingHull& hull, const Nearest& nearest, const Point& normal) {
  if (hull.size() == 1 || !(nearest.share > 0 && nearest.share < 1)) return false;
  return hull.size() == 2 || normal.dot(hull[3 - nearest.from - nearest.to].at - hull[nearest.from].at) >= 0;
}

/// How far the hull's nearest point moves along the normal and across it.
struct Straying {
  double along, across;
};

Straying straying(const MovingHull& hull, const Nearest& nearest, const Point& normal) {
  const MovingJoint &a = hull[nearest.from], &b = hull[nearest.to];
  const auto [opening, bearing] = hull.half();
  const double t = nearest.share;
  const Point velocity = (1 - t) * a.by_opening + t * b.by_opening;
  const Point at = (1 - t) * a.at + t * b.at;
  const double rest = std::max(a.rest, b.rest);
  return {std::abs(normal.dot(velocity)) * opening + std::abs(turning_along(normal, at)) * bearing + rest,
          std::abs(cross(normal, velocity)) * opening + std::abs(normal.dot(at)) * bearing + rest};
}

/// Bounds where the axes cross in the middle: no normal tells which motion counts.
GapBounds overlapping(const MovingHull& hull) {
  double by_opening = 0, by_bearing = 0;
  for (std::size_t corner = 0; corner < hull.size(); ++corner) {
    by_opening = std::max(by_opening, hull[corner].speed * hull.half().opening);
    by_bearing = std::max(by_bearing, hull[corner].far * hull.half().bearing);
  }
  return {0, hull.reach(), 0, by_opening, by_bearing};
}

/// The closest upper bound only if that may lie below what is asked; the closest lower one only if no plainer one reaches it.
GapBounds close_bounds(const MovingHull& hull, const EdgeTree::Edge& edge, const Nearest& nearest,
                       double distance, const GapQuestion& question) {
  if (!(distance > 0)) return overlapping(hull);
  const Point normal = nearest.apart / distance;
  Lower lower = separation(hull, edge, normal);
  if (lower.distance < question.lower_from && is_beside(hull, nearest, normal))
    lower.distance = std::max(lower.distance, beside_line(hull, nearest, edge, normal));
  double upper = distance + hull.reach();
  if (distance < question.upper_below) {
    const Straying stray = straying(hull, nearest, normal);
    const double along = distance + stray.along;
    upper = std::min(upper, std::sqrt(along * along + stray.across * stray.across));
  }
  return {std::max({lower.distance, distance - hull.reach(), 0.0}), upper, distance, lower.by_opening,
          lower.by_bearing};
}

}  // namespace

GapBounds bounds_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge) {
  const Nearest nearest = nearest_points(hull, edge);
  return close_bounds(hull, edge, nearest, std::sqrt(nearest.squared), {infinity, infinity});
}

GapBounds bounds_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge, const GapQuestion& question) {
  const Nearest nearest = nearest_points(hull, edge);
  const double distance = std::sqrt(nearest.squared);
  if (distance + hull.reach() < question.upper_below || distance - hull.reach() >= question.lower_from)
    return {std::max(distance - hull.reach(), 0.0), distance + hull.reach(), distance, 0, 0};
  return close_bounds(hull, edge, nearest, distance, question);
}

double distance_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge) {
  return std::sqrt(nearest_points(hull, edge).squared);
}

BoxDistance::BoxDistance(const MovingHull& hull) : own_{hull[0].at, hull[0].at} {
  for (std::size_t corner = 1; corner < hull.size(); ++corner) {
    const Point& at = hull[corner].at;
    own_ = {own_.lower.cwiseMin(at), own_.upper.cwiseMax(at)};
  }
  if (hull.size() != 2) return;
  start_ = hull[0].at;
  const Point along = hull[1].at - start_;
  const double length = along.norm();
  if (!(length > 0)) return;
  is_segment_ = true;
  normal_ = Point(-along.y() / length, along.x() / length);
}

}  // namespace kempe
