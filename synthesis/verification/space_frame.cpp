// Unknowns: the height of each joint, which all links there share since pins keep their lengths, and of every link at each of its joints its two
// displacements in the plane and three turns.

#include "synthesis/verification/space_frame.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/decompositions.hpp"
#include "kinematics/links.hpp"
#include "specs/hardware.hpp"
#include "synthesis/verification/any_direction.hpp"
#include "synthesis/verification/plate_pieces.hpp"

namespace kempe {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
/// Numbers of the six freedoms of a beam's end: displacements x, y, z and turns about x, y, z.
using Freedoms = std::array<int, 6>;

/// A beam's section: stiffnesses of pull, of bending along and across `first` of Beams::add, of twist; shear as compliance per length.
struct Section {
  double EA, EI_first, EI_second, GJ, shear = 0;
};

/// Of a flat bar that lies: bending in the plane first, then out of it.
Section flat_section(const SpaceFrameParts& parts) {
  const double w = parts.style.width, t = parts.style.thickness;
  const double wide = std::max(w, t), thin = std::min(w, t), share = thin / wide;
  // Roark's Formulas for Stress and Strain, 7th edition, table 10.1: the twist of a rectangle.
  const double J =
      wide * thin * thin * thin / 3 * (1 - 0.63 * share + 0.0525 * share * share * share * share * share);
  return {parts.E * w * t, parts.E * t * w * w * w / 12, parts.E * w * t * t * t / 12, parts.G * J};
}

/// Of a round steel pin: both ends have one height, so no pull is asked for.
Section round_section(double diameter) {
  constexpr double E = 200e3, G = 77e3;  // MPa
  const double area = pi * diameter * diameter / 4, I = area * diameter * diameter / 16;
  return {0, E * I, E * I, G * 2 * I, 10 / (9 * G * area)};
}

/// A beam's stiffness in its own axes: along it, `first`, and at right angles to both.
Matrix12 own_stiffness(double L, const Section& section) {
  Matrix12 own = Matrix12::Zero();
  const auto spring = [&](int at, double stiffness) {
    own(at, at) += stiffness;
    own(at + 6, at + 6) += stiffness;
    own(at, at + 6) -= stiffness;
    own(at + 6, at) -= stiffness;
  };
  spring(0, section.EA / L);
  spring(3, section.GJ / L);
  // Displacement along an axis goes with a turn about the other one: along the second with +, along the third with -.
  const auto bend = [&](int shift, int turn, double sign, double EI) {
    const double phi = 12 * EI * section.shear / (L * L), c = EI / (L * L * L * (1 + phi)), l = sign * L;
    const std::array<int, 4> at{shift, turn, shift + 6, turn + 6};
    Eigen::Matrix4d k;
    k << 12, 6 * l, -12, 6 * l,                               //
        6 * l, (4 + phi) * L * L, -6 * l, (2 - phi) * L * L,  //
        -12, -6 * l, 12, -6 * l,                              //
        6 * l, (2 - phi) * L * L, -6 * l, (4 + phi) * L * L;
    for (Eigen::Index i = 0; i < 4; ++i)
      for (Eigen::Index j = 0; j < 4; ++j)
        own(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) += c * k(i, j);
  };
  bend(1, 5, 1, section.EI_first);
  bend(2, 4, -1, section.EI_second);
  return own;
}

class Beams {
 public:
  int freedom() { return count_++; }
  void hold(int freedom) { held_.push_back(freedom); }
  int count() const { return count_; }

  /// The beam's number. `first` is a unit vector at right angles to `way`, from end to end: EI_first resists displacements along it.
  std::size_t add(const Freedoms& from, const Freedoms& to, const Vector3& way, const Vector3& first,
                  const Section& section) {
    const double L = way.norm();
    const Vector3 along = way / L;
    Eigen::Matrix3d axes;
    axes << along.transpose(), first.transpose(), along.cross(first).transpose();
    Matrix12 turn = Matrix12::Zero();
    for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = axes;
    Beam beam{{}, turn, turn.transpose() * own_stiffness(L, section) * turn};
    std::copy(from.begin(), from.end(), beam.at.begin());
    std::copy(to.begin(), to.end(), beam.at.begin() + 6);
    beams_.push_back(beam);
    return beams_.size() - 1;
  }

