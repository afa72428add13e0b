#include "synthesis/certificate/obstacle_leaf.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/convex_distance.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "geometry/segment_distance.hpp"
#include "synthesis/certificate/obstacle_points.hpp"
#include "workspace/obstacle_names.hpp"

namespace kempe::certificate {
namespace {

/// What the way from the middle design is multiplied by before it is compared with a depth: another order of the same operations may
/// find the way this much longer.
constexpr double of_the_way = 2;

/// The least width of a convex outline, across one of its edges.
double least_width(const Ring& outline) {
  double least = infinity;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& from = outline[i];
    const Point along = outline[(i + 1) % outline.size()] - from;
    double most = 0;
    for (const Point& corner : outline) most = std::max(most, std::abs(cross(along, corner - from)));
    if (along.norm() > 0) least = std::min(least, most / along.norm());
  }
  return least;
}

/// Distance of a point from the axis of a link: its bars, or its triangle.
double axis_distance(PartName part, PlateStyle plate, const std::array<Point, 6>& joints, const Point& from) {
  const auto at = [&](Joint joint) { return joints[static_cast<std::size_t>(joint)]; };
  if (part.number == 0) return distance(from, at(Joint::V), at(Joint::A));
  if (part.number == 1) return distance(from, at(Joint::V), at(Joint::B));
  const Point first = at(part.number == 2 ? Joint::A : Joint::B), C = at(Joint::C),
              tip = at(part.number == 2 ? Joint::X : Joint::Y);
  if (plate == PlateStyle::triangle) return distance(Hull{{first, C, tip}, 3}, Hull{{from, from, from}, 1});
  return std::sqrt(std::min(squared_distance(from, first, C), squared_distance(from, first, tip)));
}

}  // namespace

/// Obstacles that are convex can be taken as a whole, others by their edges.
ObstacleLeaves::Target ObstacleLeaves::target_of(const Obstacle& obstacle) {
  const Ring& outline = obstacle.shape.outer;
  const Box box = bounding_box(Region{{obstacle.shape}});
  Target target{{}, {}, 0.5 * (box.lower + box.upper), 0.5 * (box.upper - box.lower).norm()};
  for (const Point& corner : outline) target.corners.push_back(as_complex(corner));
  if (convex_parts(obstacle.shape).size() == 1) {
    target.edges = {std::nullopt};
    target.deepest = 0.5 * least_width(outline);
  } else {
    for (std::size_t i = 0; i < outline.size(); ++i) target.edges.emplace_back(i);
  }
  return target;
}

ObstacleLeaves::ObstacleLeaves(const RootTask& task) : task_(task) {
  for (const Obstacle& obstacle : task.spec.obstacles) targets_.push_back(target_of(obstacle));
  const Complex shape = task.root.mode.s;
  const bounding::MaterialPoint pole =
      bounding::material_point(roles_of(task.root.mode.grounding).pole, shape);
  for (std::uint8_t part = 0; part < part_count; ++part) {
    steadiest_[part] = infinity;
    for (const PartPoint& point : points_along({part}, task.spec.links.style.plate)) {
      const bounding::MaterialPoint at = material_point(point, shape);
      const double strays = std::abs((at.of_a - pole.of_a) - (at.of_b - pole.of_b));
      points_[part].push_back({point, at, strays});
      steadiest_[part] = std::min(steadiest_[part], strays);
    }
  }
}

