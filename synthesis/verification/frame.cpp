// Unknowns: x and y of the six joints, then the rotation of each plate at each of its three joints.

#include "synthesis/verification/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/decompositions.hpp"
#include "synthesis/verification/plate_pieces.hpp"

namespace kempe {
namespace {

constexpr int joint_unknowns = 12, all_unknowns = 18;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
/// Columns: the force at the pen along x and along y.
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

class Frame {
 public:
  Frame(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
        const Material& material)
      : roles_(roles), elements_(elements_of(pose, straight)) {
    const double EA = material.E * style.width * style.thickness;
    const double EI = material.E * style.thickness * std::pow(style.width, 3) / 12;
    for (const Element& element : elements_) stiffness_.emplace_back(element, pose, EA, EI);
    solve();
  }

  Eigen::Matrix2d at_joint(Joint joint) const {
    return displacement_.middleRows<2>(2 * static_cast<int>(joint));
  }
  /// What holds a joint, or pushes it.
  Eigen::Matrix2d reaction(Joint joint) const {
    return (assembled_ * displacement_).middleRows<2>(2 * static_cast<int>(joint));
  }
  /// Of a piece, in its own frame.
  Columns end_forces(std::size_t element) const {
    const auto unknowns = unknowns_of(elements_[element]);
    Columns own = Columns::Zero(6, 2);
    for (int i = 0; i < 6; ++i)
      if (const int at = unknowns[static_cast<std::size_t>(i)]; at >= 0) own.row(i) = displacement_.row(at);
    return stiffness_[element].local * stiffness_[element].turn() * own;
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
  double length_of(std::size_t element) const { return stiffness_[element].length; }

 private:
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
      Eigen::VectorXd force = Eigen::VectorXd::Zero(all_unknowns);
      force[2 * static_cast<int>(roles_.pen) + axis] = 1;
      const Eigen::VectorXd moved = solution_of(factors, force(free));
      for (std::size_t i = 0; i < free.size(); ++i)
        displacement_(free[i], axis) = moved[static_cast<Eigen::Index>(i)];
    }
  }

  JointRoles roles_;
  std::vector<Element> elements_;
  std::vector<Stiffness> stiffness_;
  Eigen::MatrixXd assembled_;
  Columns displacement_;
};

/// Bending and pull over the net section at the beginning of each piece of a plate, pull in the bars.
double stress_in(const Frame& frame, const LinkStyle& style, double hole) {
  if (!(hole < style.width)) return HUGE_VAL;
  const double area = style.thickness * (style.width - hole);
  const double modulus = style.thickness * (std::pow(style.width, 3) - std::pow(hole, 3)) / (6 * style.width);
  double largest = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Columns forces = frame.end_forces(i);
    for (const double side : {-1.0, 1.0})
      largest = std::max(largest, (forces.row(0) / area + side * forces.row(2) / modulus).norm());
  }
  return largest;
}

}  // namespace

FrameResponse frame_response(const Pose& pose, const JointRoles& roles, bool straight, const LinkStyle& style,
                             const Material& material, double hole) {
  const Frame frame(pose, roles, straight, style, material);
  const auto given = extremes(frame.at_joint(roles.pen));
  const auto in_bar = [&](std::size_t bar) { return frame.end_forces(bar).row(0).norm(); };
  const double pin_C = extremes(frame.force_of_plate(2, Joint::C))[0];
  const double pole = extremes(frame.reaction(roles.pole))[0];
  return {.worst = given[0],
          .least = given[1],
          .pin_force = std::max({in_bar(0), in_bar(1), pin_C, pole}),
          .hand_force = extremes(frame.reaction(roles.tracer))[0],
          .stress = stress_in(frame, style, hole)};
}

}  // namespace kempe
