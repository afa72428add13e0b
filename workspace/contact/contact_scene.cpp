#include "workspace/contact/contact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kempe {
namespace {

/// Distances are rounded by less than this share of the coordinates they come from, but for the linkage's direction.
constexpr double distance_rounding = 1e-14;

double farthest_of(const LinkageMotion& motion, const PointHull& hull) {
  double farthest = 0;
  for (int corner = 0; corner < hull.count; ++corner)
    farthest =
        std::max(farthest, motion.farthest(std::size_t{hull.points[static_cast<std::size_t>(corner)]}));
  return farthest;
}

/// What rounding may turn the whole linkage by, rad: its direction is that of the chain p + q/s, whose two terms nearly cancel
/// where the tracer comes near the pole.
double direction_rounding(const MapTask& task) {
  constexpr double few_ulp = 8 * std::numeric_limits<double>::epsilon();
  const CopyingLinkage& linkage = task.linkage;
  const OpeningInterval openings = linkage.openings_with_transmission(task.limits.transmission);
  if (openings.empty()) return 0;
  const double chain =
      chain_length_per_tracer(linkage.k(), linkage.grounding()) * linkage.radii_over(openings).lower;
  return few_ulp * (linkage.VA() + linkage.VB() / std::abs(linkage.shape())) / chain;
}

/// Distance from the origin to a box: nothing inside can be nearer.
double distance_from_origin(const Box& box) { return distance(box, {Point::Zero(), Point::Zero()}); }

SceneFrame frame_of(const Obstruction& obstruction) {
  if (obstruction.turns_with)
    return static_cast<SceneFrame>(static_cast<std::size_t>(SceneFrame::VA) +
                                   static_cast<std::size_t>(*obstruction.turns_with));
  if (!obstruction.frame) return SceneFrame::table;
  return *obstruction.frame == Carrier::tracer ? SceneFrame::tracer : SceneFrame::pen;
}

bool any_turns(const std::vector<Body>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.turns_with; });
}

/// The corners of all pieces of bodies that turn with a link, in their order.
std::vector<LinkagePoint> corners_of(const MapTask& task) {
  std::vector<LinkagePoint> corners;
  for (const Body& body : task.bodies)
    if (body.turns_with)
      for (const ConvexPart& piece : pieces_of(body).pieces)
        for (const Complex& corner : piece)
          corners.push_back(point_on_link(corner, *body.turns_with, task.linkage));
  return corners;
}

std::vector<LinkageMotion> seen_from_links(const MapTask& task, const std::vector<LinkagePoint>& corners) {
  std::vector<LinkageMotion> motions;
  if (any_turns(task.bodies))
    for (const Link link : all_links) motions.emplace_back(task.linkage, link, corners);
  return motions;
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

/// A post where a body is mounted.
Part mount_of(Carrier carrier, const CopyingLinkage& linkage) {
  const Part::Kind kind = carrier == Carrier::tracer ? Part::Kind::tracer_post : Part::Kind::pen_post;
  return {kind, {}, joint_of(carrier, linkage), 1, most_layers};
}

/// A body's point.
ScenePiece point_of(const Obstruction::Met& body, const CopyingLinkage& linkage) {
  const Part mount = mount_of(body.by, linkage);
  return {mount, JointHull{{mount.joint, mount.joint, mount.joint}, 1}, 0, body.name};
}

/// Of each body its pieces, if it turns; their corners are numbered as corners_of() has them.
std::vector<std::vector<ScenePiece>> turning_pieces_of(const MapTask& task) {
  std::vector<std::vector<ScenePiece>> of_bodies(task.bodies.size());
  std::size_t number = all_joints.size();
  for (std::size_t i = 0; i < task.bodies.size(); ++i) {
    const Body& body = task.bodies[i];
    if (!body.turns_with) continue;
    const BodyPieces all = pieces_of(body);
    for (const ConvexPart& piece : all.pieces) {
      PointHull hull;
      hull.count = static_cast<int>(piece.size());
      for (std::size_t corner = 0; corner < piece.size(); ++corner)
        hull.points[corner] = static_cast<std::uint32_t>(number++);
      of_bodies[i].push_back({mount_of(body.at, task.linkage), hull, all.grown, body_name(task.bodies, i)});
    }
  }
  return of_bodies;
}

}  // namespace

void Encounters::add(const Encounter& between, SceneFrame frame) {
  pairs.push_back(between);
  if (std::find(frames.begin(), frames.end(), frame) == frames.end()) frames.push_back(frame);
}

