// Unknowns: x and y of the six joints, then the rotation of each plate at each of its three joints.

#include "synthesis/verification/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/decompositions.hpp"
#include "kinematics/links.hpp"
#include "synthesis/verification/any_direction.hpp"
#include "synthesis/verification/plate_pieces.hpp"

namespace kempe {
namespace {

constexpr int joint_unknowns = 12, all_unknowns = 18;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
/// Columns: the force at the pen, or the links' pull, along x and along y.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

Point place_of(const Pose& pose, Joint joint) {
  const std::array<Point, 6> places{pose.V, pose.A, pose.B, pose.C, pose.X, pose.Y};
  return places[static_cast<std::size_t>(joint)];
}

/// A straight piece of a link. Of a bar the rotations are -1 and it only pulls.
struct Element {
  Joint from, to;
  int from_rotation, to_rotation;
  bool is_bar() const { return from_rotation < 0; }
};

/// The piece's end forces and moments in its own frame: along, across, moment at its beginning; the same at its end.
struct Stiffness {
  Stiffness(const Element& element, const Pose& pose, double EA, double EI) {
    const Point along = place_of(pose, element.to) - place_of(pose, element.from);
    length = along.norm();
    direction = along / length;
    const double pull = EA / length, l = length;
    local.setZero();
    local(0, 0) = local(3, 3) = pull;
    local(0, 3) = local(3, 0) = -pull;
    if (element.is_bar()) return;
    Eigen::Matrix4d bending;
    bending << 12, 6 * l, -12, 6 * l,         //
        6 * l, 4 * l * l, -6 * l, 2 * l * l,  //
        -12, -6 * l, 12, -6 * l,              //
        6 * l, 2 * l * l, -6 * l, 4 * l * l;
    constexpr std::array<int, 4> at{1, 2, 4, 5};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        local(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) +=
            EI / (l * l * l) * bending(i, j);
  }

  /// From the table's frame to the piece's.
  Matrix6 turn() const {
    Matrix6 turn = Matrix6::Identity();
    for (const int at : {0, 3}) {
      turn.block<1, 2>(at, at) = direction.transpose();
      turn.block<1, 2>(at + 1, at) << -direction.y(), direction.x();
    }
    return turn;
  }

  Matrix6 local;
  Point direction;
  double length = 0;
};

std::array<int, 6> unknowns_of(const Element& element) {
  const int from = 2 * static_cast<int>(element.from), to = 2 * static_cast<int>(element.to);
  return {from, from + 1, element.from_rotation, to, to + 1, element.to_rotation};
}

/// The two pieces of a plate.
std::array<Element, 2> pieces_of(std::array<Joint, 3> joints, int first_rotation, const Pose& pose,
                                 bool straight) {
  const auto [middle, one, other] = middle_first(joints, pose, straight);
  return {Element{middle, one, first_rotation, first_rotation + 1},
          Element{middle, other, first_rotation, first_rotation + 2}};
}

std::vector<Element> elements_of(const Pose& pose, bool straight) {
  std::vector<Element> all{{Joint::V, Joint::A, -1, -1}, {Joint::V, Joint::B, -1, -1}};
  const auto add = [&](std::array<Joint, 3> joints, int first_rotation) {
    for (const Element& piece : pieces_of(joints, first_rotation, pose, straight)) all.push_back(piece);
  };
  add({Joint::A, Joint::C, Joint::X}, joint_unknowns);
  add({Joint::B, Joint::C, Joint::Y}, joint_unknowns + 3);
  return all;
}

/// Largest and least length of a force or displacement over all unit forces at the pen.
std::array<double, 2> extremes(const Eigen::Matrix2d& columns) {
  const Eigen::Matrix2d squared = columns.transpose() * columns;
  const double middle = 0.5 * squared.trace();
  const double apart = std::hypot(0.5 * (squared(0, 0) - squared(1, 1)), squared(0, 1));
  return {std::sqrt(middle + apart), std::sqrt(std::max(0.0, middle - apart))};
}

/// The links' pull, N for each mm^3.
struct Pull {
  double each = 0;
};

class Frame {
 public:
  Frame(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
        const Material& material, std::optional<Pull> pull = std::nullopt)
      : roles_(roles), elements_(elements_of(pose, straight)) {
    const double EA = material.E * style.width * style.thickness;
    const double EI = material.E * style.thickness * std::pow(style.width, 3) / 12;
    for (const Element& element : elements_) {
      stiffness_.emplace_back(element, pose, EA, EI);
      spread_.push_back(0);
    }
    loads_ = Columns::Zero(all_unknowns, 2);
    if (pull)
      lay_weights(pose, straight, style, pull->each);
    else
      loads_.middleRows<2>(2 * static_cast<int>(roles.pen)).setIdentity();
    solve();
  }

