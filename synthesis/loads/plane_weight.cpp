#include "synthesis/loads/plane_weight.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "kinematics/assembly_mode.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/link_arms.hpp"
#include "synthesis/loads/over_directions.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

std::size_t number(Joint joint) { return static_cast<std::size_t>(joint); }
std::size_t number(Link link) { return static_cast<std::size_t>(link); }

Complex& at(ForcesOnLinks& forces, Link link, Joint joint) { return forces[number(link)][number(joint)]; }
const Complex& at(const ForcesOnLinks& forces, Link link, Joint joint) {
  return forces[number(link)][number(joint)];
}

/// An arm seen from the joint in its plate's middle, of a bar from V.
struct LongArm {
  Link link;
  Joint end;
  bool ends_there;  ///< `end` is its LinkArm::to
  Complex way;      ///< mm, to `end`
  double per_mm;    ///< N/mm, its weight
};

/// The largest of a vector that is linear in a direction, from what it is for x and for y.
double most_of(Complex by_x, Complex by_y) {
  Eigen::Matrix2d columns;
  columns << by_x.real(), by_y.real(), by_x.imag(), by_y.imag();
  return larger_singular_value(columns);
}

}  // namespace

/// How the weight lies on a linkage.
struct PlaneWeight::Weights {
  std::vector<LongArm> arms;
  std::array<std::array<double, 6>, 4> at_joints{};  ///< N, of each link: halves of its arms, and its ends
  std::array<double, 6> sums() const {
    std::array<double, 6> all{};
    for (const auto& link : at_joints)
      for (std::size_t joint = 0; joint < all.size(); ++joint) all[joint] += link[joint];
    return all;
  }
};

/// A linkage that is held at pole and tracer and loaded at its joints; loads at A act on ACX, those at B on BCY.
struct PlaneWeight::Held {
  ForcesOnLinks on{};
  Complex post = 0, hand = 0;
};

PlaneWeight::PlaneWeight(Complex k, Grounding grounding, const LinkStyle& style, const Material& material,
                         double tilt, const PinCompliance& pins, Link upper_at_V)
    : shape_(shape_of(k, grounding)), roles_(roles_of(grounding)), style_(style), E_(material.E),
      per_area_(gravity_along(tilt) * material.density * cubic_metres_per_mm3 * style.thickness), pins_(pins),
      upper_at_V_(upper_at_V) {}

PlaneWeight::Weights PlaneWeight::weights_of(const BarLengths& lengths, double opening) const {
  const double width = style_.width;
  const Complex q = std::polar(lengths.VB, opening);
  const auto place = [&](Joint joint) {
    const LinkagePoint point = linkage_point(joint, shape_);
    return point.of_p * lengths.VA + point.of_q * q;
  };
  Weights weights;
  const auto lump = [&](Link link, Joint joint, double area) {
    weights.at_joints[number(link)][number(joint)] += per_area_ * area;
  };
  const bool triangles = style_.plate == PlateStyle::triangle && !is_straight(shape_);
  for (const Link link : all_links) {
    const LinkJoints of_link = joints_of(link);
    const bool is_triangle = triangles && of_link.count == 3;
    const std::vector<LinkArm> arms = arms_of(link, shape_);
    const std::array<Joint, 2> ends = ends_of(arms);
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const bool ends_there = arms.size() == 1 || arms[i].to == ends[i];
      const Joint end = ends_there ? arms[i].to : arms[i].from,
                  middle = ends_there ? arms[i].from : arms[i].to;
      const Complex way = place(end) - place(middle);
      weights.arms.push_back({link, end, ends_there, way, is_triangle ? 0 : per_area_ * width});
      if (is_triangle) continue;
      for (const Joint joint : {end, middle}) lump(link, joint, 0.5 * width * std::abs(way));
    }
    if (!is_triangle) {
      for (const Joint end : ends) lump(link, end, pi * width * width / 8);
      continue;
    }
    const auto& corners = of_link.joints;
    const double inside =
        0.5 * std::abs(cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0])));
    for (std::size_t i = 0; i < 3; ++i) {
      const Complex here = place(corners[i]);
      const double sides =
          std::abs(place(corners[(i + 1) % 3]) - here) + std::abs(place(corners[(i + 2) % 3]) - here);
      lump(link, corners[i], inside / 3 + 0.25 * width * sides + pi * width * width / 12);
    }
  }
  return weights;
}