ContactScene::ContactScene(const MapTask& task, double within)
    : corners(corners_of(task)), motion(task.linkage, task.linkage.pole_joint(), corners),
      carried{LinkageMotion(task.linkage, task.linkage.tracer_joint(), corners),
              LinkageMotion(task.linkage, task.linkage.pen_joint(), corners)},
      linked(seen_from_links(task, corners)), pieces(pieces_of(task)) {
  const std::size_t of_linkage = pieces.size();
  std::vector<std::size_t> first_of_body;  // its first piece; at the end where the next would begin
  for (std::vector<ScenePiece>& of_body : turning_pieces_of(task)) {
    first_of_body.push_back(pieces.size());
    for (ScenePiece& piece : of_body) pieces.push_back(std::move(piece));
  }
  first_of_body.push_back(pieces.size());
  const std::vector<Obstruction> obstructions = obstructions_of(task.obstacles, task.bodies, task.table);
  double size = 0;
  for (const Obstruction& obstruction : obstructions)
    for (const ScenePiece& piece : pieces)
      size = std::max(size, farthest_of(motion_in(frame_of(obstruction)), piece.hull) + piece.half_width);
  const double turned = direction_rounding(task) * size;
  for (std::size_t number = 0; number < obstructions.size(); ++number) {
    const Obstruction& obstruction = obstructions[number];
    const SceneFrame frame = frame_of(obstruction);
    const bool at_rest = frame == SceneFrame::table;
    SceneObstacle obstacle{
        EdgeTree(obstruction.shape, at_rest ? task.linkage.pole() : Point::Zero(), EdgeTree::Chords::kept),
        frame,
        obstruction.grown,
        number,
        obstruction.name,
        0};
    if (obstacle.edges.empty()) continue;
    obstacle.slack = turned + distance_rounding * (size + task.limits.clearance + obstacle.edges.magnitude() +
                                                   (at_rest ? task.linkage.pole().norm() : 0.0));
    const std::size_t before = encounters.pairs.size();
    const double nearest =
        distance_from_origin(obstacle.edges.node(0).box) - obstacle.slack - obstruction.grown;
    const auto meet = [&](std::size_t piece) {
      const ScenePiece& one = pieces[piece];
      const Apart apart{nearest, farthest_of(motion_in(frame), one.hull) + one.half_width};
      if (!apart.may_come_within(within)) return;
      encounters.add({static_cast<std::uint32_t>(piece), static_cast<std::uint32_t>(obstacles.size())},
                     frame);
      apart_.push_back(apart);
    };
    for (std::size_t i = 0; i < of_linkage; ++i) {
      const bool moves = !at_rest || pieces[i].part.kind != Part::Kind::pole_post;
      if (moves && may_meet(pieces[i].part, obstruction, task.linkage)) meet(i);
    }
    for (const std::size_t body : obstruction.turning)
      for (std::size_t i = first_of_body[body]; i < first_of_body[body + 1]; ++i) meet(i);
    if (obstruction.met) {
      pieces.push_back(point_of(*obstruction.met, task.linkage));
      meet(pieces.size() - 1);
    }
    if (encounters.pairs.size() == before) continue;
    obstacles.push_back(std::move(obstacle));
  }
}

Encounters ContactScene::nearer_than(double gap) const {
  Encounters nearer;
  for (std::size_t i = 0; i < apart_.size(); ++i)
    if (apart_[i].may_come_within(gap))
      nearer.add(encounters.pairs[i], obstacles[encounters.pairs[i].obstacle].frame);
  return nearer;
}

namespace {

/// Distance between a hull and an obstacle, 0 if it lies inside, or some figure >= `enough` if it is larger.
double distance_to(const SceneObstacle& obstacle, const MovingHull& hull, double enough) {
  double least = enough;
  const BoxDistance from_hull(hull);
  for_each_edge(
      obstacle.edges, [&](const Box& box) { return from_hull.is_below(least, box); },
      [&](const EdgeTree::Edge& edge) { least = std::min(least, distance_to_edge(hull, edge)); });
  return obstacle.edges.winds_around(hull[0].at) ? 0 : least;
}

}  // namespace

ObstacleGap tightest_obstacle(const ContactScene& scene, const Encounters& encounters, double opening,
                              double bearing) {
  ObstacleGap tightest{std::numeric_limits<double>::infinity()};
  FramedJoints joints{};
  for (const SceneFrame frame : encounters.frames)
    joints[static_cast<std::size_t>(frame)] = scene.motion_in(frame).over(opening, 0, bearing, 0);
  for (const Encounter& pair : encounters.pairs) {
    const ScenePiece& piece = scene.pieces[pair.piece];
    const SceneObstacle& obstacle = scene.obstacles[pair.obstacle];
    const double around = piece.half_width + obstacle.grown;
    const double gap =
        distance_to(obstacle, {joints[static_cast<std::size_t>(obstacle.frame)], piece.hull, HalfSides{}},
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

std::optional<PoleGap> tightest(const std::vector<PoleGap>& gaps) {
  const auto least = std::min_element(gaps.begin(), gaps.end(),
                                      [](const PoleGap& a, const PoleGap& b) { return a.gap < b.gap; });
  return least == gaps.end() ? std::nullopt : std::optional(*least);
}

std::optional<std::string> obstacle_within(double clearance, const std::vector<PoleGap>& gaps) {
  for (const PoleGap& at : gaps)
    if (at.gap < clearance) return at.obstacle;
  return std::nullopt;
}

}  // namespace kempe