  /// On a beam's first end in its own axes, by the displacements of all freedoms.
  Eigen::Vector<double, 6> at_first_end(std::size_t number, const Eigen::VectorXd& moved) const {
    const Beam& beam = beams_[number];
    Eigen::Vector<double, 12> own;
    for (std::size_t i = 0; i < 12; ++i) own[static_cast<Eigen::Index>(i)] = moved[beam.at[i]];
    return (beam.turn * (beam.stiffness * own)).head<6>();
  }

  /// All displacements under each column of forces on the freedoms.
  Eigen::MatrixXd moved_by(Eigen::MatrixXd forces) const {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count_, count_);
    for (const Beam& beam : beams_)
      for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = 0; j < 12; ++j)
          stiffness(beam.at[i], beam.at[j]) +=
              beam.stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    for (const int one : held_) {
      stiffness.row(one).setZero();
      stiffness.col(one).setZero();
      stiffness(one, one) = 1;
      forces.row(one).setZero();
    }
    const Elimination factors(stiffness);
    Eigen::MatrixXd moved(count_, forces.cols());
    for (Eigen::Index load = 0; load < forces.cols(); ++load)
      moved.col(load) = factors.solution(forces.col(load));
    return moved;
  }

 private:
  struct Beam {
    std::array<int, 12> at;
    Matrix12 turn, stiffness;
  };
  int count_ = 0;
  std::vector<Beam> beams_;
  std::vector<int> held_;
};

/// The linkage's beams.
class SpaceFrame {
 public:
  SpaceFrame(const Pose& pose, const SpaceFrameParts& parts) : pose_(pose), parts_(parts) {
    for (int& height : heights_) height = beams_.freedom();
    for (auto& of_link : nodes_)
      for (std::size_t joint = 0; joint < of_link.size(); ++joint) of_link[joint][2] = heights_[joint];
    add_links();
    join(Joint::A, Link::VA, Link::ACX);
    join(Joint::B, Link::VB, Link::BCY);
    join(Joint::C, Link::ACX, Link::BCY);
  }

