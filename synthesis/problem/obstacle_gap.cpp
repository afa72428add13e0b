#include "synthesis/problem/obstacle_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/complex_vectors.hpp"
#include "geometry/region_reach.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

struct PieceCorners {
  std::array<Complex, 3> at;
  std::size_t count;
  PieceCorners(const ObstacleTerm& term, const PlacedJoints& joints)
      : at{}, count(static_cast<std::size_t>(term.piece.hull.count)) {
    const Complex origin = term.seen_from ? joints[*term.seen_from] : 0;
    for (std::size_t i = 0; i < count; ++i) at[i] = joints[term.piece.hull.joints[i]] - origin;
    if (term.beside)
      for (std::size_t i = 0; i < count; ++i)
        at[i] += joints.axis(term.beside->link) * term.beside->corners[i];
    if (term.turns_with)
      for (std::size_t i = 0; i < count; ++i) at[i] *= std::conj(joints.axis(*term.turns_with));
  }
  ConvexCorners span() const { return {at.data(), count}; }
};

PlacedJoints::Motion multiple(Complex factor, const PlacedJoints::Turning& of) {
  return {factor * of.by_u, factor * of.by_v, factor * of.by_pole_x, factor * of.by_pole_y};
}

PlacedJoints::Motion multiple(Complex factor, const PlacedJoints::Motion& of) {
  return {factor * of.by_u, factor * of.by_v, factor * of.by_pole_x, factor * of.by_pole_y};
}

PlacedJoints::Motion difference(const PlacedJoints::Motion& one, const PlacedJoints::Motion& other) {
  return {one.by_u - other.by_u, one.by_v - other.by_v, one.by_pole_x - other.by_pole_x,
          one.by_pole_y - other.by_pole_y};
}

PlacedJoints::Motion sum(const PlacedJoints::Motion& one, const PlacedJoints::Motion& other) {
  return {one.by_u + other.by_u, one.by_v + other.by_v, one.by_pole_x + other.by_pole_x,
          one.by_pole_y + other.by_pole_y};
}

/// How a corner of the term's piece moves in the frame of its obstruction, where it stands at `at`.
PlacedJoints::Motion motion_of(const ObstacleTerm& term, std::size_t corner, Complex at,
                               const PlacedJoints& joints) {
  PlacedJoints::Motion motion = joints.motion(term.piece.hull.joints[corner]);
  if (term.beside) {
    const Link link = term.beside->link;
    const Complex offset = joints.axis(link) * term.beside->corners[corner];
    motion = sum(motion, multiple(i_unit * offset, joints.turning(link)));
  }
  if (term.seen_from) motion = difference(motion, joints.motion(*term.seen_from));
  if (term.turns_with)
    motion = difference(multiple(std::conj(joints.axis(*term.turns_with)), motion),
                        multiple(i_unit * at, joints.turning(*term.turns_with)));
  return motion;
}

/// Distance of a point from a bar's axis, or from a plate; negative: how deep it lies in the plate.
double distance_to_axis(const PieceCorners& piece, Complex point) {
  if (piece.count > 2) return distance_from(point, piece.span());
  const Complex from = piece.at[0], to_point = point - from;
  if (piece.count == 1) return std::sqrt(std::norm(to_point));
  const Complex axis = piece.at[1] - from;  // of two joints that are apart: nearest_share() without its test
  const double share = std::clamp(dot(axis, to_point) / std::norm(axis), 0.0, 1.0);
  return std::sqrt(std::norm(to_point - share * axis));
}

/// True if distance_to_axis() of the point is more than `distance`. Of points and bars it needs no square root and no division.
bool is_farther(const PieceCorners& piece, Complex point, double distance) {
  if (piece.count > 2) return distance_from(point, piece.span()) > distance;
  const double squared = distance * std::abs(distance);  // of a negative distance negative: all is farther
  const Complex to_point = point - piece.at[0];
  if (piece.count == 1) return std::norm(to_point) > squared;
  const Complex axis = piece.at[1] - piece.at[0];
  const double length_squared = std::norm(axis);
  const double along = std::clamp(dot(axis, to_point), 0.0, length_squared);
  return std::norm(length_squared * to_point - along * axis) > squared * length_squared * length_squared;
}