PlaneWeight::Held PlaneWeight::held_under(const std::array<Complex, 6>& loads, const BarLengths& lengths,
                                          double opening) const {
  const auto load = [&](Joint joint) { return loads[number(joint)]; };
  const Complex s = shape_, along_q = std::polar(1.0, opening), p = lengths.VA, q = lengths.VB * along_q;
  const double sine = along_q.imag();

  // G from the two virtual turns.
  const Complex by_p = i_unit * p, by_q = i_unit * q / s;
  const double turn_p = -dot(i_unit * p, load(Joint::A) + load(Joint::C)),
               turn_q = -dot(i_unit * q, load(Joint::B) + load(Joint::C));
  const Complex G = i_unit * (turn_q * by_p - turn_p * by_q) / cross(by_p, by_q);

  // All that acts on V, X and Y from outside; at the pen that is its load.
  const Complex inside = load(Joint::A) + load(Joint::B) + load(Joint::C);
  Complex F_V, F_X, F_Y;
  if (roles_.pen == Joint::V) {
    F_V = load(Joint::V);
    F_Y = (G + inside + F_V) / (std::conj(s) - 1.0);
    F_X = -inside - F_V - F_Y;
  } else {
    F_Y = load(Joint::Y);
    F_X = G - std::conj(s) * F_Y;
    F_V = -inside - F_X - F_Y;
  }

  // What the bars push with along themselves, from the moments of each plate about C.
  const double by_VA = (cross(q, load(Joint::A)) - cross(q * (1.0 / s - 1.0), F_X)) / (lengths.VB * sine),
               by_VB = -(cross(p, load(Joint::B)) - cross(p * (s - 1.0), F_Y)) / (lengths.VA * sine);
  Held held;
  ForcesOnLinks& on = held.on;
  at(on, Link::VA, Joint::V) = by_VA;
  at(on, Link::VA, Joint::A) = -by_VA;
  at(on, Link::VB, Joint::V) = by_VB * along_q;
  at(on, Link::VB, Joint::B) = -by_VB * along_q;
  at(on, Link::ACX, Joint::A) = by_VA + load(Joint::A);
  at(on, Link::ACX, Joint::X) = F_X;
  at(on, Link::ACX, Joint::C) = -by_VA - load(Joint::A) - F_X;
  at(on, Link::BCY, Joint::B) = by_VB * along_q + load(Joint::B);
  at(on, Link::BCY, Joint::Y) = F_Y;
  at(on, Link::BCY, Joint::C) = -by_VB * along_q - load(Joint::B) - F_Y;
  const auto holds = [&](Joint joint) {
    return (joint == Joint::V ? F_V : joint == Joint::X ? F_X : F_Y) - load(joint);
  };
  held.post = holds(roles_.pole);
  held.hand = holds(roles_.tracer);
  return held;
}

UnderWeight PlaneWeight::under(const BarLengths& lengths, double opening, Complex direction) const {
  const Weights weights = weights_of(lengths, opening);
  std::array<Complex, 6> loads{};
  const std::array<double, 6> sums = weights.sums();
  for (std::size_t joint = 0; joint < loads.size(); ++joint) loads[joint] = sums[joint] * direction;
  const Held held = held_under(loads, lengths, opening);
  UnderWeight result{held.on, held.on, held.post, held.hand};
  for (std::size_t link = 0; link < 4; ++link)
    for (std::size_t joint = 0; joint < loads.size(); ++joint)
      result.by_pins[link][joint] -= weights.at_joints[link][joint] * direction;
  return result;
}

