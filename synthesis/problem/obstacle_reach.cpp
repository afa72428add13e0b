#include "synthesis/problem/obstacle_reach.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/edge_tree.hpp"
#include "synthesis/problem/search_space.hpp"
#include "synthesis/problem/slack.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// A box around places at which a joint may stand, and how far from the joint parts may reach.
struct Surroundings {
  Box places;
  double length;  ///< mm, half widths and clearance included
};

Box grown(const Box& box, double margin) {
  return {box.lower - Point(margin, margin), box.upper + Point(margin, margin)};
}

Box sum(const Box& one, const Box& other) { return {one.lower + other.lower, one.upper + other.upper}; }

/// The box around the box's image under multiplication by a complex number.
Box image(const Box& box, Complex factor) {
  const Complex first = factor * as_complex(box.lower);
  Box result{as_point(first), as_point(first)};
  for (const Point& corner :
       {box.upper, Point(box.lower.x(), box.upper.y()), Point(box.upper.x(), box.lower.y())}) {
    const Point at = as_point(factor * as_complex(corner));
    result = {result.lower.cwiseMin(at), result.upper.cwiseMax(at)};
  }
  return result;
}

/// The box around the region's image, corner by corner: smaller than that of its box.
Box image(const Region& region, Complex factor) {
  Box result =
      image(Box{region.polygons.front().outer.front(), region.polygons.front().outer.front()}, factor);
  for (const Polygon& polygon : region.polygons)
    for (const Point& corner : polygon.outer) {
      const Point at = as_point(factor * as_complex(corner));
      result = {result.lower.cwiseMin(at), result.upper.cwiseMax(at)};
    }
  return result;
}

Box box_of_pole(const PoleSpec& pole, double margin) {
  if (pole.is_fixed()) return grown({std::get<Point>(pole.place), std::get<Point>(pole.place)}, margin);
  return grown(bounding_box(std::get<Region>(pole.place)), margin);
}

/// Where pole, tracer and pen may stand.
struct Places {
  Box pole, tracer, pen;
  const Box& of(Joint joint, const JointRoles& roles) const {
    return joint == roles.pole ? pole : joint == roles.tracer ? tracer : pen;
  }
};

Places places_of(const Spec& spec, const Requirements& limits) {
  const Box pole = box_of_pole(spec.pole, limits.pole_margin);
  return {pole, bounding_box(spec.region),
          sum(image(pole, 1.0 - spec.copy.k()), image(spec.region, spec.copy.k()))};
}

/// Around V, X and Y; none if no lengths keep the limits.
std::vector<Surroundings> surroundings_of(const Spec& spec, const Requirements& limits, Grounding grounding,
                                          const Places& places) {
  const Reach reach(spec.copy.k(), grounding, 0);
  const LogBox box = length_box(reach, limits, spec.links.stock_lengths);
  if (box.u.empty() || box.v.empty()) return {};
  const double VA = std::exp(box.u.upper), VB = std::exp(box.v.upper);
  const double scale = std::abs(reach.shape()), turn = std::abs(1.0 - reach.shape());
  const LinkStyle& style = spec.links.style;
  double beside = 0.5 * std::max(style.width, style.pin_diameter) + limits.clearance;
  for (const Body& body : spec.bodies)
    beside = std::max(beside, farthest(body) + limits.clearance);  // of any joint: more than enough
  const JointRoles roles = roles_of(grounding);
  const auto around = [&](Joint joint, double length) {
    return Surroundings{places.of(joint, roles), length * (1 + slack::reach_box_slack) + beside};
  };
  return {around(Joint::V, std::max(VA, VB)), around(Joint::X, VB * std::max(1.0, turn) / scale),
          around(Joint::Y, VA * std::max(scale, turn))};
}

double magnitude(const Box& box) {
  return std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
}

Box box_around(const Ring& ring) {
  Box box{ring.front(), ring.front()};
  for (const Point& corner : ring) box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
  return box;
}

bool in_reach(const Obstacle& obstacle, const std::vector<Surroundings>& all) {
  if (obstacle.shape.outer.empty()) return false;
  const Box box = box_around(obstacle.shape.outer);
  return std::any_of(all.begin(), all.end(), [&](const Surroundings& one) {
    const double rounding = slack::reach_box_slack * (magnitude(box) + magnitude(one.places));
    return distance(box, one.places) <= one.length + rounding;
  });
}

}  // namespace

std::vector<bool> obstacles_in_reach(const Spec& spec, const Requirements& limits) {
  if (spec.region.empty()) return std::vector<bool>(spec.obstacles.size(), true);
  const Places places = places_of(spec, limits);
  std::vector<Surroundings> all;
  for (const Grounding grounding : spec.objective.groundings)
    for (const Surroundings& one : surroundings_of(spec, limits, grounding, places)) all.push_back(one);
  std::vector<bool> reached;
  for (const Obstacle& obstacle : spec.obstacles) reached.push_back(in_reach(obstacle, all));
  return reached;
}

Spec with_obstacles_in_reach(const Spec& spec, const Requirements& limits) {
  const std::vector<bool> reached = obstacles_in_reach(spec, limits);
  Spec result = spec;
  result.obstacles.clear();
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (reached[i]) result.obstacles.push_back(spec.obstacles[i]);
  return result;
}

std::vector<std::string> names_out_of_reach(const Spec& spec) {
  const std::vector<bool> reached = obstacles_in_reach(spec, requirements_of(spec));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (!reached[i]) names.push_back(spec.obstacles[i].name);
  return names;
}

}  // namespace kempe