/// The middle of the corners' box, and the radius around it that holds them.
template <typename Corners>
std::pair<Complex, double> circle_around(const Corners& corners) {
  Complex lower = corners.front(), upper = lower;
  for (const Complex& z : corners) {
    lower = {std::min(lower.real(), z.real()), std::min(lower.imag(), z.imag())};
    upper = {std::max(upper.real(), z.real()), std::max(upper.imag(), z.imag())};
  }
  const Complex centre = 0.5 * (lower + upper);
  double radius = 0;
  for (const Complex& z : corners) radius = std::max(radius, std::abs(z - centre));
  return {centre, radius};
}

/// Convex parts of so many corners are cut; into about so many pieces.
constexpr std::size_t many_corners = 128, arcs = 60;

/// A part, or of a round one a polygon of few of its corners and what lies between that and its outline: together they are the part. Gaps are the
/// same, and depths to within the height of an arc.
std::vector<ConvexPart> cut_to_arcs(ConvexPart part) {
  if (part.size() <= many_corners) return {std::move(part)};
  const std::size_t step = (part.size() + arcs - 1) / arcs;
  std::vector<ConvexPart> pieces(1);
  for (std::size_t first = 0; first < part.size(); first += step) {
    pieces.front().push_back(part[first]);
    ConvexPart arc;
    for (std::size_t i = first; i <= std::min(first + step, part.size()); ++i)
      arc.push_back(part[i % part.size()]);
    const Complex chord = arc.back() - arc.front();
    const bool is_flat = std::all_of(arc.begin(), arc.end(), [&](Complex corner) {
      return std::abs(cross(chord, corner - arc.front())) <= slack::flat_arc * std::norm(chord);
    });
    if (!is_flat) pieces.push_back(std::move(arc));
  }
  return pieces;
}

/// So few parts are looked at one by one.
constexpr std::size_t few_parts = 16;

/// Groups `count` parts from `first` on, which it puts into the groups' order.
void group_parts(ObstacleShape& shape, std::size_t first, std::size_t count) {
  const auto begin = shape.parts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  std::vector<Complex> centres;
  for (auto part = begin; part != end; ++part) centres.push_back(part->centre);
  const Complex centre = circle_around(centres).first;
  double radius = 0, across = 0, upwards = 0;
  for (auto part = begin; part != end; ++part) {
    const Complex away = part->centre - centre;
    radius = std::max(radius, std::abs(away) + part->radius);
    across = std::max(across, std::abs(away.real()));
    upwards = std::max(upwards, std::abs(away.imag()));
  }
  shape.groups.push_back(
      {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), centre, radius});
  if (count == 1) return;
  std::stable_sort(begin, end, [&](const EncircledPart& one, const EncircledPart& other) {
    return across >= upwards ? one.centre.real() < other.centre.real()
                             : one.centre.imag() < other.centre.imag();
  });
  group_parts(shape, first, count / 2);
  group_parts(shape, first + count / 2, count - count / 2);
}