PinPulls PlaneWeight::pulls(const BarLengths& lengths, double opening, Complex direction,
                            Complex pen_force) const {
  std::array<Complex, 6> loads{};
  loads[number(roles_.pen)] = pen_force;
  const Held by_pen = held_under(loads, lengths, opening);
  const UnderWeight by_weight = under(lengths, opening, direction);
  const auto both = [&](Link link, Joint joint) {
    return at(by_pen.on, link, joint) + at(by_weight.by_pins, link, joint);
  };
  return {both(Link::VA, Joint::A), both(Link::VB, Joint::B), both(Link::ACX, Joint::C),
          both(Link::VB, Joint::V), both(Link::VA, Joint::V), by_pen.post + by_weight.post};
}

double PlaneWeight::work_in_arms(const ForcesOnLinks& by_force, const ForcesOnLinks& by_weight,
                                 const Weights& weights, Complex direction) const {
  const double EA = E_ * style_.width * style_.thickness,
               EI = E_ * style_.thickness * std::pow(style_.width, 3) / 12;
  double work = 0;
  for (const LongArm& arm : weights.arms) {
    const double L = std::abs(arm.way);
    const Complex along = arm.way / L, across = i_unit * along, force = at(by_force, arm.link, arm.end),
                  weight = at(by_weight, arm.link, arm.end);
    work += dot(along, force) * dot(along, weight) * L / EA;
    if (arm.link == Link::VA || arm.link == Link::VB) continue;
    const double bent = dot(across, weight) / 3 - arm.per_mm * dot(across, direction) * L / 24;
    work += dot(across, force) * bent * L * L * L / EI;
  }
  return work;
}

double PlaneWeight::work_in_pins(const Held& by_force, const UnderWeight& by_weight) const {
  const auto work = [&](double compliance, Link link, Joint joint) {
    return compliance * dot(at(by_force.on, link, joint), at(by_weight.by_pins, link, joint));
  };
  return work(pins_.A, Link::VA, Joint::A) + work(pins_.B, Link::VB, Joint::B) +
         work(pins_.C, Link::BCY, Joint::C) + work(pins_.V, upper_at_V_, Joint::V) +
         pins_.pole * dot(by_force.post, by_weight.post);
}

Eigen::Matrix2d PlaneWeight::give(const BarLengths& lengths, double opening) const {
  const Weights weights = weights_of(lengths, opening);
  const std::array<Complex, 2> axes{1, i_unit};
  Eigen::Matrix2d moved;
  for (Eigen::Index column : {0, 1}) {
    const Complex direction = axes[static_cast<std::size_t>(column)];
    const UnderWeight by_weight = under(lengths, opening, direction);
    for (Eigen::Index row : {0, 1}) {
      std::array<Complex, 6> loads{};
      loads[number(roles_.pen)] = axes[static_cast<std::size_t>(row)];
      const Held by_force = held_under(loads, lengths, opening);
      moved(row, column) = work_in_arms(by_force.on, by_weight.with_halves, weights, direction) +
                           work_in_pins(by_force, by_weight);
    }
  }
  return moved;
}

double PlaneWeight::most(const BarLengths& lengths, double opening) const {
  return weighs() ? larger_singular_value(give(lengths, opening)) : 0;
}

double PlaneWeight::most_over(const BarLengths& lengths, const OpeningInterval& openings) const {
  const auto value = [&](double opening) { return most(lengths, opening); };
  return value(top_over(openings, value));
}