  Eigen::Matrix2d at_joint(Joint joint) const {
    return displacement_.middleRows<2>(2 * static_cast<int>(joint));
  }
  /// What holds a joint, or pushes it.
  Eigen::Matrix2d reaction(Joint joint) const {
    return (assembled_ * displacement_).middleRows<2>(2 * static_cast<int>(joint));
  }
  /// What holds it beside the weight there.
  Eigen::Matrix2d support(Joint joint) const {
    return reaction(joint) - loads_.middleRows<2>(2 * static_cast<int>(joint));
  }
  /// Of a piece, in its own frame.
  Columns end_forces(std::size_t element) const {
    const auto unknowns = unknowns_of(elements_[element]);
    Columns own = Columns::Zero(6, 2);
    for (int i = 0; i < 6; ++i)
      if (const int at = unknowns[static_cast<std::size_t>(i)]; at >= 0) own.row(i) = displacement_.row(at);
    return stiffness_[element].local * stiffness_[element].turn() * own - held_ends(element);
  }
  /// What the pieces of one plate put on a joint, in the table's frame.
  Eigen::Matrix2d force_of_plate(std::size_t first_piece, Joint joint) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t i = first_piece; i < first_piece + 2; ++i) {
      const Columns forces = stiffness_[i].turn().transpose() * end_forces(i);
      if (elements_[i].from == joint) sum += forces.topRows<2>();
      if (elements_[i].to == joint) sum += forces.middleRows<2>(3);
    }
    return sum;
  }
  /// What pins put on a link at a joint, in the table's frame; `pieces` of it from the first one.
  Eigen::Matrix2d by_pins(Link link, std::size_t first_piece, std::size_t pieces, Joint joint) const {
    Eigen::Matrix2d sum = -Eigen::Matrix2d::Identity() *
                          lumps_[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)];
    for (std::size_t i = first_piece; i < first_piece + pieces; ++i) {
      const Columns forces = stiffness_[i].turn().transpose() * end_forces(i);
      if (elements_[i].from == joint) sum += forces.topRows<2>();
      if (elements_[i].to == joint) sum += forces.middleRows<2>(3);
    }
    return sum;
  }
  double length_of(std::size_t element) const { return stiffness_[element].length; }
  /// N/mm, along a piece and to its left.
  Eigen::Matrix2d spread_on(std::size_t element) const {
    return spread_[element] * stiffness_[element].turn().topLeftCorner<2, 2>();
  }

 private:
  /// The forces and moments that do what the spread weight does, at both ends in the piece's frame.
  Columns held_ends(std::size_t element) const {
    Columns ends = Columns::Zero(6, 2);
    const Eigen::Matrix2d spread = spread_on(element);
    const double L = stiffness_[element].length;
    ends.topRows<2>() = ends.middleRows<2>(3) = 0.5 * L * spread;
    if (elements_[element].is_bar()) return ends;
    ends.row(2) = L * L / 12 * spread.row(1);
    ends.row(5) = -ends.row(2);
    return ends;
  }

  void lay_weights(const Pose& pose, bool straight, const LinkStyle& style, double pull) {
    const double of_area = pull * style.thickness, w = style.width;
    const auto lump = [&](Link link, Joint joint, double area) {
      lumps_[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)] += of_area * area;
      loads_.middleRows<2>(2 * static_cast<int>(joint)) += of_area * area * Eigen::Matrix2d::Identity();
    };
    const bool triangles = !straight && style.plate == PlateStyle::triangle;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (triangles && !elements_[e].is_bar()) continue;
      spread_[e] = of_area * w;
      const Columns ends = stiffness_[e].turn().transpose() * held_ends(e);
      const auto at = unknowns_of(elements_[e]);
      for (int i = 0; i < 6; ++i)
        if (const int row = at[static_cast<std::size_t>(i)]; row >= 0) loads_.row(row) += ends.row(i);
    }
    for (const Joint end : {Joint::V, Joint::A}) lump(Link::VA, end, pi * w * w / 8);
    for (const Joint end : {Joint::V, Joint::B}) lump(Link::VB, end, pi * w * w / 8);
    for (const Link link : {Link::ACX, Link::BCY}) {
      const std::array<Joint, 3> joints = middle_first(joints_of(link).joints, pose, straight);
      const Point a = place_of(pose, joints[0]), b = place_of(pose, joints[1]), c = place_of(pose, joints[2]);
      if (!triangles) {
        for (const std::size_t end : {1U, 2U}) lump(link, joints[end], pi * w * w / 8);
        continue;
      }
      const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
      const Point u = b - a, v = c - a;
      const double third = std::abs(u.x() * v.y() - u.y() * v.x()) / 6 + pi * w * w / 12;
      lump(link, joints[0], third + 0.25 * w * (ab + ca));
      lump(link, joints[1], third + 0.25 * w * (ab + bc));
      lump(link, joints[2], third + 0.25 * w * (bc + ca));
    }
  }

  void solve() {
    assembled_ = Eigen::MatrixXd::Zero(all_unknowns, all_unknowns);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const Matrix6 global = stiffness_[e].turn().transpose() * stiffness_[e].local * stiffness_[e].turn();
      const auto at = unknowns_of(elements_[e]);
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
          if (at[i] >= 0 && at[j] >= 0)
            assembled_(at[i], at[j]) += global(static_cast<int>(i), static_cast<int>(j));
    }
    std::vector<int> free;
    for (int i = 0; i < all_unknowns; ++i) {
      const bool held = i / 2 == static_cast<int>(roles_.pole) || i / 2 == static_cast<int>(roles_.tracer);
      if (i >= joint_unknowns || !held) free.push_back(i);
    }
    const Eigen::MatrixXd inside = assembled_(free, free);
    const Eigen::FullPivLU<Eigen::MatrixXd> factors(inside);
    displacement_ = Columns::Zero(all_unknowns, 2);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::VectorXd force = loads_.col(axis);
      const Eigen::VectorXd moved = solution_of(factors, force(free));
      for (std::size_t i = 0; i < free.size(); ++i)
        displacement_(free[i], axis) = moved[static_cast<Eigen::Index>(i)];
    }
  }

  JointRoles roles_;
  std::vector<Element> elements_;
  std::vector<Stiffness> stiffness_;
  std::vector<double> spread_;                    ///< N/mm, of each piece
  std::array<std::array<double, 6>, 4> lumps_{};  ///< N, of each link at its joints alone
  Eigen::MatrixXd assembled_;
  Columns loads_, displacement_;
};