/// Calls `visit` with every part, or where they are grouped with those of no group that `skips(a lower bound of the distance to it)`, the
/// nearer ones first.
template <typename Skips, typename Visit>
void for_each_part(const ObstacleShape& obstacle, const PieceCorners& piece, const Skips& skips,
                   const Visit& visit) {
  if (obstacle.groups.empty()) {
    for (const EncircledPart& part : obstacle.parts) visit(part);
    return;
  }
  struct Open {
    std::uint32_t group;
    double below;
  };
  const auto look_at = [&](std::uint32_t index) {
    const PartGroup& group = obstacle.groups[index];
    return Open{index, distance_to_axis(piece, group.centre) - group.radius};
  };
  std::array<Open, 64> open{look_at(0)};  // halves of 2^32 parts are at most 32 deep
  std::size_t count = 1;
  while (count > 0) {
    const Open here = open[--count];
    if (skips(here.below)) continue;
    const PartGroup& group = obstacle.groups[here.group];
    if (group.parts == 1) {
      visit(obstacle.parts[group.first]);
      continue;
    }
    Open near = look_at(here.group + 1), far = look_at(here.group + 2 * (group.parts / 2));
    if (far.below < near.below) std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
}

/// The distance of a piece from an obstacle, or a lower bound that is close to it where it is larger than `up_to`.
double distance_near(const PieceCorners& piece, const ObstacleShape& obstacle, double up_to) {
  const double below = distance_to_axis(piece, obstacle.centre) - obstacle.radius;
  if (below > up_to) return below;
  double least = infinity;
  const auto skips = [&](double group_below) { return group_below > least; };
  for_each_part(obstacle, piece, skips, [&](const EncircledPart& part) {
    const double part_below = distance_to_axis(piece, part.centre) - part.radius;
    least =
        std::min(least, part_below > std::min(least, up_to) ? part_below
                                                            : convex_distance(piece.span(), part.outline));
  });
  return least;
}

/// The distance of a piece from an obstacle, or any number above `up_to` where it is larger than that. Quicker than distance_near().
double distance_up_to(const PieceCorners& piece, const ObstacleShape& obstacle, double up_to) {
  if (is_farther(piece, obstacle.centre, obstacle.radius + up_to)) return infinity;
  double least = infinity;
  const auto skips = [&](double group_below) { return group_below > std::min(least, up_to); };
  const bool is_one = obstacle.parts.size() == 1;  // its circle is the obstacle's
  for_each_part(obstacle, piece, skips, [&](const EncircledPart& part) {
    const double needed = std::min(least, up_to);
    if (is_one || !is_farther(piece, part.centre, part.radius + needed))
      least = std::min(least, convex_distance(piece.span(), part.outline, needed));
  });
  return least;
}

void add_line(const Ring& ring, double step, std::vector<Point>& places) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
    for (int j = 0; j < pieces; ++j)
      if (places.empty() || pieces > 1 || (a - places.back()).norm() > 0.25 * step)
        places.push_back(a + (b - a) * j / pieces);
  }
}

double length_of(const Ring& ring) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return length;
}

}  // namespace

