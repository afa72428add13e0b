#include "workspace/contact/contact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kempe {
namespace {

/// Distances are rounded by less than this share of the coordinates they come from, but for the linkage's direction.
constexpr double distance_rounding = 1e-14;

double farthest_of(const LinkageMotion& motion, const JointHull& hull) {
  double farthest = 0;
  for (int corner = 0; corner < hull.count; ++corner)
    farthest = std::max(farthest, motion.farthest(hull.joints[static_cast<std::size_t>(corner)]));
  return farthest;
}

/// What rounding may turn the whole linkage by, rad: its direction is that of the chain p + q/s, whose two terms nearly cancel
/// where the tracer comes near the pole.
double direction_rounding(const MapTask& task) {
  constexpr double few_ulp = 8 * std::numeric_limits<double>::epsilon();
  const CopyingLinkage& linkage = task.linkage;
  const OpeningInterval openings = linkage.openings_with_transmission(task.transmission);
  if (openings.empty()) return 0;
  const double chain =
      chain_length_per_tracer(linkage.k(), linkage.grounding()) * linkage.radii_over(openings).lower;
  return few_ulp * (linkage.VA() + linkage.VB() / std::abs(linkage.shape())) / chain;
}

/// Distance from the origin to a box: nothing inside can be nearer.
double distance_from_origin(const Box& box) { return distance(box, {Point::Zero(), Point::Zero()}); }

}  // namespace

ContactScene::ContactScene(const MapTask& task, double within) : motion(task.linkage) {
  for (const Part& part : parts_of(task.linkage, task.layers)) {
    if (part.kind == Part::Kind::pole_post || part.lowest_layer > part.highest_layer) continue;
    for (const JointHull& hull : axis_of(part, task.linkage.shape(), task.style.plate))
      pieces.push_back({part, hull, half_width(part, task.style), farthest_of(motion, hull)});
  }
  double size = 0;
  for (const ScenePiece& piece : pieces) size = std::max(size, piece.farthest + piece.half_width);
  const double turned = direction_rounding(task) * size;
  for (std::size_t number = 0; number < task.obstacles.size(); ++number) {
    const Obstacle& given = task.obstacles[number];
    SceneObstacle obstacle{EdgeTree(given.shape, task.linkage.pole()), number, 0};
    if (obstacle.edges.empty()) continue;
    obstacle.slack = turned + distance_rounding * (size + task.clearance + obstacle.edges.magnitude() +
                                                   task.linkage.pole().norm());
    const std::size_t before = encounters.size();
    const double nearest = distance_from_origin(obstacle.edges.node(0).box) - obstacle.slack;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (share_layer(pieces[i].part, given) && nearest < pieces[i].farthest + pieces[i].half_width + within)
        encounters.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(obstacles.size())});
    if (encounters.size() > before) obstacles.push_back(std::move(obstacle));
  }
}

namespace {

/// Distance between a hull and an obstacle, 0 if it lies inside, or some figure >= `enough` if it is larger.
double distance_to(const SceneObstacle& obstacle, const MovingHull& hull, double enough) {
  double least = enough;
  for_each_edge(
      obstacle.edges, [&](const Box& box) { return distance_from_box(hull, box) < least; },
      [&](const EdgeTree::Edge& edge) { least = std::min(least, distance_to_edge(hull, edge)); });
  return obstacle.edges.winds_around(hull[0].at) ? 0 : least;
}

}  // namespace

ObstacleGap tightest_obstacle(const ContactScene& scene, double opening, double bearing) {
  ObstacleGap tightest{std::numeric_limits<double>::infinity()};
  const MovingJoints joints = scene.motion.over(opening, 0, bearing, 0);
  for (const Encounter& pair : scene.encounters) {
    const ScenePiece& piece = scene.pieces[pair.piece];
    const double gap = distance_to(scene.obstacles[pair.obstacle], {joints, piece.hull, {}},
                                   tightest.gap + piece.half_width) -
                       piece.half_width;
    if (gap < tightest.gap) tightest = {gap, pair};
  }
  return tightest;
}

namespace {

Part pole_post_of(const MapTask& task) {
  Part post;
  for (const Part& part : parts_of(task.linkage, task.layers))
    if (part.kind == Part::Kind::pole_post) post = part;
  return post;
}

}  // namespace

std::vector<PoleGap> gaps_at_pole(const MapTask& task) {
  const Part post = pole_post_of(task);
  // A pole in the lowest layer's link stands in its layer too: the joint itself must be clear.
  const int highest = std::max(post.highest_layer, 1);
  std::vector<PoleGap> gaps;
  for (std::size_t number = 0; number < task.obstacles.size(); ++number) {
    const Obstacle& obstacle = task.obstacles[number];
    if (obstacle.lowest_layer > highest) continue;
    const double away = distance(Region{{obstacle.shape}}, task.linkage.pole());
    gaps.push_back({name(post), number, away - half_width(post, task.style)});
  }
  return gaps;
}

std::optional<std::size_t> obstacle_at_pole(const MapTask& task) {
  for (const PoleGap& at : gaps_at_pole(task))
    if (at.gap < task.clearance) return at.obstacle;
  return std::nullopt;
}

std::optional<PoleGap> tightest_at_pole(const MapTask& task) {
  const std::vector<PoleGap> gaps = gaps_at_pole(task);
  const auto tightest = std::min_element(gaps.begin(), gaps.end(),
                                         [](const PoleGap& a, const PoleGap& b) { return a.gap < b.gap; });
  return tightest == gaps.end() ? std::nullopt : std::optional(*tightest);
}

}  // namespace kempe