  void stand_at(Joint pole) {
    hold_height(pole);
    Freedoms table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = i == 2 ? height(pole) : beams_.freedom();
      if (i != 2) beams_.hold(table[i]);
    }
    const double thickness = parts_.style.thickness;
    if (pole == Joint::V) {
      const auto [lower, upper] = in_order(Link::VA, Link::VB);
      const Freedoms post = pin(table, lower, pole, thickness * (parts_.layers[lower] - 0.5));
      pin(post, upper, pole, thickness * (parts_.layers[upper] - parts_.layers[lower]));
    } else {
      pin(table, Link::ACX, pole, thickness * (parts_.layers[Link::ACX] - 0.5));
      join(Joint::V, Link::VA, Link::VB);
    }
  }
  /// A point's tool is held by one link, if two meet there by the first.
  void hold_in_plane(Joint joint) {
    for (const std::size_t i : {0u, 1u}) beams_.hold(tool(joint)[i]);
  }
  void hold_height(Joint joint) { beams_.hold(height(joint)); }

  SpaceFrameResponse pushed_at(Joint pen, Joint tracer) const {
    const Freedoms& at = tool(pen);
    const std::array<int, 2> points{height(tracer), height(pen)};
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(beams_.count(), parts_.link_pull > 0 ? 7 : 5);
    loads(at[0], 0) = loads(at[1], 1) = loads(points[0], 3) = loads(points[1], 4) = 1;
    loads.col(2) = weights();
    loads(points[0], 2) -= parts_.tracer_weight;
    loads(points[1], 2) -= parts_.pen_weight;
    if (parts_.link_pull > 0) loads.rightCols<2>() = pulls();
    const Eigen::MatrixXd moved = beams_.moved_by(loads);
    SpaceFrameResponse response;
    response.in_plane << moved(at[0], 0), moved(at[0], 1), moved(at[1], 0), moved(at[1], 1);
    response.rises = moved(points, Eigen::seqN(0, 2));
    response.lifts = moved(points, Eigen::seqN(3, 2));
    response.weighed = moved(points, 2);
    if (parts_.link_pull > 0) {
      response.in_plane_by_pull << moved(at[0], 5), moved(at[0], 6), moved(at[1], 5), moved(at[1], 6);
      response.rises_by_pull = moved(points, Eigen::seqN(5, 2));
    }
    for (const Piece& piece : pieces_) {
      SpaceFramePiece one{.link = piece.link, .length = piece.length, .weight = piece.weight};
      one.forces.setZero();
      for (Eigen::Index load = 0; load < moved.cols(); ++load)
        one.forces.col(load) = beams_.at_first_end(piece.beam, moved.col(load));
      // What the weight puts on its held ends, which the joints have borne as loads.
      one.forces(2, 2) += 0.5 * piece.weight * piece.length;
      one.forces(4, 2) -= piece.weight * piece.length * piece.length / 12;
      for (const int axis : {0, 1}) {
        const Point pull = pull_of(piece, axis);
        one.pulls.col(axis) = pull;
        one.forces(0, 5 + axis) -= 0.5 * pull.x() * piece.length;
        one.forces(1, 5 + axis) -= 0.5 * pull.y() * piece.length;
        one.forces(5, 5 + axis) -= pull.y() * piece.length * piece.length / 12;
      }
      response.pieces.push_back(one);
    }
    return response;
  }

 private:
  /// A piece of a link: its beam, and its weight, N/mm.
  struct Piece {
    Link link;
    std::size_t beam;
    Freedoms from, to;
    Point way;
    double length, weight, pull;
  };

  /// N/mm on a piece, along it and to its left, of a pull along an axis of the plane.
  static Point pull_of(const Piece& piece, int axis) {
    const Point along = piece.way / piece.length;
    return piece.pull * (axis == 0 ? Point(along.x(), -along.y()) : Point(along.y(), along.x()));
  }

  /// Of the links' weight along the plane, a column for each axis that it may pull along, on all freedoms.
  Eigen::MatrixXd pulls() const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(beams_.count(), 2);
    for (const int axis : {0, 1}) {
      for (const Piece& piece : pieces_) {
        const double turning = pull_of(piece, axis).y() * piece.length * piece.length / 12;
        for (const bool begins : {true, false}) {
          const Freedoms& end = begins ? piece.from : piece.to;
          all(end[static_cast<std::size_t>(axis)], axis) += 0.5 * piece.pull * piece.length;
          all(end[5], axis) += begins ? turning : -turning;
        }
      }
      for (const Link link : all_links)
        for (const Joint joint : all_joints)
          if (const double area = lump_area(link, joint); area > 0)
            all(nodes_[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)]
                      [static_cast<std::size_t>(axis)],
                axis) += parts_.link_pull * parts_.style.thickness * area;
    }
    return all;
  }
  /// mm^2: what of a link weighs at that joint alone.
  double lump_area(Link link, Joint joint) const {
    LinkJoints of = joints_of(link);
    const double w = parts_.style.width;
    const auto end = of.joints.begin() + of.count;
    if (std::find(of.joints.begin(), end, joint) == end) return 0;
    if (is_triangle(of)) {
      const auto apart = [&](Joint a, Joint b) { return (pose_[a] - pose_[b]).norm(); };
      const Point a = pose_[of.joints[1]] - pose_[of.joints[0]],
                  b = pose_[of.joints[2]] - pose_[of.joints[0]];
      double sides = 0;
      for (const Joint other : of.joints) sides += apart(joint, other);
      return std::abs(cross(a, b)) / 6 + 0.25 * w * sides + pi * w * w / 12;
    }
    if (of.count == 3) of.joints = middle_first(of.joints, pose_, parts_.straight);
    return of.count == 3 && joint == of.joints[0] ? 0 : pi * w * w / 8;
  }

  /// Of the links, N and N mm on all freedoms: along their pieces, half a disc beyond the outer ends; a triangle's at its corners.
  Eigen::VectorXd weights() const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(beams_.count());
    const double w = parts_.style.width, each = parts_.link_weight * parts_.style.thickness;
    for (const Piece& piece : pieces_) {
      const double half = 0.5 * piece.weight * piece.length, moment = half * piece.length / 6;
      const Point left(-piece.way.y() / piece.length, piece.way.x() / piece.length);
      for (const bool begins : {true, false}) {
        const Freedoms& end = begins ? piece.from : piece.to;
        all[end[2]] -= half;
        for (const std::size_t axis : {0u, 1u})
          all[end[3 + axis]] += (begins ? moment : -moment) * left[static_cast<Eigen::Index>(axis)];
      }
    }
    for (const Link link : all_links) {
      LinkJoints of = joints_of(link);
      if (is_triangle(of)) {
        const Point &a = pose_[of.joints[0]], &b = pose_[of.joints[1]], &c = pose_[of.joints[2]];
        const double inside = 0.5 * std::abs(cross(b - a, c - a)),
                     around = (b - a).norm() + (c - b).norm() + (a - c).norm();
        for (std::size_t i = 0; i < 3; ++i) {
          const double opposite = (pose_[of.joints[(i + 1) % 3]] - pose_[of.joints[(i + 2) % 3]]).norm();
          all[height(of.joints[i])] -= each * (inside / 3 + 0.25 * w * (around - opposite) + pi * w * w / 12);
        }
        continue;
      }
      if (of.count == 3) of.joints = middle_first(of.joints, pose_, parts_.straight);
      for (std::size_t i = of.count == 3 ? 1 : 0; i < static_cast<std::size_t>(of.count); ++i)
        all[height(of.joints[i])] -= each * pi * w * w / 8;
    }
    return all;
  }
  bool is_triangle(const LinkJoints& link) const {
    return link.count == 3 && !parts_.straight && parts_.style.plate == PlateStyle::triangle;
  }

  Freedoms& node(Link link, Joint joint) {
    return nodes_[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)];
  }
  int height(Joint joint) const { return heights_[static_cast<std::size_t>(joint)]; }
  const Freedoms& tool(Joint joint) const {
    const Link link = joint == Joint::V ? Link::VA : joint == Joint::X ? Link::ACX : Link::BCY;
    return nodes_[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)];
  }

  void add_links() {
    const Section bar = flat_section(parts_);
    for (const Link link : all_links) {
      LinkJoints of = joints_of(link);
      if (of.count == 3) of.joints = middle_first(of.joints, pose_, parts_.straight);
      for (int i = 0; i < of.count; ++i)
        for (const std::size_t freedom : {0u, 1u, 3u, 4u, 5u})
          node(link, of.joints[static_cast<std::size_t>(i)])[freedom] = beams_.freedom();
      for (int i = 1; i < of.count; ++i) {
        const Joint from = of.joints[0], to = of.joints[static_cast<std::size_t>(i)];
        const Point way = pose_[to] - pose_[from], along = way.normalized();
        const std::size_t beam = beams_.add(node(link, from), node(link, to), {way.x(), way.y(), 0},
                                            {-along.y(), along.x(), 0}, bar);
        const double section = is_triangle(of) ? 0 : parts_.style.width * parts_.style.thickness;
        pieces_.push_back({link, beam, node(link, from), node(link, to), way, way.norm(),
                           parts_.link_weight * section, parts_.link_pull * section});
      }
    }
  }

  std::array<Link, 2> in_order(Link one, Link other) const {
    if (parts_.layers[one] > parts_.layers[other]) std::swap(one, other);
    return {one, other};
  }

  /// The pin's upper end: the link's there, but for the turn about the pin, which is the pin's own.
  Freedoms pin(const Freedoms& from, Link link, Joint joint, double height) {
    Freedoms top = node(link, joint);
    top[5] = beams_.freedom();
    beams_.add(from, top, {0, 0, height}, {1, 0, 0},
               round_section(pin_at(parts_.style, parts_.hardware, joint)));
    return top;
  }
  void join(Joint joint, Link one, Link other) {
    const auto [lower, upper] = in_order(one, other);
    pin(node(lower, joint), upper, joint,
        parts_.style.thickness * (parts_.layers[upper] - parts_.layers[lower]));
  }

  const Pose& pose_;
  const SpaceFrameParts& parts_;
  Beams beams_;
  std::vector<Piece> pieces_;
  std::array<int, 6> heights_{};
  std::array<std::array<Freedoms, 6>, 4> nodes_{};
};

