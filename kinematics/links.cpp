#include "kinematics/links.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

/// Distances that differ by less than this share are equal: both come from one shape, but for rounding.
constexpr double equally_near = 1e-9;

/// From a plate's end to its corner (A or B) and to C, both as multiples of the side that it goes along.
struct WaysOfPlate {
  Complex to_corner, to_C;
};

/// Of BCY, where Y = B + s p and C = B + p, with u = s; of ACX, where X = A + q/s and C = A + q, with u = 1/s.
WaysOfPlate ways_of_plate(Link link, Complex s) {
  const Complex u = link == Link::BCY ? s : 1.0 / s;
  return {-u, 1.0 - u};
}

bool is_plate(Link link) { return link == Link::ACX || link == Link::BCY; }

bool is_corner_nearest(const WaysOfPlate& ways) {
  return std::abs(ways.to_corner) <= (1 + equally_near) * std::abs(ways.to_C);
}

}  // namespace

std::string_view name(Link link) {
  switch (link) {
    case Link::VA: return "VA";
    case Link::VB: return "VB";
    case Link::ACX: return "ACX";
    case Link::BCY: break;
  }
  return "BCY";
}

LinkJoints joints_of(Link link) {
  switch (link) {
    case Link::VA: return {{Joint::V, Joint::A, Joint::A}, 2};
    case Link::VB: return {{Joint::V, Joint::B, Joint::B}, 2};
    case Link::ACX: return {{Joint::A, Joint::C, Joint::X}, 3};
    case Link::BCY: break;
  }
  return {{Joint::B, Joint::C, Joint::Y}, 3};
}

bool has_joint(Link link, Joint joint) {
  const LinkJoints of_link = joints_of(link);
  return std::find(of_link.joints.begin(), of_link.joints.begin() + of_link.count, joint) !=
         of_link.joints.begin() + of_link.count;
}

Joint end_of(Link link) {
  if (!is_plate(link)) return Joint::V;
  return link == Link::ACX ? Joint::X : Joint::Y;
}

bool is_along_p(Link link) { return link == Link::VA || link == Link::BCY; }

Joint nearest_to_end(Link link, Complex s) {
  const LinkJoints of_link = joints_of(link);
  if (!is_plate(link)) return of_link.joints[1];
  return of_link.joints[is_corner_nearest(ways_of_plate(link, s)) ? 0 : 1];
}

Complex axis_at_end(Link link, Complex s) {
  if (!is_plate(link)) return 1;
  const WaysOfPlate ways = ways_of_plate(link, s);
  const Complex way = is_corner_nearest(ways) ? ways.to_corner : ways.to_C;
  return way / std::abs(way);
}

}  // namespace kempe