std::optional<Step> ObstacleLeaves::step(const Node& node) const {
  if (task_.spec.obstacles.empty()) return std::nullopt;
  if (node.guess)
    if (auto step = leaf_for(node, *node.guess)) return step;
  if (!small_enough(node.cell)) return std::nullopt;
  const std::vector<Meeting> meetings = meetings_in(node.assignments);
  std::optional<Step> best;
  for (const KnownPlace& place : task_.places.spread()) {
    const auto middle = middle_at(node.cell, place.at);
    if (!middle) continue;
    for (const auto& [part, obstacle] : meetings) {
      const auto guess = deepest(part, obstacle, place, *middle);
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
  const std::vector<Complex>& corners = targets_[obstacle].corners;
  if (!edge) return needed - distance_from(as_complex(at), corners);
  const std::array<Complex, 2> ends{corners[*edge], corners[(*edge + 1) % corners.size()]};
  return needed - distance_from(as_complex(at), ends);
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
  return depth(range->middle, guess.leaf.obstacle, guess.leaf.edge, needed(point.part)) >
         of_the_way * range->away + slack::in_hand;
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

/// Nothing if it does not reach the place. With w and b given, A moves by da / |sin psi| where a grows by da.
std::optional<ObstacleLeaves::Middle> ObstacleLeaves::middle_at(const DesignCell& cell,
                                                                const Point& place) const {
  const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
  const Complex w = task_.root.g * (as_complex(place) - as_complex(cell.pole()));
  const double r = std::norm(w), rest = r - a * a - b * b, h2 = 4 * a * a * b * b - rest * rest;
  if (!(h2 > 0) || !(r > 0)) return std::nullopt;
  const double h = std::sqrt(h2);
  const Complex p = w * (r + a * a - b * b - Complex(0, task_.root.mode.bend * h)) / (2 * r);
  Middle middle;
  const bounding::MaterialPoint pole =
      bounding::material_point(roles_of(task_.root.mode.grounding).pole, task_.root.mode.s);
  for (const Joint joint : all_joints) {
    const bounding::MaterialPoint m = bounding::material_point(joint, task_.root.mode.s);
    middle.joints[static_cast<std::size_t>(joint)] =
        as_point(as_complex(cell.pole()) + p * (m.of_a - pole.of_a) + (w - p) * (m.of_b - pole.of_b));
  }
  middle.unsteady = (cell.half(Variable::a) + cell.half(Variable::b)) * 2 * a * b / h;
  return middle;
}

/// True if no point of the part can lie so deep in the obstacle that it does all over the cell.
bool ObstacleLeaves::out_of_reach(PartName part, std::size_t obstacle, const Middle& middle) const {
  const Target& target = targets_[obstacle];
  const double need = needed(part);
  if (of_the_way * steadiest_[part.number] * middle.unsteady > need + target.deepest) return true;
  if (points_[part.number].size() == 1) return false;  // as quickly looked at
  return axis_distance(part, task_.spec.links.style.plate, middle.joints, target.centre) >
         need + target.radius;
}

/// The point that is deepest beyond what it strays.
std::optional<ObstacleGuess> ObstacleLeaves::deepest(PartName part, std::size_t obstacle,
                                                     const KnownPlace& place, const Middle& middle) const {
  if (out_of_reach(part, obstacle, middle)) return std::nullopt;
  const double need = needed(part);
  ObstacleGuess best;
  double most = 0;
  const auto joint = [&](Joint name) { return as_complex(middle.joints[static_cast<std::size_t>(name)]); };
  const Complex V = joint(Joint::V), p = joint(Joint::A) - V,
                q = joint(Joint::X) - joint(Joint::A);  // q: q/s
  for (const auto& [point, m, strays] : points_[part.number]) {
    const Point at = as_point(V + m.of_a * p + m.of_b * q);
    const double least = of_the_way * strays * middle.unsteady;
    if (!(circle_depth(at, obstacle, need) > most + least)) continue;
    for (const auto& edge : targets_[obstacle].edges)
      if (const double here = depth(at, obstacle, edge, need) - least; here > most) {
        most = here;
        best = {{obstacle, edge, place.place, point}, place.at};
      }
  }
  if (most > 0) return best;
  return std::nullopt;
}

/// At least the depth: from a circle around the obstacle. Outside it the obstacle is no nearer than the circle.
double ObstacleLeaves::circle_depth(const Point& at, std::size_t obstacle, double need) const {
  const Target& target = targets_[obstacle];
  const double away = (at - target.centre).norm();
  return need + (away > target.radius ? 1 : 2) * target.radius - away;
}

}  // namespace kempe::certificate