/// What a section resists with.
struct PlaneSection {
  PlaneSection(const LinkStyle& style, double hole)
      : area(style.thickness * (style.width - hole)),
        modulus(style.thickness * (std::pow(style.width, 3) - std::pow(hole, 3)) / (6 * style.width)) {}
  double area, modulus;
};

constexpr std::array<std::size_t, 6> link_of_piece{0, 1, 2, 2, 3, 3};

/// Bending and pull over the net section at the beginning of each piece of a plate, pull in the bars; by link.
std::array<double, 4> stresses_in(const Frame& frame, const LinkStyle& style, double hole) {
  std::array<double, 4> largest{};
  if (!(hole < style.width)) {
    largest.fill(HUGE_VAL);
    return largest;
  }
  const PlaneSection net(style, hole);
  for (std::size_t i = 0; i < 6; ++i) {
    const Columns forces = frame.end_forces(i);
    double& of_link = largest[link_of_piece[i]];
    for (const double side : {-1.0, 1.0})
      of_link = std::max(of_link, (forces.row(0) / net.area + side * forces.row(2) / net.modulus).norm());
  }
  return largest;
}

/// The same anywhere in a piece that bears its own weight: at its ends over the net section, between them over the whole one where the stress of
/// one side, a parabola through three places, has its vertex.
double stress_along(const Frame& frame, std::size_t piece, const LinkStyle& style, double hole) {
  const PlaneSection net(style, hole), whole(style, 0);
  const Columns ends = frame.end_forces(piece);
  const Eigen::Matrix2d spread = frame.spread_on(piece);
  const double L = frame.length_of(piece);
  return most_in_any_direction([&](double direction) {
    const Point way(std::cos(direction), std::sin(direction));
    const Eigen::Vector<double, 6> end = ends * way;
    const Point load = spread * way;
    const auto stress = [&](const PlaneSection& section, double side, double x) {
      const double pull = end[0] + load.x() * x, bending = end[2] - end[1] * x - 0.5 * load.y() * x * x;
      return pull / section.area + side * bending / section.modulus;
    };
    double most = 0;
    for (const double side : {-1.0, 1.0}) {
      const double low = stress(whole, side, 0), middle = stress(whole, side, 0.5 * L),
                   high = stress(whole, side, L),
                   vertex = 0.5 * L + 0.25 * L * (low - high) / (low - 2 * middle + high);
      most = std::max({most, std::abs(stress(net, side, 0)), std::abs(stress(net, side, L))});
      if (vertex > 0 && vertex < L) most = std::max(most, std::abs(stress(whole, side, vertex)));
    }
    return most;
  });
}

}  // namespace

