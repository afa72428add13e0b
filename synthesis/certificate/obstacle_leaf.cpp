#include "synthesis/certificate/obstacle_leaf.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/convex_distance.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "synthesis/certificate/obstacle_points.hpp"
#include "workspace/obstacles.hpp"

namespace kempe::certificate {
namespace {

/// Obstacles that are convex can be taken as a whole, others by their edges.
std::vector<std::optional<std::size_t>> targets_of(const Obstacle& obstacle) {
  const Ring& outline = obstacle.shape.outer;
  if (convex_parts(obstacle.shape).size() == 1) return {std::nullopt};
  std::vector<std::optional<std::size_t>> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) edges.emplace_back(i);
  return edges;
}

}  // namespace

ObstacleLeaves::ObstacleLeaves(const RootTask& task) : task_(task) {
  for (const Obstacle& obstacle : task.spec.obstacles) {
    targets_.push_back(targets_of(obstacle));
    const Box box = bounding_box(Region{{obstacle.shape}});
    circles_.emplace_back(0.5 * (box.lower + box.upper), 0.5 * (box.upper - box.lower).norm());
  }
  for (std::uint8_t part = 0; part < part_count; ++part)
    for (const PartPoint& point : points_along({part}, task.spec.links.style.plate))
      points_[part].emplace_back(point, material_point(point, task.root.mode.s));
}

std::optional<Step> ObstacleLeaves::step(const Node& node) const {
  if (task_.spec.obstacles.empty()) return std::nullopt;
  if (node.guess)
    if (auto step = leaf_for(node, *node.guess)) return step;
  if (!small_enough(node.cell)) return std::nullopt;
  const std::vector<Meeting> meetings = meetings_in(node.assignments);
  std::optional<Step> best;
  for (const KnownPlace& place : task_.places.spread()) {
    const auto joints = joints_at(node.cell, place.at);
    if (!joints) continue;
    for (const auto& [part, obstacle] : meetings) {
      const auto guess = deepest(part, obstacle, place, *joints);
      if (!guess) continue;
      auto step = leaf_for(node, *guess);
      if (step && step->children.empty()) return step;
      if (step && !best) best = std::move(step);
    }
  }
  return best;
}

std::vector<ObstacleLeaves::Meeting> ObstacleLeaves::meetings_in(const Assignments& assignments) const {
  std::vector<Meeting> meetings;
  for (std::size_t obstacle = 0; obstacle < task_.spec.obstacles.size(); ++obstacle)
    for (std::uint8_t part = 0; part < part_count; ++part)
      if (std::any_of(assignments.begin(), assignments.end(), [&](std::uint32_t i) {
            return task_.filled[i].share(PartName{part}, task_.spec.obstacles[obstacle]);
          }))
        meetings.push_back({{part}, obstacle});
  return meetings;
}

/// How deep a place lies within reach `needed` of an obstacle's edge or, without one, of all of it; mm.
double ObstacleLeaves::depth(const Point& at, std::size_t obstacle, const std::optional<std::size_t>& edge,
                             double needed) const {
  const Ring& outline = task_.spec.obstacles[obstacle].shape.outer;
  const Complex point = as_complex(at);
  std::vector<Complex> corners;
  if (edge)
    corners = {as_complex(outline[*edge]), as_complex(outline[(*edge + 1) % outline.size()])};
  else
    for (const Point& corner : outline) corners.push_back(as_complex(corner));
  return needed - nearest_features({&point, 1}, corners).distance;
}

double ObstacleLeaves::needed(PartName part) const {
  return half_width(part_of(part), task_.spec.links.style) + task_.spec.limits.clearance;
}

bool ObstacleLeaves::hits(const ObstacleGuess& guess, const DesignCell& cell) const {
  const PartPoint& point = guess.leaf.point;
  const bounding::MaterialPoint at = material_point(point, task_.root.mode.s),
                                pole = bounding::material_point(roles_of(task_.root.mode.grounding).pole,
                                                                task_.root.mode.s);
  const auto range = point_over(task_.root, cell, guess.place, {at.of_a - pole.of_a, at.of_b - pole.of_b});
  if (!range) return false;
  constexpr double of_the_way = 2;  // another order of the same operations may find the way this much longer
  return depth(range->middle, guess.leaf.obstacle, guess.leaf.edge, needed(point.part)) >
         of_the_way * range->away + in_hand;
}

Assignments ObstacleLeaves::sharing(const Assignments& all, PartName part, std::size_t obstacle) const {
  Assignments some;
  for (const std::uint32_t i : all)
    if (task_.filled[i].share(part, task_.spec.obstacles[obstacle])) some.push_back(i);
  return some;
}

/// A leaf for the assignments in which the part meets the obstacle; the others are left.
std::optional<Step> ObstacleLeaves::leaf_for(const Node& node, const ObstacleGuess& guess) const {
  const PartName part = guess.leaf.point.part;
  const Assignments some = sharing(node.assignments, part, guess.leaf.obstacle);
  if (some.empty() || !hits(guess, node.cell)) return std::nullopt;
  if (some.size() == node.assignments.size()) return Step{guess.leaf, {}};
  return share_step(node, {part, guess.leaf.obstacle}, some, guess);
}

/// Joints of the middle design with the tracer at a place; nothing if it does not reach it.
std::optional<std::array<Complex, 6>> ObstacleLeaves::joints_at(const DesignCell& cell,
                                                                const Point& place) const {
  const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
  const Complex w = task_.root.g * (as_complex(place) - as_complex(cell.pole()));
  const double r = std::norm(w), rest = r - a * a - b * b, h2 = 4 * a * a * b * b - rest * rest;
  if (!(h2 > 0) || !(r > 0)) return std::nullopt;
  const Complex p = w * (r + a * a - b * b - Complex(0, task_.root.mode.bend * std::sqrt(h2))) / (2 * r);
  std::array<Complex, 6> at;
  const bounding::MaterialPoint pole =
      bounding::material_point(roles_of(task_.root.mode.grounding).pole, task_.root.mode.s);
  for (const Joint joint : all_joints) {
    const bounding::MaterialPoint m = bounding::material_point(joint, task_.root.mode.s);
    at[static_cast<std::size_t>(joint)] =
        as_complex(cell.pole()) + p * (m.of_a - pole.of_a) + (w - p) * (m.of_b - pole.of_b);
  }
  return at;
}

std::optional<ObstacleGuess> ObstacleLeaves::deepest(PartName part, std::size_t obstacle,
                                                     const KnownPlace& place,
                                                     const std::array<Complex, 6>& joints) const {
  const double need = needed(part);
  ObstacleGuess best;
  double most = 0;
  const Complex V = joints[0], p = joints[1] - V, q = joints[4] - V - p;  // V, A, X: q/s = X - A
  for (const auto& [point, m] : points_[part.number]) {
    const Point at = as_point(V + m.of_a * p + m.of_b * q);
    if (!(circle_depth(at, obstacle, need) > most)) continue;
    for (const auto& edge : targets_[obstacle])
      if (const double here = depth(at, obstacle, edge, need); here > most) {
        most = here;
        best = {{obstacle, edge, place.place, point}, place.at};
      }
  }
  if (most > 0) return best;
  return std::nullopt;
}

/// At least the depth: from a circle around the obstacle. Outside it the obstacle is no nearer than the circle.
double ObstacleLeaves::circle_depth(const Point& at, std::size_t obstacle, double need) const {
  const auto& [centre, radius] = circles_[obstacle];
  const double away = (at - centre).norm();
  return need + (away > radius ? 1 : 2) * radius - away;
}

}  // namespace kempe::certificate
