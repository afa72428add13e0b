#include "workspace/obstructions.hpp"

#include <algorithm>
#include <variant>

#include "geometry/convex_hull.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "kinematics/overloaded.hpp"
#include "workspace/obstacle_names.hpp"

namespace kempe {
namespace {

/// A body as an obstruction: a disc is its centre, grown.
Obstruction obstruction_of(const Body& body, std::string name) {
  Obstruction obstruction{.frame = body.at,
                          .turns_with = body.turns_with,
                          .shape = {},
                          .lowest_layer = body.lowest_layer,
                          .highest_layer = body.highest_layer,
                          .name = std::move(name)};
  std::visit(Overloaded{[&](const Disc& disc) {
                          obstruction.shape.polygons = {{{disc.centre}, {}}};
                          obstruction.grown = disc.radius;
                        },
                        [&](const Polygon& polygon) { obstruction.shape.polygons = {polygon}; }},
             body.shape);
  return obstruction;
}

std::vector<ConvexPart> parts_of_region(const Region& region) {
  std::vector<ConvexPart> parts;
  for (const Polygon& polygon : region.polygons)
    for (ConvexPart& part : convex_parts(polygon)) parts.push_back(std::move(part));
  return parts;
}

/// The Minkowski difference of two convex sets.
Ring difference(const ConvexPart& from, const ConvexPart& taken) {
  std::vector<Point> points;
  for (const Complex& one : from)
    for (const Complex& other : taken) points.push_back(as_point(one - other));
  return convex_hull(std::move(points));
}

bool share_layer(const Obstruction& one, const Obstruction& other) {
  return std::max(one.lowest_layer, other.lowest_layer) <= std::min(one.highest_layer, other.highest_layer);
}

/// What the body's point must keep clear of for the body to keep clear of the other.
Obstruction without(const Obstruction& other, const Obstruction& body) {
  Obstruction result = other;
  result.met = Obstruction::Met{*body.frame, body.name};
  result.grown += body.grown;
  result.turning.clear();  // bodies that turn meet the other itself
  result.shape.polygons.clear();
  const std::vector<ConvexPart> taken = parts_of_region(body.shape);
  for (const ConvexPart& one : parts_of_region(other.shape))
    for (const ConvexPart& part : taken) result.shape.polygons.push_back({difference(one, part), {}});
  return result;
}

double farthest_corner(const Ring& ring) {
  double farthest = 0;
  for (const Point& corner : ring) farthest = std::max(farthest, corner.norm());
  return farthest;
}

}  // namespace

std::vector<Obstruction> obstructions_of(const std::vector<Obstacle>& obstacles,
                                         const std::vector<Body>& bodies,
                                         const std::optional<Polygon>& table) {
  std::vector<Obstruction> obstructions;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    obstructions.push_back({.shape = Region{{obstacles[i].shape}},
                            .lowest_layer = obstacles[i].lowest_layer,
                            .highest_layer = obstacles[i].highest_layer,
                            .name = obstacle_name(obstacles, i)});
  if (table)
    obstructions.push_back({.shape = Region{{off_the_table(*table, bodies)}}, .name = "the table's edge"});
  const std::size_t at_rest = obstructions.size();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    obstructions.push_back(obstruction_of(bodies[i], body_name(bodies, i)));
  const std::size_t bodies_end = obstructions.size();
  for (std::size_t i = at_rest; i < bodies_end; ++i) {
    const bool turns = obstructions[i].turns_with.has_value();
    for (std::size_t j = 0; j < (turns ? bodies_end : i); ++j) {
      Obstruction& other = obstructions[j];
      if (other.frame == obstructions[i].frame || !share_layer(other, obstructions[i])) continue;
      if (turns && !(other.turns_with && j > i)) other.turning.push_back(i - at_rest);
      if (!turns && !other.turns_with) {
        Obstruction difference = without(other, obstructions[i]);
        obstructions.push_back(std::move(difference));
      }
    }
  }
  return obstructions;
}

std::vector<Body> that_keep_direction(const std::vector<Body>& bodies) {
  std::vector<Body> kept;
  for (const Body& body : bodies)
    if (!body.turns_with) kept.push_back(body);
  return kept;
}

BodyPieces pieces_of(const Body& body) {
  if (const auto* disc = std::get_if<Disc>(&body.shape)) return {{{as_complex(disc->centre)}}, disc->radius};
  BodyPieces triangles;
  for (const ConvexPart& part : convex_parts(std::get<Polygon>(body.shape)))
    for (std::size_t i = 1; i + 1 < part.size(); ++i)
      triangles.pieces.push_back({part[0], part[i], part[i + 1]});
  return triangles;
}

LinkagePoint point_on_link(Complex corner, Link link, const CopyingLinkage& linkage) {
  const Complex s = linkage.shape(), along = corner * axis_at_end(link, s);
  switch (link) {
    case Link::VA: return {along / linkage.VA(), 0};
    case Link::VB: return {0, along / linkage.VB()};
    case Link::ACX: return {1, 1.0 / s + along / linkage.VB()};
    case Link::BCY: break;
  }
  return {s + along / linkage.VA(), 1};
}

namespace {

/// The direction of the body's x axis, as a number of size 1.
Complex axis_in(const Body& body, const CopyingLinkage& linkage, const Pose& pose) {
  if (!body.turns_with) return 1;
  const Joint toward = nearest_to_end(*body.turns_with, linkage.shape());
  const Complex way = as_complex(pose[toward] - pose[joint_of(body.at, linkage)]);
  return std::abs(way) > 0 ? way / std::abs(way) : Complex(1);
}

}  // namespace

std::variant<Disc, Polygon> placed(const Body& body, const CopyingLinkage& linkage, const Pose& pose) {
  const Point& at = pose[joint_of(body.at, linkage)];
  const Complex axis = axis_in(body, linkage, pose);
  const auto place = [&](const Point& corner) -> Point {
    return body.turns_with ? at + as_point(axis * as_complex(corner)) : at + corner;
  };
  std::variant<Disc, Polygon> result = body.shape;
  std::visit(Overloaded{[&](Disc& disc) { disc.centre = place(disc.centre); },
                        [&](Polygon& polygon) {
                          for (Point& corner : polygon.outer) corner = place(corner);
                        }},
             result);
  return result;
}

double bearing_of(const Body& body, const CopyingLinkage& linkage, const Pose& pose) {
  return std::arg(axis_in(body, linkage, pose));
}

Polygon off_the_table(const Polygon& table, const std::vector<Body>& bodies) {
  Box box{table.outer.front(), table.outer.front()};
  for (const Point& corner : table.outer) box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
  double beyond = (box.upper - box.lower).norm();
  for (const Body& body : bodies) beyond = std::max(beyond, 2 * farthest(body));
  const Point lower = box.lower - Point::Constant(beyond), upper = box.upper + Point::Constant(beyond);
  return {{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}},
          {Ring(table.outer.rbegin(), table.outer.rend())}};
}

double farthest(const Body& body) {
  return std::visit(Overloaded{[](const Disc& disc) { return disc.centre.norm() + disc.radius; },
                               [](const Polygon& polygon) { return farthest_corner(polygon.outer); }},
                    body.shape);
}

std::string body_name(const std::vector<Body>& bodies, std::size_t index) {
  const std::string& given = bodies[index].name;
  return given.empty() ? "body " + std::to_string(index + 1) : given;
}

Joint joint_of(Carrier carrier, const CopyingLinkage& linkage) {
  return carrier == Carrier::tracer ? linkage.tracer_joint() : linkage.pen_joint();
}

bool may_meet(const Part& part, const Obstruction& obstruction, const CopyingLinkage& linkage) {
  if (obstruction.met || part.lowest_layer > obstruction.highest_layer ||
      obstruction.lowest_layer > part.highest_layer)
    return false;
  if (!obstruction.frame) return true;
  const Joint carrier = joint_of(*obstruction.frame, linkage);
  if (part.kind == Part::Kind::link) return !has_joint(part.link, carrier);
  return part.joint != carrier && !(obstruction.turns_with && has_joint(*obstruction.turns_with, part.joint));
}

}  // namespace kempe
