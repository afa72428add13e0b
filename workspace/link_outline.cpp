// Outlines of links: a bar is a stadium, a triangle plate the rounded hull of its joints, a bent plate the
// union of two stadiums that share the disc about their corner.

#include <algorithm>
#include <cmath>
#include <optional>

#include "workspace/parts.hpp"

namespace kempe {
namespace {

/// Joints whose triangle is flatter than this share of its longest side squared lie on one line.
constexpr double flat = 1e-12;

/// bulge of the arc of a circle from one point to another, counter-clockwise, less than a full turn.
double bulge_between(const Point& centre, const Point& from, const Point& to) {
  const Point a = from - centre, b = to - centre;
  double sweep = std::atan2(cross(a, b), a.dot(b));
  if (sweep < 0) sweep += 2 * pi;
  return std::tan(0.25 * sweep);
}

/// Rounded outline of a convex ring of two or more distinct points, counter-clockwise.
ArcRing rounded(const Ring& convex, double radius) {
  ArcRing ring;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point& before = convex[(i + convex.size() - 1) % convex.size()];
    const Point& here = convex[i];
    const Point& after = convex[(i + 1) % convex.size()];
    const Point from = here - radius * left_of((here - before).normalized());
    const Point to = here - radius * left_of((after - here).normalized());
    ring.push_back({from, bulge_between(here, from, to)});
    ring.push_back({to, 0});
  }
  return ring;
}

/// The two of three collinear points that lie farthest apart.
Ring outermost(const Point& a, const Point& b, const Point& c) {
  const double ab = (a - b).squaredNorm(), bc = (b - c).squaredNorm(), ca = (c - a).squaredNorm();
  if (ab >= bc && ab >= ca) return {a, b};
  return bc >= ca ? Ring{b, c} : Ring{c, a};
}

/// One arm of a bent plate, seen from the corner.
struct Arm {
  Point end, direction;
  double length;
};

/// The point of the side of `arm` (offset `radius` along `side`) at distance `radius` from the other arm's
/// end, beyond that end as seen from the corner.
std::optional<Point> side_meets_cap(const Point& corner, const Arm& arm, const Point& side,
                                    const Point& other_end, double radius) {
  const Point start = corner + radius * side;
  const double along = (other_end - start).dot(arm.direction);
  const double off = (other_end - start).dot(side);
  const double squared = radius * radius - off * off;
  if (squared < 0) return std::nullopt;
  const double place = along + std::sqrt(squared);
  if (place < 0 || place > arm.length) return std::nullopt;
  return start + place * arm.direction;
}

/// The point, beyond both ends as seen from the corner, at distance `radius` from both ends.
Point cap_meets_cap(const Point& corner, const Point& one, const Point& other, double radius) {
  const Point middle = 0.5 * (one + other);
  const double half = 0.5 * (other - one).norm();
  Point away = left_of((other - one).normalized());
  if (away.dot(middle - corner) < 0) away = -away;
  return middle + std::sqrt(std::max(0.0, radius * radius - half * half)) * away;
}

/// Where the inner sides of two arms meet: `right` lies clockwise of `left` by less than half a turn.
ArcRing bent_outline(const Point& corner, const Arm& right, const Arm& left, double radius) {
  const Point right_side = left_of(right.direction),
              left_side = -left_of(left.direction);  // facing each other
  const double bend = std::atan2(cross(right.direction, left.direction), right.direction.dot(left.direction));
  const double notch = radius / std::tan(0.5 * bend);  // along each arm
  const Point outer_right = -radius * right_side, outer_left = -radius * left_side;
  ArcRing ring{{corner + outer_left, bulge_between(Point::Zero(), outer_left, outer_right)},
               {corner + outer_right, 0}};
  const auto add_cap = [&](const Point& end, const Point& from, const Point& to) {
    ring.push_back({from, bulge_between(end, from, to)});
  };
  const Point right_from = right.end + outer_right, right_to = right.end + radius * right_side;
  const Point left_from = left.end + radius * left_side, left_to = left.end + outer_left;
  if (notch <= std::min(right.length, left.length)) {
    add_cap(right.end, right_from, right_to);
    ring.push_back({right_to, 0});
    ring.push_back({corner + radius * right_side + notch * right.direction, 0});
    add_cap(left.end, left_from, left_to);
  } else if (const auto on_right = side_meets_cap(corner, right, right_side, left.end, radius)) {
    add_cap(right.end, right_from, right_to);
    ring.push_back({right_to, 0});
    add_cap(left.end, *on_right, left_to);
  } else if (const auto on_left = side_meets_cap(corner, left, left_side, right.end, radius)) {
    add_cap(right.end, right_from, *on_left);
    ring.push_back({*on_left, 0});
    add_cap(left.end, left_from, left_to);
  } else {
    const Point meeting = cap_meets_cap(corner, right.end, left.end, radius);
    add_cap(right.end, right_from, meeting);
    add_cap(left.end, meeting, left_to);
  }
  ring.push_back({left_to, 0});
  return ring;
}

Arm arm_between(const Point& corner, const Point& end) {
  const double length = (end - corner).norm();
  return {end, (end - corner) / length, length};
}

ArcRing plate_outline(const Point& corner, const Point& C, const Point& tip, PlateStyle plate,
                      double radius) {
  const double turn = cross(C - corner, tip - corner);
  const double longest =
      std::max({(C - corner).squaredNorm(), (tip - corner).squaredNorm(), (tip - C).squaredNorm()});
  if (std::abs(turn) <= flat * longest) return rounded(outermost(corner, C, tip), radius);
  const Point& right = turn > 0 ? C : tip;
  const Point& left = turn > 0 ? tip : C;
  if (plate == PlateStyle::triangle) return rounded({corner, right, left}, radius);
  return bent_outline(corner, arm_between(corner, right), arm_between(corner, left), radius);
}

}  // namespace

ArcPolygon link_outline(Link link, const Pose& pose, const LinkStyle& style) {
  const double radius = 0.5 * style.width;
  const LinkJoints of_link = joints_of(link);
  const auto at = [&](std::size_t i) { return pose[of_link.joints[i]]; };
  if (of_link.count == 2) return {rounded({at(0), at(1)}, radius), {}};
  return {plate_outline(at(0), at(1), at(2), style.plate, radius), {}};
}

}  // namespace kempe
