#include "synthesis/verification/bodies.hpp"

#include <algorithm>
#include <variant>

#include "kinematics/overloaded.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

using plain::Corners;

Corners moved(const Corners& corners, const Point& by) {
  Corners result;
  for (const Point& corner : corners) result.push_back(corner + by);
  return result;
}

bool is_of(const Part& part, Joint joint) {
  return part.kind == Part::Kind::link ? has_joint(part.link, joint) : part.joint == joint;
}

bool is_pin_on(const Part& part, const std::optional<Link>& link) {
  return link && part.kind != Part::Kind::link && has_joint(*link, part.joint);
}

/// From a joint to the nearest other joint of the link, of size 1; of two that are equally near, but for rounding, to the first of
/// the link's name.
Point x_axis(Link link, Joint from, const Pose& pose) {
  constexpr double nearer = 1 - 1e-9;
  const LinkJoints all = joints_of(link);
  Point way = Point::Zero();
  for (int i = 0; i < all.count; ++i) {
    const Joint joint = all.joints[static_cast<std::size_t>(i)];
    if (joint == from) continue;
    const Point other = pose[joint] - pose[from];
    if (way.norm() == 0 || other.norm() < nearer * way.norm()) way = other;
  }
  return way.normalized();
}

}  // namespace

BodyWatch::BodyWatch(const CopyingLinkage& linkage, const VerificationTask& task) {
  if (task.bodies.empty() && !task.table) return;
  const Point& pole = task.mechanism.pole_position;
  for (const Part& part : parts_of(linkage, task.layers))
    for (const JointHull& hull : axis_of(part, linkage.shape(), task.style.plate))
      pieces_.push_back(
          {part,
           hull,
           {{}, half_width(part, task.style), part.lowest_layer, part.highest_layer, name(part)}});
  for (std::size_t i = 0; i < task.obstacles.size(); ++i)
    obstacles_.push_back({moved(task.obstacles[i].shape.outer, -pole), 0, task.obstacles[i].lowest_layer,
                          task.obstacles[i].highest_layer, obstacle_name(task.obstacles, i)});
  for (std::size_t i = 0; i < task.bodies.size(); ++i) {
    const Body& body = task.bodies[i];
    Thing thing{{}, 0, body.lowest_layer, body.highest_layer, body_name(task.bodies, i)};
    std::visit(Overloaded{[&](const Disc& disc) {
                            thing.corners = {disc.centre};
                            thing.around = disc.radius;
                          },
                          [&](const Polygon& polygon) { thing.corners = polygon.outer; }},
               body.shape);
    bodies_.push_back({body.at == Carrier::tracer ? task.mechanism.tracer : task.mechanism.pen,
                       body.turns_with, std::move(thing)});
  }
  if (task.table) table_ = moved(task.table->outer, -pole);
}

Corners BodyWatch::corners_of(const CarriedThing& body, const Pose& pose) {
  if (!body.turns_with) return moved(body.thing.corners, pose[body.by]);
  const Point x = x_axis(*body.turns_with, body.by, pose), y(-x.y(), x.x());
  Corners placed;
  for (const Point& corner : body.thing.corners)
    placed.push_back(pose[body.by] + corner.x() * x + corner.y() * y);
  return placed;
}

void BodyWatch::for_each_near(const Pose& pose, double within, const std::function<void(Near)>& use) const {
  std::vector<Thing> parts, bodies;
  for (const Piece& piece : pieces_) {
    parts.push_back(piece.thing);
    parts.back().corners = plain::corners_of(piece.hull, pose);
  }
  for (const CarriedThing& body : bodies_) {
    bodies.push_back(body.thing);
    bodies.back().corners = corners_of(body, pose);
  }
  const auto look = [&](const Thing& one, const Thing& other) {
    if (std::max(one.lowest_layer, other.lowest_layer) > std::min(one.highest_layer, other.highest_layer))
      return;
    const double around = one.around + other.around;
    if (!(plain::distance_of_boxes(one.corners, other.corners) < within + around)) return;
    const double gap = plain::distance(one.corners, other.corners) - around;
    if (gap < within) use({"bodies", gap, one.name, other.name});
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < parts.size(); ++j)
      if (!is_of(pieces_[j].part, bodies_[i].by) && !is_pin_on(pieces_[j].part, bodies_[i].turns_with))
        look(parts[j], bodies[i]);
    for (const Thing& obstacle : obstacles_) look(bodies[i], obstacle);
    for (std::size_t j = 0; j < i; ++j)
      if (bodies_[j].by != bodies_[i].by) look(bodies[j], bodies[i]);
  }
  if (table_.empty()) return;
  const auto look_at_edge = [&](const Thing& thing) {
    const bool on_it = plain::holds(table_, thing.corners.front());
    const double gap = (on_it ? plain::distance_of_edges(thing.corners, table_) : 0.0) - thing.around;
    if (gap < within) use({"table", gap, thing.name, "the table's edge"});
  };
  for (const Thing& part : parts) look_at_edge(part);
  for (const Thing& body : bodies) look_at_edge(body);
}

}  // namespace kempe