/// The table's push on tracer and pen, N: each is pushed, or rises above the table. `free`: how far they would rise without it.
Eigen::Vector2d push_of(const SpaceFrameResponse& response, const FrameTable& table,
                        const Eigen::Vector2d& free) {
  const Eigen::Matrix2d& lifts = response.lifts;
  const auto alone = [&](Eigen::Index point) -> Eigen::Vector2d {
    return Eigen::Vector2d::Unit(point) * std::max(0.0, -free[point] / lifts(point, point));
  };
  if (!table.pen_rests) return table.tracer_rests ? alone(0) : Eigen::Vector2d::Zero();
  if (!table.tracer_rests) return alone(1);
  for (const Eigen::Index point : {0, 1}) {
    Eigen::Vector2d push = alone(point);
    const Eigen::Vector2d rises = free + lifts * push;
    if (rises[1 - point] >= 0) return push;
  }
  // Neither bears alone, and so both do.
  const Eigen::Vector2d push = -(lifts.inverse() * free);
  return push.cwiseMax(0);
}

/// Of a rectangle without a hole in its middle, or with one: what forces and moments are divided by.
struct FrameSection {
  FrameSection(const LinkStyle& style, double hole) {
    const double t = style.thickness, w = style.width, strips = w - hole;
    area = strips * t;
    in_plane = 2 / w * (t * w * w * w - t * hole * hole * hole) / 12;
    out_of_plane = 2 / t * strips * t * t * t / 12;
    // Roark's Formulas for Stress and Strain, 7th edition, table 10.1, in half sides: the largest shear is at the middles of the longer.
    const double a = 0.5 * std::max(strips, t), b = 0.5 * std::min(strips, t), c = b / a;
    twist =
        8 * a * b * b / 3 / (1 + 0.6095 * c + 0.8865 * c * c - 1.8023 * c * c * c + 0.9100 * c * c * c * c);
  }
  double stress(double pull, double M_in, double M_out, double torque) const {
    const double sigma = std::abs(pull) / area + std::abs(M_in) / in_plane + std::abs(M_out) / out_of_plane,
                 tau = torque / twist;
    return std::sqrt(sigma * sigma + 3 * tau * tau);
  }
  double area, in_plane, out_of_plane, twist;
};

