#include "synthesis/certificate/obstacle_leaf.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/convex_distance.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "geometry/segment_distance.hpp"
#include "synthesis/certificate/obstacle_points.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe::certificate {
namespace {

/// Safety factor on the way from the middle design before it is compared with a depth: the checker does the same operations in another order
/// and may find a longer one. A cell in which twice the way is too much is split.
constexpr double of_the_way = 2;
/// A table of more edges is left out of the log: every part is looked at beside every edge.
constexpr std::size_t most_table_edges = 64;
/// Of a convex outline with more corners some are enough to look by: those this share of its radius apart.
constexpr std::size_t many_corners = 128;
constexpr double apart_of_radius = 0.15;

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

/// A piece of a part's axis in a design, by its joints' places.
Hull placed(const JointHull& piece, const std::array<Point, 6>& joints) {
  Hull hull{{}, piece.count};
  for (std::size_t i = 0; i < hull.at.size(); ++i)
    hull.at[i] = joints[static_cast<std::size_t>(piece.joints[i])];
  return hull;
}

/// True if no place of a hull is as near to a point as `away`.
bool keeps_away(const Hull& hull, const Point& from, double away) {
  if (inside(hull, from)) return false;
  for (int i = 0; i < std::max(1, hull.count == 3 ? 3 : hull.count - 1); ++i) {
    const Point &one = hull.at[static_cast<std::size_t>(i)],
                &other = hull.at[static_cast<std::size_t>((i + 1) % hull.count)];
    if (!(distance(from, one, other) > away)) return false;
  }
  return true;
}

/// True if all of a hull lies farther than `away` from the line through two points, on one side of it.
bool keeps_to_one_side(const Hull& hull, const Point& from, const Point& to, double away) {
  const Point along = to - from;
  const double least = away * along.norm();
  double lowest = infinity, highest = -infinity;
  for (int i = 0; i < hull.count; ++i) {
    const double height = cross(along, hull.at[static_cast<std::size_t>(i)] - from);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return lowest > least || highest < -least;
}

}  // namespace

/// Outlines that are convex can be taken as a whole, others by their edges.
ObstacleLeaves::Target ObstacleLeaves::target_of(const Ring& outline, bool by_edges_alone) {
  const Box box = bounding_box(Region{{{outline, {}}}});
  Target target;
  target.centre = 0.5 * (box.lower + box.upper);
  target.radius = 0.5 * (box.upper - box.lower).norm();
  for (const Point& corner : outline) target.corners.push_back(as_complex(corner));
  target.few = target.corners;
  if (outline.size() == 1) {
    target.edges = {std::nullopt};
  } else if (!by_edges_alone && is_convex(outline)) {
    target.edges = {std::nullopt};
    target.deepest = 0.5 * least_width(outline);
    if (outline.size() > many_corners) {
      target.few.clear();
      for (const Point& corner : thinned(outline, apart_of_radius * target.radius))
        target.few.push_back(as_complex(corner));
      for (const Complex& corner : target.corners)
        target.left_out = std::max(target.left_out, distance_from(corner, target.few));
    }
    target.outline.emplace(target.few);
  } else {
    for (std::size_t i = 0; i < outline.size(); ++i) target.edges.emplace_back(i);
  }
  return target;
}

std::vector<ObstacleLeaves::Target> ObstacleLeaves::targets_of(const Spec& spec, const JointRoles& roles) {
  std::vector<Target> targets;
  for (const Obstacle& obstacle : spec.obstacles) {
    targets.push_back(target_of(obstacle.shape.outer, false));
    targets.back().lowest_layer = obstacle.lowest_layer;
    targets.back().highest_layer = obstacle.highest_layer;
  }
  for (const Body& body : that_keep_direction(spec.bodies)) {
    const auto* disc = std::get_if<Disc>(&body.shape);
    targets.push_back(target_of(disc ? Ring{disc->centre} : std::get<Polygon>(body.shape).outer, false));
    Target& target = targets.back();
    target.lowest_layer = body.lowest_layer;
    target.highest_layer = body.highest_layer;
    target.seen_from = body.at == Carrier::tracer ? roles.tracer : roles.pen;
    if (disc) target.beyond = disc->radius;
  }
  if (spec.table && spec.table->outer.size() <= most_table_edges)
    targets.push_back(target_of(spec.table->outer, true));
  return targets;
}

bool ObstacleLeaves::may_meet(PartName part, const Target& target) const {
  if (!target.seen_from) return true;
  const Part named = part_of(part);
  return named.kind == Part::Kind::link ? !has_joint(named.link, *target.seen_from)
                                        : named.joint != *target.seen_from;
}

bounding::MaterialPoint ObstacleLeaves::origin_of(const Target& target) const {
  const Joint pole = roles_of(task_.root.mode.grounding).pole;
  return bounding::material_point(target.seen_from.value_or(pole), task_.root.mode.s);
}

bounding::MaterialPoint ObstacleLeaves::pole_point() const {
  return bounding::material_point(roles_of(task_.root.mode.grounding).pole, task_.root.mode.s);
}

ObstacleLeaves::ObstacleLeaves(const RootTask& task)
    : task_(task), targets_(targets_of(task.spec, roles_of(task.root.mode.grounding))) {
  const Complex shape = task.root.mode.s;
  const bounding::MaterialPoint pole = pole_point();
  for (std::uint8_t part = 0; part < part_count; ++part) {
    axes_[part] = axis_of(part_of({part}), shape, task.spec.links.style.plate);
    half_widths_[part] = half_width(part_of({part}), task.spec.links.style);
    steadiest_[part] = infinity;
    for (const PartPoint& point : points_along({part}, task.spec.links.style.plate)) {
      const bounding::MaterialPoint at = material_point(point, shape);
      const double strays = strays_beside(at, pole);
      points_[part].push_back({point, at, strays});
      steadiest_[part] = std::min(steadiest_[part], strays);
    }
  }
  for (const Joint one : all_joints)
    for (const Joint other : all_joints)
      unsteadiest_ = std::max(unsteadiest_, strays_beside(bounding::material_point(one, shape),
                                                          bounding::material_point(other, shape)));
  for (const Target& target : targets_) {
    auto& strays = seen_strays_.emplace_back();
    if (!target.seen_from) continue;
    const bounding::MaterialPoint from = origin_of(target);
    for (std::size_t part = 0; part < part_count; ++part)
      for (const AxisPoint& point : points_[part]) strays[part].push_back(strays_beside(point.at, from));
  }
}

double ObstacleLeaves::strays_beside(const bounding::MaterialPoint& at, const bounding::MaterialPoint& from) {
  return std::abs((at.of_a - from.of_a) - (at.of_b - from.of_b));
}

std::optional<Step> ObstacleLeaves::step(Node& node) const {
  if (targets_.empty()) return std::nullopt;
  if (node.guess)
    if (auto step = leaf_for(node, *node.guess)) return step;
  if (!small_enough(node.cell)) return std::nullopt;
  auto near = std::make_shared<NearParts>();
  near->places = task_.places.spread().size();
  std::optional<Step> best;
  const KnownPlace* place = nullptr;
  std::optional<Middle> middle;
  for (const PartBeside& one : to_look_at(node)) {
    if (const KnownPlace& its = task_.places.spread()[one.place]; &its != place) {
      place = &its;
      middle = middle_at(node.cell, its.at);
    }
    const double gap = middle ? gap_to(one.part, one.obstacle, *middle) : 0;
    if (middle && gap > middle->moves + targets_[one.obstacle].left_out) continue;
    near->all.push_back(one);
    if (!middle || gap > 0) continue;
    const auto found = deepest(one.part, one.obstacle, *place, *middle);
    if (!found) continue;
    auto step = leaf_for(node, found->guess);
    if (step && step->children.empty()) return step;
    if (step && !best) best = std::move(step);
  }
  node.near = std::move(near);
  if (best)
    for (Node& child : best->children) child.near = node.near;
  return best;
}

/// What came near in the node that this one was split from, of the parts that still share a layer with the obstacle; at places that are new
/// since then all of them.
std::vector<PartBeside> ObstacleLeaves::to_look_at(const Node& node) const {
  const std::vector<Meeting> meetings = meetings_in(node.assignments);
  std::vector<PartBeside> all;
  std::size_t first_new = 0;
  if (node.near) {
    first_new = node.near->places;
    std::vector<bool> may_share(targets_.size() * part_count);
    for (const auto& [part, obstacle] : meetings) may_share[obstacle * part_count + part.number] = true;
    std::copy_if(
        node.near->all.begin(), node.near->all.end(), std::back_inserter(all),
        [&](const PartBeside& one) { return may_share[one.obstacle * part_count + one.part.number]; });
  }
  for (std::size_t place = first_new; place < task_.places.spread().size(); ++place)
    for (const auto& [part, obstacle] : meetings)
      all.push_back({static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(obstacle), part});
  return all;
}

ObstacleLeaves::ByTheCopy ObstacleLeaves::by_the_copy(const Node& node) const {
  if (node.guess && is_copied(node.guess->leaf.point))
    if (auto step = leaf_for(node, *node.guess)) return {std::move(step), {}};
  struct Deepest {
    double depth = 0;
    ObstacleGuess guess{};
  };
  std::map<std::pair<Joint, std::size_t>, Deepest>
      found;  // parts that have the joint differ in their width alone
  for (const auto& [part, obstacle] : meetings_in(node.assignments)) {
    const double need = needed(part, obstacle);
    for (const auto& [point, at, strays] : points_[part.number]) {
      if (!is_copied(point)) continue;
      const auto [known, is_new] = found.try_emplace({copied_joint(point), obstacle});
      if (!is_new) continue;
      for (const KnownPlace& place : task_.places.many()) {
        const Point seen = copied_place(point, obstacle, place.at, node.cell.pole());
        if (!(circle_depth(seen, obstacle, need) > 0)) continue;
        for (const auto& edge : targets_[obstacle].edges)
          if (const double here = depth_by_few(seen, obstacle, edge, need); here > known->second.depth)
            known->second = {here, {{obstacle, edge, place.place, point}, place.at}};
      }
    }
  }
  ByTheCopy answer;
  double most = 0;
  for (const auto& [key, deepest] : found) {
    if (!(deepest.depth > 0)) continue;
    if (auto step = leaf_for(node, deepest.guess)) return {std::move(step), {}};
    if (deepest.depth > most) most = deepest.depth, answer.guess = deepest.guess;
  }
  return answer;
}

/// Where a copied point stands with the tracer at a place and the pole at another, as seen from what carries the obstacle.
Point ObstacleLeaves::copied_place(const PartPoint& point, std::size_t obstacle, const Point& place,
                                   const Point& pole) const {
  const JointRoles roles = roles_of(task_.root.mode.grounding);
  const auto at = [&](Joint joint) -> Point {
    if (joint == roles.pole) return pole;
    if (joint == roles.tracer) return place;
    return pole + as_point(task_.spec.copy.k() * as_complex(place - pole));
  };
  const std::optional<Joint>& carrier = targets_[obstacle].seen_from;
  return carrier ? Point(at(copied_joint(point)) - at(*carrier)) : at(copied_joint(point));
}

std::optional<KnownPlace> ObstacleLeaves::place_met(const Node& node) const {
  if (targets_.empty()) return std::nullopt;
  const std::vector<Meeting> meetings = meetings_in(node.assignments);
  std::optional<KnownPlace> found;
  double most = 0;
  for (const KnownPlace& place : task_.places.many()) {
    const auto middle = middle_at(node.cell, place.at);
    if (!middle) continue;
    for (const auto& [part, obstacle] : meetings)
      if (const auto here = deepest(part, obstacle, place, *middle); here && here->depth > most) {
        most = here->depth;
        found = place;
      }
  }
  return found;
}

std::vector<ObstacleLeaves::Meeting> ObstacleLeaves::meetings_in(const Assignments& assignments) const {
  std::vector<Meeting> meetings;
  for (std::size_t obstacle = 0; obstacle < targets_.size(); ++obstacle)
    for (std::uint8_t part = 0; part < part_count; ++part)
      if (may_meet({part}, targets_[obstacle]) &&
          std::any_of(assignments.begin(), assignments.end(),
                      [&](std::uint32_t i) { return share(i, {part}, targets_[obstacle]); }))
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

/// Never more than depth(): the polygon of some corners lies inside the convex outline.
double ObstacleLeaves::depth_by_few(const Point& at, std::size_t obstacle,
                                    const std::optional<std::size_t>& edge, double needed) const {
  if (edge) return depth(at, obstacle, edge, needed);
  return needed - distance_from(as_complex(at), targets_[obstacle].few);
}

double ObstacleLeaves::needed(PartName part, std::size_t obstacle) const {
  return half_widths_[part.number] + task_.spec.limits.clearance + targets_[obstacle].beyond;
}

bool ObstacleLeaves::hits(const ObstacleGuess& guess, const DesignCell& cell) const {
  const PartPoint& point = guess.leaf.point;
  const Target& target = targets_[guess.leaf.obstacle];
  const bounding::MaterialPoint at = material_point(point, task_.root.mode.s), origin = origin_of(target);
  const auto range = point_over(task_.root, cell, guess.place, {at.of_a - origin.of_a, at.of_b - origin.of_b},
                                is_copied(point), target.seen_from.has_value());
  if (!range) return false;
  const double need = needed(point.part, guess.leaf.obstacle);
  const double enough = of_the_way * range->away + slack::in_hand;
  const double by_few = depth_by_few(range->middle, guess.leaf.obstacle, guess.leaf.edge, need);
  if (by_few > enough) return true;
  if (by_few + target.left_out <= enough) return false;
  return depth(range->middle, guess.leaf.obstacle, guess.leaf.edge, need) > enough;
}

Assignments ObstacleLeaves::sharing(const Assignments& all, PartName part, std::size_t obstacle) const {
  Assignments some;
  for (const std::uint32_t i : all)
    if (share(i, part, targets_[obstacle])) some.push_back(i);
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
  const bounding::MaterialPoint pole = pole_point();
  for (const Joint joint : all_joints) {
    const bounding::MaterialPoint m = bounding::material_point(joint, task_.root.mode.s);
    middle.joints[static_cast<std::size_t>(joint)] =
        as_point(as_complex(cell.pole()) + p * (m.of_a - pole.of_a) + (w - p) * (m.of_b - pole.of_b));
  }
  middle.unsteady = (cell.half(Variable::a) + cell.half(Variable::b)) * 2 * a * b / h;
  const double poles = std::hypot(cell.half(Variable::x), cell.half(Variable::y)), g = std::abs(task_.root.g);
  middle.moves = of_the_way * (unsteadiest_ * middle.unsteady +
                               poles * (1 + (1 + unsteadiest_) * g * (2 + a / std::sqrt(r) + 2 * a * b / h)));
  return middle;
}

/// Where the joint is that carries a target; 0 for what rests on the table.
Point ObstacleLeaves::carrier_place(const Target& target, const Middle& middle) {
  return target.seen_from ? middle.joints[static_cast<std::size_t>(*target.seen_from)] : Point(Point::Zero());
}

/// True if no point of the part can lie so deep in the obstacle that it does all over the cell.
bool ObstacleLeaves::out_of_reach(PartName part, std::size_t obstacle, const Middle& middle) const {
  const Target& target = targets_[obstacle];
  const double need = needed(part, obstacle);
  if (!target.seen_from && of_the_way * steadiest_[part.number] * middle.unsteady > need + target.deepest)
    return true;
  return keeps_off(part, obstacle, middle, 0);
}

/// True if no point of the part comes as near to a circle around the obstacle as what it needs and `beyond` (mm) more.
bool ObstacleLeaves::keeps_off(PartName part, std::size_t obstacle, const Middle& middle,
                               double beyond) const {
  const Target& target = targets_[obstacle];
  const Point centre = carrier_place(target, middle) + target.centre;
  const double away = needed(part, obstacle) + target.radius + beyond;
  return std::all_of(axes_[part.number].begin(), axes_[part.number].end(), [&](const JointHull& piece) {
    return keeps_away(placed(piece, middle.joints), centre, away);
  });
}

/// How much farther than it needs a part keeps from an obstacle, or from the edges of one that is looked at by these, mm; no more than 0 where
/// it comes as near as that. What is more than the design moves may be less than it is, and what a circle around the obstacle tells is as much
/// as that.
double ObstacleLeaves::gap_to(PartName part, std::size_t obstacle, const Middle& middle) const {
  const Target& target = targets_[obstacle];
  const double beyond = middle.moves + target.left_out;
  if (keeps_off(part, obstacle, middle, beyond)) return infinity;
  if (keeps_off(part, obstacle, middle, 0)) return beyond;
  const double need = needed(part, obstacle);
  const Point origin = carrier_place(target, middle);
  double least = infinity;
  for (const JointHull& piece : axes_[part.number]) {
    const Hull hull = placed(piece, middle.joints);
    if (target.outline) {
      std::array<Complex, 3> corners{};
      for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = as_complex(hull.at[i] - origin);
      const std::span seen(corners.data(), static_cast<std::size_t>(hull.count));
      least = std::min(least, convex_distance(seen, *target.outline, need + beyond) - need);
      continue;
    }
    for (std::size_t i = 0; i < target.corners.size(); ++i) {
      const Point from = origin + as_point(target.corners[i]),
                  to = origin + as_point(target.corners[(i + 1) % target.corners.size()]);
      if (!keeps_to_one_side(hull, from, to, need + beyond))
        least = std::min(least, distance(hull, Hull{{from, to, to}, 2}) - need);
    }
  }
  return least;
}

/// The edges of a target, which is looked at by its edges, that the part comes near enough to.
std::vector<std::optional<std::size_t>> ObstacleLeaves::edges_in_reach(PartName part, std::size_t obstacle,
                                                                       const Middle& middle) const {
  constexpr double rounding = 1 + 1e-9;
  const Target& target = targets_[obstacle];
  const Point origin = carrier_place(target, middle);
  const double need = needed(part, obstacle) * rounding;
  const auto corner = [&](std::size_t i) {
    return Point(origin + as_point(target.corners[i % target.corners.size()]));
  };
  std::vector<std::optional<std::size_t>> near;
  for (const auto& edge : target.edges) {
    const Point from = corner(*edge), to = corner(*edge + 1);
    const auto is_near = [&](const JointHull& piece) {
      const Hull hull = placed(piece, middle.joints);
      return !keeps_to_one_side(hull, from, to, need) && distance(hull, Hull{{from, to, to}, 2}) <= need;
    };
    if (std::any_of(axes_[part.number].begin(), axes_[part.number].end(), is_near)) near.push_back(edge);
  }
  return near;
}

/// On each bar of a part's axis the points nearest to an outline's corners, centre and, where it crosses them, edges. Points spread
/// along a long bar may all lie too far from a small obstacle.
std::vector<PartPoint> ObstacleLeaves::nearest_points(
    PartName part, const Target& target, const std::function<Point(const PartPoint&)>& place_of) const {
  std::vector<PartPoint> points;
  for (const auto& side : sides_of(part, task_.spec.links.style.plate)) {
    const Point from = place_of(side[0]), to = place_of(side[1]);
    points.push_back(on_side(side, nearest_share(target.centre, from, to)));
    Point nearest = target.centre;
    for (std::size_t i = 0; i < target.few.size(); ++i) {
      const Point corner = as_point(target.few[i]), next = as_point(target.few[(i + 1) % target.few.size()]);
      if (squared_distance(corner, from, to) < squared_distance(nearest, from, to) || i == 0)
        nearest = corner;
      if (properly_cross(from, to, corner, next))
        points.push_back(
            on_side(side, cross(corner - from, next - corner) / cross(to - from, next - corner)));
    }
    points.push_back(on_side(side, nearest_share(nearest, from, to)));
  }
  return points;
}

/// The point that is deepest beyond what it strays.
std::optional<ObstacleLeaves::Depth> ObstacleLeaves::deepest(PartName part, std::size_t obstacle,
                                                             const KnownPlace& place,
                                                             const Middle& middle) const {
  if (out_of_reach(part, obstacle, middle)) return std::nullopt;
  const Target& target = targets_[obstacle];
  const bool by_edges = target.edges.front().has_value();
  const auto some = by_edges ? edges_in_reach(part, obstacle, middle) : decltype(target.edges){};
  const auto& edges = by_edges ? some : target.edges;
  if (edges.empty()) return std::nullopt;
  const double need = needed(part, obstacle);
  const bounding::MaterialPoint from = origin_of(target);
  ObstacleGuess best;
  double most = 0;
  const auto joint = [&](Joint name) { return as_complex(middle.joints[static_cast<std::size_t>(name)]); };
  const Complex V = joint(Joint::V), p = joint(Joint::A) - V,
                q = joint(Joint::X) - joint(Joint::A);  // q: q/s
  const Complex origin = as_complex(carrier_place(target, middle));
  const auto seen = [&](const bounding::MaterialPoint& m) {
    return as_point(V + m.of_a * p + m.of_b * q - origin);
  };
  const auto look_at = [&](const PartPoint& point, const bounding::MaterialPoint& m, double strays) {
    const double least = of_the_way * strays * middle.unsteady;
    if (!(need + target.deepest > most + least)) return;  // no place is so deep
    const Point at = seen(m);
    if (!(circle_depth(at, obstacle, need) > most + least)) return;
    for (const auto& edge : edges)
      if (const double here = depth_by_few(at, obstacle, edge, need) - least; here > most) {
        most = here;
        best = {{obstacle, edge, place.place, point}, place.at};
      }
  };
  const std::vector<AxisPoint>& points = points_[part.number];
  for (std::size_t i = 0; i < points.size(); ++i)
    look_at(points[i].point, points[i].at,
            target.seen_from ? seen_strays_[obstacle][part.number][i] : points[i].strays);
  if (most > 0) return Depth{best, most};
  const Complex shape = task_.root.mode.s;
  const auto place_of = [&](const PartPoint& point) { return seen(material_point(point, shape)); };
  for (const PartPoint& point : nearest_points(part, target, place_of)) {
    const bounding::MaterialPoint m = material_point(point, shape);
    look_at(point, m, strays_beside(m, from));
  }
  if (most > 0) return Depth{best, most};
  return std::nullopt;
}

/// At least the depth: from a circle around the obstacle. Outside it the obstacle is no nearer than the circle.
double ObstacleLeaves::circle_depth(const Point& at, std::size_t obstacle, double need) const {
  const Target& target = targets_[obstacle];
  const double away = (at - target.centre).norm();
  return need + (away > target.radius ? 1 : 2) * target.radius - away;
}

}  // namespace kempe::certificate
