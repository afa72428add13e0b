#include "workspace/gap_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workspace/segment_distance.hpp"

namespace kempe {
namespace {

/// The nearest points of a hull and an edge: the hull's lies `share` of the way from corner `from` to corner
/// `to`.
struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  std::size_t from = 0, to = 0;
  double share = 0;
  Point apart = Point::Zero();  ///< hull's point - edge's point

  void offer(std::size_t one, std::size_t other, double at, const Point& difference) {
    const double candidate = difference.squaredNorm();
    if (candidate < squared) *this = {candidate, one, other, at, difference};
  }
};

std::size_t index(const JointHull& hull, std::size_t corner) {
  return static_cast<std::size_t>(hull.joints[corner]);
}

void offer_side(Nearest& nearest, const MovingJoints& joints, std::size_t one, std::size_t other,
                const EdgeTree::Edge& edge) {
  const Point &a = joints[one].at, &b = joints[other].at, &c = edge.from, &d = edge.to;
  const Point ab = b - a, cd = d - c, ca = a - c, cb = b - c, da = a - d;
  const double cd_ca = cross(cd, ca), cd_cb = cross(cd, cb);
  if (cd_ca * cd_cb < 0 && cross(ab, ca) * cross(ab, da) < 0) {  // they cross
    nearest.offer(one, other, cd_ca / (cd_ca - cd_cb), Point::Zero());
    return;
  }
  const auto inverse = [](double squared) {  // of a point, or nearly one: 0, which takes its first end
    return squared > std::numeric_limits<double>::min() ? 1 / squared : 0;
  };
  const double per_ab = inverse(ab.squaredNorm()), per_cd = inverse(cd.squaredNorm());
  const auto share = [](double of_way) { return std::clamp(of_way, 0.0, 1.0); };
  nearest.offer(one, other, 0, ca - share(ca.dot(cd) * per_cd) * cd);
  nearest.offer(one, other, 1, cb - share(cb.dot(cd) * per_cd) * cd);
  const double of_c = share(-ca.dot(ab) * per_ab), of_d = share(-da.dot(ab) * per_ab);
  nearest.offer(one, other, of_c, ca + of_c * ab);
  nearest.offer(one, other, of_d, da + of_d * ab);
}

Nearest nearest_points(const MovingJoints& joints, const JointHull& hull, const EdgeTree::Edge& edge) {
  Nearest nearest;
  const std::size_t i = index(hull, 0);
  if (hull.count == 1) {
    const Point& at = joints[i].at;
    nearest.offer(i, i, 0, at - (edge.from + nearest_share(at, edge.from, edge.to) * (edge.to - edge.from)));
    return nearest;
  }
  offer_side(nearest, joints, i, index(hull, 1), edge);
  if (hull.count == 2) return nearest;
  offer_side(nearest, joints, index(hull, 1), index(hull, 2), edge);
  offer_side(nearest, joints, index(hull, 2), i, edge);
  if (inside({{joints[i].at, joints[index(hull, 1)].at, joints[index(hull, 2)].at}, 3}, edge.from))
    nearest.squared = 0;
  return nearest;
}

/// n.dz/dt for a joint that turns about the origin.
double turning_along(const Point& normal, const Point& at) { return cross(at, normal); }

struct Lower {
  double distance, by_opening, by_bearing;
};

Lower separation(const MovingJoints& joints, const JointHull& hull, const EdgeTree::Edge& edge,
                 const Point& normal, const HalfSides& half) {
  Lower least{std::numeric_limits<double>::infinity(), 0, 0};
  const double edge_side = std::max(normal.dot(edge.from), normal.dot(edge.to));
  for (std::size_t corner = 0; corner < static_cast<std::size_t>(hull.count); ++corner) {
    const MovingJoint& joint = joints[index(hull, corner)];
    const double by_opening = std::abs(normal.dot(joint.by_opening)) * half.opening;
    const double by_bearing = std::abs(turning_along(normal, joint.at)) * half.bearing;
    const double distance = normal.dot(joint.at) - edge_side - by_opening - by_bearing - joint.rest;
    if (distance < least.distance) least = {distance, by_opening, by_bearing};
  }
  return least;
}

/// How far the hull's nearest point moves along the normal and in all.
struct Straying {
  double along, in_all;
};

Straying straying(const MovingJoints& joints, const Nearest& nearest, const Point& normal,
                  const HalfSides& half) {
  const MovingJoint &a = joints[nearest.from], &b = joints[nearest.to];
  const double t = nearest.share;
  const Point velocity = (1 - t) * a.by_opening + t * b.by_opening;
  const Point at = (1 - t) * a.at + t * b.at;
  const double rest = std::max(a.rest, b.rest);
  return {std::abs(normal.dot(velocity)) * half.opening + std::abs(turning_along(normal, at)) * half.bearing +
              rest,
          velocity.norm() * half.opening + at.norm() * half.bearing + rest};
}

/// Bounds where the axes cross in the middle: no normal tells which motion counts.
GapBounds overlapping(const MovingJoints& joints, const JointHull& hull, const HalfSides& half,
                      double reach) {
  double by_opening = 0, by_bearing = 0;
  for (std::size_t corner = 0; corner < static_cast<std::size_t>(hull.count); ++corner) {
    by_opening = std::max(by_opening, joints[index(hull, corner)].speed * half.opening);
    by_bearing = std::max(by_bearing, joints[index(hull, corner)].far * half.bearing);
  }
  return {0, reach, 0, by_opening, by_bearing};
}

}  // namespace