FrameResponse frame_response(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
                             const Material& material, double hole) {
  const Frame frame(pose, roles, straight, style, material);
  const auto given = extremes(frame.at_joint(roles.pen));
  const auto in_bar = [&](std::size_t bar) { return frame.end_forces(bar).row(0).norm(); };
  const std::array<double, 4> pins{in_bar(0), in_bar(1), extremes(frame.force_of_plate(2, Joint::C))[0],
                                   extremes(frame.reaction(roles.pole))[0]};
  const std::array<double, 4> stresses = stresses_in(frame, style, hole);
  return {.worst = given[0],
          .least = given[1],
          .pin_force = *std::max_element(pins.begin(), pins.end()),
          .hand_force = extremes(frame.reaction(roles.tracer))[0],
          .stress = *std::max_element(stresses.begin(), stresses.end()),
          .pins = pins,
          .stresses = stresses};
}

FrameUnderWeight frame_under_weight(const Pose& pose, const JointRoles& roles, bool straight,
                                    const LinkStyle& style, const Material& material, double hole,
                                    double pull) {
  const Frame frame(pose, roles, straight, style, material, Pull{pull});
  const auto on = [&](Link link, std::size_t first_piece, std::size_t pieces, Joint joint) {
    return extremes(frame.by_pins(link, first_piece, pieces, joint))[0];
  };
  FrameUnderWeight result{.most = extremes(frame.at_joint(roles.pen))[0],
                          .moved = frame.at_joint(roles.pen),
                          .pins = {std::max(on(Link::VA, 0, 1, Joint::A), on(Link::VA, 0, 1, Joint::V)),
                                   std::max(on(Link::VB, 1, 1, Joint::B), on(Link::VB, 1, 1, Joint::V)),
                                   on(Link::ACX, 2, 2, Joint::C), extremes(frame.support(roles.pole))[0]}};
  if (!(hole < style.width)) {
    result.stresses.fill(HUGE_VAL);
    return result;
  }
  for (std::size_t piece = 0; piece < link_of_piece.size(); ++piece) {
    double& of_link = result.stresses[link_of_piece[piece]];
    of_link = std::max(of_link, stress_along(frame, piece, style, hole));
  }
  return result;
}

}  // namespace kempe