PinForces PlaneWeight::pin_forces(const BarLengths& lengths, double opening) const {
  if (!weighs()) return {};
  const UnderWeight x = under(lengths, opening, 1), y = under(lengths, opening, i_unit);
  const auto most = [&](Link link, Joint joint) {
    return most_of(at(x.by_pins, link, joint), at(y.by_pins, link, joint));
  };
  PinForces pins;
  pins.A = std::max(most(Link::VA, Joint::A), most(Link::VA, Joint::V));
  pins.B = pins.V = std::max(most(Link::VB, Joint::B), most(Link::VB, Joint::V));
  pins.C = most(Link::ACX, Joint::C);
  pins.pole = most_of(x.post, y.post);
  return pins;
}

std::vector<PieceForces> PlaneWeight::pieces(const BarLengths& lengths, double opening,
                                             Complex direction) const {
  const Weights weights = weights_of(lengths, opening);
  const ForcesOnLinks forces = under(lengths, opening, direction).with_halves;
  std::vector<PieceForces> pieces;
  for (const LongArm& arm : weights.arms) {
    const double L = std::abs(arm.way);
    const Complex along = arm.way / L, across = i_unit * along, force = at(forces, arm.link, arm.end);
    const bool is_bar = arm.link == Link::VA || arm.link == Link::VB;
    const double way = arm.ends_there ? -1 : 1, pulled = arm.per_mm * L * dot(along, direction),
                 moment = is_bar ? 0 : L * dot(across, force);
    PieceForces piece;
    piece.pull = dot(along, force) - 0.5 * way * pulled;
    piece.pull_growth = way * pulled;
    piece.in_plane[arm.ends_there ? 0 : 1] = moment;
    piece.own_weight_in_plane = -0.5 * arm.per_mm * L * L * dot(across, direction);
    pieces.push_back(piece);
  }
  return pieces;
}

LinkStresses PlaneWeight::stresses(const BarLengths& lengths, double opening, double hole) const {
  if (!weighs()) return {};
  if (!(hole < style_.width)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const SectionModuli at_joints = section_moduli(style_, hole), between = section_moduli(style_, 0);
  const std::vector<PieceForces> by_x = pieces(lengths, opening, 1), by_y = pieces(lengths, opening, i_unit);
  std::array<double, 4> most{};
  std::size_t number_of_piece = 0;
  for (const Link link : all_links)
    for (std::size_t i = 0; i < arms_of(link, shape_).size(); ++i, ++number_of_piece) {
      const std::array<PieceForces, 2> by_axis{by_x[number_of_piece], by_y[number_of_piece]};
      const double here = most_over_directions(
          [&](double direction) { return largest_stress(turned(by_axis, direction), at_joints, between); },
          parts_without);
      most[number(link)] = std::max(most[number(link)], std::isfinite(here) ? here : infinity);
    }
  return {most[number(Link::VA)], most[number(Link::VB)], most[number(Link::ACX)], most[number(Link::BCY)]};
}

PieceForces turned(const std::array<PieceForces, 2>& by_axis, double direction) {
  const auto& [x, y] = by_axis;
  const double c = std::cos(direction), s = std::sin(direction);
  PieceForces forces;
  forces.pull = c * x.pull + s * y.pull;
  forces.pull_growth = c * x.pull_growth + s * y.pull_growth;
  for (const std::size_t end : {0U, 1U}) {
    forces.in_plane[end] = c * x.in_plane[end] + s * y.in_plane[end];
    forces.out_of_plane[end] = c * x.out_of_plane[end] + s * y.out_of_plane[end];
  }
  forces.own_weight_in_plane = c * x.own_weight_in_plane + s * y.own_weight_in_plane;
  forces.own_weight = c * x.own_weight + s * y.own_weight;
  forces.twist = c * x.twist + s * y.twist;
  return forces;
}

double larger_singular_value(const Eigen::Matrix2d& matrix) {
  // matrix u = a u + b conj(u) for a complex u.
  const Complex a(matrix(0, 0) + matrix(1, 1), matrix(1, 0) - matrix(0, 1)),
      b(matrix(0, 0) - matrix(1, 1), matrix(1, 0) + matrix(0, 1));
  return 0.5 * (std::abs(a) + std::abs(b));
}

}  // namespace kempe