double reach_of(const MovingJoints& joints, const JointHull& hull) {
  double reach = 0;
  for (std::size_t corner = 0; corner < static_cast<std::size_t>(hull.count); ++corner)
    reach = std::max(reach, joints[index(hull, corner)].reach);
  return reach;
}

GapBounds bounds_to_edge(const MovingJoints& joints, const JointHull& hull, const EdgeTree::Edge& edge,
                         const HalfSides& half, double upper_below) {
  const Nearest nearest = nearest_points(joints, hull, edge);
  const double reach = reach_of(joints, hull);
  const double distance = std::sqrt(nearest.squared);
  if (!(distance > 0)) return overlapping(joints, hull, half, reach);
  const Point normal = nearest.apart / distance;
  const Lower lower = separation(joints, hull, edge, normal, half);
  double upper = distance + reach;
  if (distance < upper_below) {
    const Straying stray = straying(joints, nearest, normal, half);
    const double along = distance + stray.along;
    upper = std::min(upper, std::sqrt(along * along + stray.in_all * stray.in_all));
  }
  return {std::max({lower.distance, distance - reach, 0.0}), upper, distance, lower.by_opening,
          lower.by_bearing};
}

double distance_from_box(const MovingJoints& joints, const JointHull& hull, const Box& box) {
  const Point& a = joints[index(hull, 0)].at;
  Box own{a, a};
  for (std::size_t corner = 1; corner < static_cast<std::size_t>(hull.count); ++corner) {
    const Point& at = joints[index(hull, corner)].at;
    own = {own.lower.cwiseMin(at), own.upper.cwiseMax(at)};
  }
  const double apart = distance(own, box);
  if (hull.count != 2) return apart;
  // A slanting segment: its own normal may separate better than the axes do.
  const Point along = joints[index(hull, 1)].at - a;
  const double length = along.norm();
  if (!(length > 0)) return apart;
  const Point normal(-along.y() / length, along.x() / length);
  const Point middle = 0.5 * (box.lower + box.upper), extent = 0.5 * (box.upper - box.lower);
  const double beside = std::abs(normal.dot(middle - a)) - normal.cwiseAbs().dot(extent);
  return std::max(apart, beside);
}

}  // namespace kempe