/// In a piece under this share of each of its loads: at its ends beside holes, and between them, where one of the corners' stresses, a
/// parabola through three places, has its vertex.
double stress_in(const SpaceFramePiece& piece, const Eigen::Vector<double, 7>& loads,
                 const FrameSection& at_holes, const FrameSection& whole) {
  const Eigen::Vector<double, 6> end = piece.forces * loads;
  const Point pull = piece.pulls * loads.tail<2>();
  const double L = piece.length, weight = loads[2] * piece.weight;
  const auto along = [&](double x) { return end[0] + x * pull.x(); };
  const auto in = [&](double x) { return end[5] - x * end[1] - 0.5 * pull.y() * x * x; };
  const auto out = [&](double x) { return end[4] + x * end[2] - 0.5 * weight * x * x; };
  const auto at = [&](const FrameSection& section, double x) {
    return section.stress(along(x), in(x), out(x), end[3]);
  };
  double most = std::max(at(at_holes, 0), at(at_holes, L));
  if (weight == 0 && pull.isZero(0)) return most;
  for (const double side : {-1.0, 1.0})
    for (const double face : {-1.0, 1.0}) {
      const auto corner = [&](double x) {
        return along(x) / whole.area + side * in(x) / whole.in_plane + face * out(x) / whole.out_of_plane;
      };
      const double low = corner(0), middle = corner(0.5 * L), high = corner(L), bow = low - 2 * middle + high,
                   x = 0.5 * L + 0.25 * L * (low - high) / bow;
      if (x > 0 && x < L) most = std::max(most, at(whole, x));
    }
  return most;
}