std::vector<ObstacleShape> obstacle_shapes(const std::vector<Obstruction>& obstructions,
                                           const StopFlag& stop) {
  std::vector<ObstacleShape> shapes;
  for (const Obstruction& obstruction : obstructions) {
    if (stop()) break;
    ObstacleShape shape;
    std::vector<Complex> outer;
    for (const Polygon& polygon : obstruction.shape.polygons) {
      for (const Point& corner : polygon.outer) outer.push_back(as_complex(corner));
      for (ConvexPart& whole : convex_parts(polygon))
        for (ConvexPart& part : cut_to_arcs(std::move(whole))) {
          const auto [centre, radius] = circle_around(part);
          shape.parts.push_back({FixedConvex(std::move(part)), centre, radius});
        }
    }
    std::tie(shape.centre, shape.radius) = circle_around(outer);
    if (shape.parts.size() > few_parts) {
      shape.groups.reserve(2 * shape.parts.size() - 1);
      group_parts(shape, 0, shape.parts.size());
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::vector<ObstacleTerm> obstacle_terms(const CopyingLinkage& linkage, const LayerAssignment& layers,
                                         const LinkStyle& style, const std::vector<Obstruction>& obstructions,
                                         const std::vector<Body>& bodies) {
  const std::vector<Part> parts = parts_of(linkage, layers);
  std::vector<std::vector<JointHull>> axes;
  for (const Part& part : parts) axes.push_back(axis_of(part, linkage.shape(), style.plate));
  std::vector<ObstacleTerm> terms;
  terms.reserve(parts.size() * obstructions.size());
  for (std::size_t i = 0; i < obstructions.size(); ++i) {
    const Obstruction& obstruction = obstructions[i];
    const auto seen_from =
        obstruction.frame ? std::optional(joint_of(*obstruction.frame, linkage)) : std::nullopt;
    const auto add = [&](const JointHull& hull, double half_width) {
      terms.push_back({{hull, half_width + obstruction.grown}, i, seen_from, obstruction.turns_with});
    };
    for (const std::size_t number : obstruction.turning) {
      const Body& body = bodies[number];
      const Joint mount = joint_of(body.at, linkage);
      const BodyPieces all = pieces_of(body);
      for (const ConvexPart& piece : all.pieces) {
        add({{mount, mount, mount}, static_cast<int>(piece.size())}, all.grown);
        BesideLink& beside = terms.back().beside.emplace();
        beside.link = *body.turns_with;
        std::copy(piece.begin(), piece.end(), beside.corners.begin());
      }
    }
    if (obstruction.met) {
      const Joint joint = joint_of(obstruction.met->by, linkage);
      add({{joint, joint, joint}, 1}, 0);
    }
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (may_meet(parts[part], obstruction, linkage))
        for (const JointHull& hull : axes[part]) add(hull, half_width(parts[part], style));
  }
  return terms;
}

PlacedJoints::PlacedJoints(const Reach& reach, const JointRoles& roles, const LogLengths& lengths,
                           const SideLengths& sides, const Point& pole, const Point& tracer)
    : reach_(reach), roles_(roles), lengths_(lengths), sides_(sides),
      reach_vector_(as_complex(tracer - pole)),
      frame_(reach.shape(), sides.VA, sides.VB * reach.direction_at(sides, std::abs(reach_vector_))) {
  const Complex ground = frame_[roles.pole], arm = frame_[roles.tracer] - ground;
  // Where the opening had to be clamped the arm is too long or too short: its direction is right, which is enough.
  const Complex turn = quotient(reach_vector_, arm);
  for (const Joint joint : all_joints)
    at_[static_cast<std::size_t>(joint)] = as_complex(pole) + turn * (frame_[joint] - ground);
}

Complex PlacedJoints::axis(Link link) const {
  const Complex side = (*this)[is_along_p(link) ? Joint::A : Joint::B] - (*this)[Joint::V];
  return side / std::abs(side) * axis_at_end(link, reach_.shape());
}

PlacedJoints::Turning PlacedJoints::turning(Link link) const {
  const Joint end = is_along_p(link) ? Joint::A : Joint::B;
  const Complex side = (*this)[end] - (*this)[Joint::V];
  const Motion motion = difference(this->motion(end), this->motion(Joint::V));
  const auto turned = [&](Complex moved) { return (moved / side).imag(); };
  return {turned(motion.by_u), turned(motion.by_v), turned(motion.by_pole_x), turned(motion.by_pole_y)};
}

PlacedJoints::Motion PlacedJoints::motion(Joint joint) const {
  const Complex arm = frame_[roles_.tracer] - frame_[roles_.pole];
  const Complex xi = (frame_[joint] - frame_[roles_.pole]) / arm;
  const auto ratio_change = [&](Complex of_joint, Complex of_pole, Complex of_tracer) {
    return ((of_joint - of_pole) - xi * (of_tracer - of_pole)) / arm;
  };
  const auto change = [&](auto part) {
    return ratio_change(part(joint), part(roles_.pole), part(roles_.tracer));
  };
  const Complex xi_u = change([&](Joint j) { return frame_.of_p(j); });
  const Complex xi_v = change([&](Joint j) { return frame_.of_q(j); });
  const Complex xi_d = change([&](Joint j) { return i_unit * frame_.of_q(j); });
  const LinkageJet radius = reach_.radius(lengths_, reach_.opening_at(sides_, std::abs(reach_vector_)));
  const double slope = radius.gradient[2];
  // At a serial dead point the opening has no derivative; no design comes near one.
  const double per_slope = std::abs(slope) > slack::zero_slope * radius.value ? 1 / slope : 0;
  const Complex by_opening = reach_vector_ * xi_d;
  const Complex direction = reach_vector_ / std::abs(reach_vector_);
  return {reach_vector_ * xi_u - by_opening * radius.gradient[0] * per_slope,
          reach_vector_ * xi_v - by_opening * radius.gradient[1] * per_slope,
          1.0 - xi - by_opening * direction.real() * per_slope,
          i_unit * (1.0 - xi) - by_opening * direction.imag() * per_slope};
}

double obstacle_gap(const ObstacleTerm& term, const ObstacleShape& obstacle, const PlacedJoints& joints,
                    double enough, Beyond beyond) {
  const PieceCorners piece(term, joints);
  const double half_width = term.piece.half_width, up_to = enough + half_width;
  return (beyond == Beyond::anything ? distance_up_to(piece, obstacle, up_to)
                                     : distance_near(piece, obstacle, up_to)) -
         half_width;
}

PlacedJet obstacle_gap_jet(const ObstacleTerm& term, const ObstacleShape& obstacle,
                           const PlacedJoints& joints) {
  const PieceCorners piece(term, joints);
  NearestFeatures nearest{.distance = std::numeric_limits<double>::infinity()};
  const ConvexPart* of_part = nullptr;
  const auto skips = [&](double group_below) { return group_below > nearest.distance; };
  for_each_part(obstacle, piece, skips, [&](const EncircledPart& part) {
    const NearestFeatures here = nearest_features(piece.span(), part.outline.corners());
    if (here.distance < nearest.distance) nearest = here, of_part = &part.outline.corners();
  });
  PlacedJet jet{.value = nearest.distance - term.piece.half_width};
  if (!of_part) return jet;  // nothing stands there, or lengths overflow: no slope to go by
  // Unit vector along which the piece's deciding place leaves the obstacle; that place as a mixture of joints.
  const auto add = [&](std::size_t corner, double weight, Complex normal) {
    const PlacedJoints::Motion motion = motion_of(term, corner, piece.at[corner], joints);
    jet.by_u += weight * dot(normal, motion.by_u);
    jet.by_v += weight * dot(normal, motion.by_v);
    jet.by_pole += weight * Point(dot(normal, motion.by_pole_x), dot(normal, motion.by_pole_y));
  };
  if (!nearest.is_edge) {
    const std::size_t own = nearest.corner_of_first ? nearest.corner : nearest.from;
    const std::size_t other = nearest.corner_of_first ? nearest.from : nearest.corner;
    const Complex apart = piece.at[own] - (*of_part)[other];
    add(own, 1, std::abs(apart) > 0 ? apart / std::abs(apart) : Complex{1, 0});
  } else if (nearest.corner_of_first) {
    const Complex edge = (*of_part)[nearest.to] - (*of_part)[nearest.from];
    add(nearest.corner, 1, nearest.side * i_unit * edge / std::abs(edge));
  } else {
    const Complex from = piece.at[nearest.from], edge = piece.at[nearest.to] - from;
    const double share = dot((*of_part)[nearest.corner] - from, edge) / std::norm(edge);
    const Complex normal = -nearest.side * i_unit * edge / std::abs(edge);
    add(nearest.from, 1 - share, normal);
    add(nearest.to, share, normal);
  }
  return jet;
}

SmallestGaps::SmallestGaps(const Reach& reach, const JointRoles& roles, const LogLengths& lengths,
                           const Point& pole, std::span<const Point> places,
                           const std::vector<ObstacleShape>& obstacles, double up_to)
    : obstacles_(obstacles), up_to_(up_to) {
  joints_.reserve(places.size());
  const SideLengths sides = reach.sides(lengths);
  for (const Point& place : places) joints_.emplace_back(reach, roles, lengths, sides, pole, place);
}

double SmallestGaps::smallest(const ObstacleTerm& term) const {
  double least = up_to_;
  for (const PlacedJoints& joints : joints_)
    least = std::min(least, obstacle_gap(term, obstacles_[term.obstacle], joints, least, Beyond::anything));
  return least;
}

double SmallestGaps::of(const ObstacleTerm& term) {
  if (term.beside) return smallest(term);  // told apart by its corners as well
  const AxisPiece& piece = term.piece;
  std::array<Joint, 3> joints{};
  std::copy_n(piece.hull.joints.begin(), piece.hull.count, joints.begin());
  const auto [at, is_new] = known_.try_emplace(
      {term.obstacle, piece.half_width, piece.hull.count, joints, term.seen_from, term.turns_with});
  if (is_new) at->second = smallest(term);
  return at->second;
}

std::vector<Point> tracer_places(const Region& region, int about) {
  double outline = 0;
  for (const Polygon& polygon : region.polygons) {
    outline += length_of(polygon.outer);
    for (const Ring& hole : polygon.holes) outline += length_of(hole);
  }
  std::vector<Point> places;
  for (const Polygon& polygon : region.polygons) {
    add_line(polygon.outer, outline / (0.6 * about), places);
    for (const Ring& hole : polygon.holes) add_line(hole, outline / (0.6 * about), places);
  }
  const Box box = bounding_box(region);
  const double step = grid_step(region, 0.4 * about);
  const RegionReach reach(
      region);  // asked some thousand times: contains() would look at all corners each time
  for (double x = box.lower.x() + step / 2; x < box.upper.x(); x += step)
    for (double y = box.lower.y() + step / 2; y < box.upper.y(); y += step)
      if (reach.contains({x, y})) places.push_back({x, y});
  return places;
}

}  // namespace kempe
