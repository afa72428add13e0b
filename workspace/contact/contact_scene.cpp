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

SceneFrame frame_of(const std::optional<Carrier>& carrier) {
  if (!carrier) return SceneFrame::table;
  return *carrier == Carrier::tracer ? SceneFrame::tracer : SceneFrame::pen;
}

/// Pieces of the linkage's parts.
std::vector<ScenePiece> pieces_of(const MapTask& task) {
  std::vector<ScenePiece> pieces;
  for (const Part& part : parts_of(task.linkage, task.layers)) {
    if (part.lowest_layer > part.highest_layer) continue;
    for (const JointHull& hull : axis_of(part, task.linkage.shape(), task.style.plate))
      pieces.push_back({part, hull, half_width(part, task.style), name(part)});
  }
  return pieces;
}

/// A body's point.
ScenePiece point_of(const Obstruction::Met& body, const CopyingLinkage& linkage) {
  const Joint joint = joint_of(body.by, linkage);
  const Part::Kind kind = body.by == Carrier::tracer ? Part::Kind::tracer_post : Part::Kind::pen_post;
  return {{kind, {}, joint, 1, most_layers}, {{joint, joint, joint}, 1}, 0, body.name};
}

}  // namespace

ContactScene::ContactScene(const MapTask& task, double within)
    : motion(task.linkage), carried{LinkageMotion(task.linkage, task.linkage.tracer_joint()),
                                    LinkageMotion(task.linkage, task.linkage.pen_joint())},
      pieces(pieces_of(task)) {
  const std::size_t of_linkage = pieces.size();
  const std::vector<Obstruction> obstructions = obstructions_of(task.obstacles, task.bodies, task.table);
  double size = 0;
  for (const Obstruction& obstruction : obstructions)
    for (const ScenePiece& piece : pieces)
      size =
          std::max(size, farthest_of(motion_in(frame_of(obstruction.frame)), piece.hull) + piece.half_width);
  const double turned = direction_rounding(task) * size;
  for (std::size_t number = 0; number < obstructions.size(); ++number) {
    const Obstruction& obstruction = obstructions[number];
    const SceneFrame frame = frame_of(obstruction.frame);
    const bool at_rest = frame == SceneFrame::table;
    SceneObstacle obstacle{EdgeTree(obstruction.shape, at_rest ? task.linkage.pole() : Point::Zero()),
                           frame,
                           obstruction.grown,
                           number,
                           obstruction.name,
                           0};
    if (obstacle.edges.empty()) continue;
    obstacle.slack = turned + distance_rounding * (size + task.clearance + obstacle.edges.magnitude() +
                                                   (at_rest ? task.linkage.pole().norm() : 0.0));
    const std::size_t before = encounters.size();
    const double nearest =
        distance_from_origin(obstacle.edges.node(0).box) - obstacle.slack - obstruction.grown;
    const auto meet = [&](std::size_t piece) {
      const ScenePiece& one = pieces[piece];
      if (nearest < farthest_of(motion_in(frame), one.hull) + one.half_width + within)
        encounters.push_back(
            {static_cast<std::uint16_t>(piece), static_cast<std::uint16_t>(obstacles.size())});
    };
    for (std::size_t i = 0; i < of_linkage; ++i) {
      const bool moves = !at_rest || pieces[i].part.kind != Part::Kind::pole_post;
      if (moves && may_meet(pieces[i].part, obstruction, task.linkage)) meet(i);
    }
    if (obstruction.met) {
      pieces.push_back(point_of(*obstruction.met, task.linkage));
      meet(pieces.size() - 1);
    }
    if (encounters.size() == before) continue;
    obstacles.push_back(std::move(obstacle));
    if (std::find(frames.begin(), frames.end(), frame) == frames.end()) frames.push_back(frame);
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
  FramedJoints joints{};
  for (const SceneFrame frame : scene.frames)
    joints[static_cast<std::size_t>(frame)] = scene.motion_in(frame).over(opening, 0, bearing, 0);
  for (const Encounter& pair : scene.encounters) {
    const ScenePiece& piece = scene.pieces[pair.piece];
    const SceneObstacle& obstacle = scene.obstacles[pair.obstacle];
    const double around = piece.half_width + obstacle.grown;
    const double gap =
        distance_to(obstacle, {joints[static_cast<std::size_t>(obstacle.frame)], piece.hull, {}},
                    tightest.gap + around) -
        around;
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
  for (const Obstruction& obstruction : obstructions_of(task.obstacles, {}, task.table)) {
    if (obstruction.lowest_layer > highest) continue;
    const double away = distance(obstruction.shape, task.linkage.pole());
    gaps.push_back({name(post), obstruction.name, away - half_width(post, task.style)});
  }
  return gaps;
}

std::optional<std::string> obstacle_at_pole(const MapTask& task) {
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