/// Of resting points, by a load that would let them rise so: what the table puts on those of the set, N, while it holds them.
Eigen::Vector2d hold(const Eigen::Matrix2d& lifts, const Eigen::Vector2d& rises, bool tracer, bool pen) {
  if (tracer && pen) return -(lifts.inverse() * rises);
  return {tracer ? -rises[0] / lifts(0, 0) : 0, pen ? -rises[1] / lifts(1, 1) : 0};
}

}  // namespace

SpaceFrameResponse space_frame_response(const Pose& pose, const JointRoles& roles,
                                        const SpaceFrameParts& parts) {
  SpaceFrame frame(pose, parts);
  frame.stand_at(roles.pole);
  frame.hold_in_plane(roles.tracer);
  return frame.pushed_at(roles.pen, roles.tracer);
}

FrameMovement movement(const SpaceFrameResponse& response, const FrameTable& table, const Point& force) {
  const Eigen::Vector2d rises = response.rises * force;
  const Eigen::Vector2d push =
      push_of(response, table, table.free_rises + rises) - push_of(response, table, table.free_rises);
  // By reciprocity an upward newton moves the pen as far along an axis as a newton along it lifts that newton's point.
  return {response.in_plane * force + response.rises.transpose() * push, rises + response.lifts * push};
}

MostOfFrame most_movement(const SpaceFrameResponse& response, const FrameTable& table, double force) {
  if (!table.tracer_rests && !table.pen_rests)
    return {force * response.in_plane.operatorNorm(),
            force * std::max(response.rises.row(0).norm(), response.rises.row(1).norm())};
  const auto at = [&](double direction) {
    return movement(response, table, force * Point(std::cos(direction), std::sin(direction)));
  };
  return {most_in_any_direction([&](double direction) { return at(direction).give.norm(); }),
          most_in_any_direction([&](double direction) { return at(direction).rises.cwiseAbs().maxCoeff(); })};
}

double most_stress(const SpaceFrameResponse& response, const FrameTable& table, double force,
                   const LinkStyle& style, double hole, std::optional<Link> only) {
  const FrameSection at_holes(style, hole), whole(style, 0);
  return most_in_any_direction([&](double direction) {
    const Point push = force * Point(std::cos(direction), std::sin(direction));
    Eigen::Vector<double, 7> loads;
    loads << push, 1, push_of(response, table, table.free_rises + response.rises * push), 0, 0;
    double most = 0;
    for (const SpaceFramePiece& piece : response.pieces)
      if (!only || piece.link == *only) most = std::max(most, stress_in(piece, loads, at_holes, whole));
    return most;
  });
}

MostByPull most_by_pull(const SpaceFrameResponse& response, const FrameTable& table, const LinkStyle& style,
                        std::optional<double> hole) {
  MostByPull most;
  for (const bool tracer : {false, true})
    for (const bool pen : {false, true}) {
      if ((tracer && !table.tracer_rests) || (pen && !table.pen_rests)) continue;
      Eigen::Matrix2d held;
      for (const int axis : {0, 1})
        held.col(axis) = hold(response.lifts, response.rises_by_pull.col(axis), tracer, pen);
      const Eigen::Matrix2d give = response.in_plane_by_pull + response.rises.transpose() * held,
                            rises = response.rises_by_pull + response.lifts * held;
      const auto along = [](double direction) { return Point(std::cos(direction), std::sin(direction)); };
      most.give =
          std::max(most.give,
                   most_in_any_direction([&](double direction) { return (give * along(direction)).norm(); }));
      most.rise = std::max({most.rise, rises.row(0).norm(), rises.row(1).norm()});
      if (!hole) continue;
      const FrameSection at_holes(style, *hole), whole(style, 0);
      for (const SpaceFramePiece& piece : response.pieces) {
        double& of_link = most.stress[static_cast<std::size_t>(piece.link)];
        of_link = std::max(of_link, most_in_any_direction([&](double direction) {
                             Eigen::Vector<double, 7> loads;
                             loads << 0, 0, 0, held * along(direction), along(direction);
                             return stress_in(piece, loads, at_holes, whole);
                           }));
      }
    }
  return most;
}

}  // namespace kempe
