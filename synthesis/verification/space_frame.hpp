#pragma once
// A copying linkage as a frame in space by the stiffness method: every link's arms are beams at the height of its layer's middle, every pin is a
// beam from layer to layer that turns freely in the upper link, the post is clamped in the table. No grillage, no force and no compliance of the
// library is used.

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/complex_vectors.hpp"
#include "kinematics/copying_linkage.hpp"
#include "workspace/parts.hpp"

namespace kempe::space_frame {

/// A beam's section: stiffnesses of pull, of bending along and across z (see SpaceFrame::add), of twist; shear as compliance per length.
struct Section {
  double EA, EI_first, EI_second, GJ, shear = 0;
};

using Vector3 = Eigen::Vector3d;
/// Numbers of the six freedoms of a beam's end: displacements x, y, z and turns about x, y, z.
using Freedoms = std::array<int, 6>;

class Frame {
 public:
  int freedom() { return count_++; }
  Freedoms node() {
    Freedoms all;
    for (int& one : all) one = freedom();
    return all;
  }

  /// A beam along `way` (any vector); `first` is a unit vector at right angles to it: EI_first resists displacements along it.
  void add(const Freedoms& from, const Freedoms& to, const Vector3& way, const Vector3& first,
           const Section& section) {
    const double L = way.norm();
    const Vector3 x = way / L, y = first, z = x.cross(y);
    Eigen::Matrix<double, 12, 12> local = Eigen::Matrix<double, 12, 12>::Zero();
    const auto spring = [&](int at, double stiffness) {
      local(at, at) += stiffness;
      local(at + 6, at + 6) += stiffness;
      local(at, at + 6) -= stiffness;
      local(at + 6, at) -= stiffness;
    };
    spring(0, section.EA / L);
    spring(3, section.GJ / L);
    // Displacement along an axis goes with a turn about the other one: along y with z, along z with -y.
    const auto bend = [&](int shift, int turn, double sign, double EI) {
      const double phi = 12 * EI * section.shear / (L * L), c = EI / (L * L * L * (1 + phi));
      const std::array<int, 4> at{shift, turn, shift + 6, turn + 6};
      Eigen::Matrix4d k;
      k << 12, 6 * L, -12, 6 * L, 6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L, -12, -6 * L, 12,
          -6 * L, 6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          local(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) +=
              c * k(i, j) * (i % 2 ? sign : 1) * (j % 2 ? sign : 1);
    };
    bend(1, 5, 1, section.EI_first);
    bend(2, 4, -1, section.EI_second);
    Eigen::Matrix3d axes;
    axes << x.transpose(), y.transpose(), z.transpose();
    Eigen::Matrix<double, 12, 12> turn = Eigen::Matrix<double, 12, 12>::Zero();
    for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = axes;
    const Eigen::Matrix<double, 12, 12> global = turn.transpose() * local * turn;
    std::array<int, 12> at;
    for (std::size_t i = 0; i < 6; ++i) {
      at[i] = from[i];
      at[i + 6] = to[i];
    }
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = 0; j < 12; ++j)
        entries_[{at[i], at[j]}] += global(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }

  void hold(int freedom) { held_.push_back(freedom); }

  /// Displacements for each column of forces, given as freedom and size.
  Eigen::MatrixXd moved(const std::vector<std::pair<int, double>>& forces) const {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count_, count_);
    for (const auto& [at, value] : entries_) stiffness(at.first, at.second) = value;
    for (const int one : held_) {
      stiffness.row(one).setZero();
      stiffness.col(one).setZero();
      stiffness(one, one) = 1;
    }
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count_, static_cast<Eigen::Index>(forces.size()));
    for (std::size_t i = 0; i < forces.size(); ++i)
      right(forces[i].first, static_cast<Eigen::Index>(i)) = forces[i].second;
    return stiffness.fullPivLu().solve(right);
  }

 private:
  int count_ = 0;
  std::map<std::pair<int, int>, double> entries_;
  std::vector<int> held_;
};

/// What the pen does for each newton: in the plane, and how far tracer and pen rise.
struct Answer {
  Eigen::Matrix2d in_plane;
  Eigen::RowVector2d tracer_rise, pen_rise;
};

struct Build {
  LinkStyle style;
  LayerAssignment layers;
  double E, G, J;  ///< of the links; J of their sections, mm^4
  bool tracer_rests = false, pen_rests = false;
};

/// Bar VA along x, V at the origin.
inline Answer answer(const CopyingLinkage& linkage, double opening, const Build& build) {
  const Complex s = linkage.shape(), p = linkage.VA(), q = std::polar(linkage.VB(), opening);
  const std::map<Joint, Complex> at{{Joint::V, 0.0},   {Joint::A, p},         {Joint::B, q},
                                    {Joint::C, p + q}, {Joint::X, p + q / s}, {Joint::Y, q + p * s}};
  const double width = build.style.width, thick = build.style.thickness, d = build.style.pin_diameter;
  Frame frame;
  std::map<std::pair<Link, Joint>, Freedoms> nodes;
  const auto arms = [&](Link link) -> std::vector<std::pair<Joint, Joint>> {
    if (link == Link::VA) return {{Joint::V, Joint::A}};
    if (link == Link::VB) return {{Joint::V, Joint::B}};
    const Joint corner = link == Link::ACX ? Joint::A : Joint::B,
                end = link == Link::ACX ? Joint::X : Joint::Y;
    const std::array<Joint, 3> all{corner, Joint::C, end};
    for (std::size_t i = 0; i < 3; ++i) {
      const Joint middle = all[i], one = all[(i + 1) % 3], other = all[(i + 2) % 3];
      const Complex a = at.at(one) - at.at(middle), b = at.at(other) - at.at(middle);
      if ((a * std::conj(b)).real() < -(1 - 1e-9) * std::abs(a) * std::abs(b))
        return {{middle, one}, {middle, other}};
    }
    return {{corner, Joint::C}, {corner, end}};
  };
  const Section bar{build.E * width * thick, build.E * thick * std::pow(width, 3) / 12,
                    build.E * width * std::pow(thick, 3) / 12, build.G * build.J};
  for (const Link link : {Link::VA, Link::VB, Link::ACX, Link::BCY})
    for (const auto& [from, to] : arms(link)) {
      for (const Joint joint : {from, to})
        if (!nodes.contains({link, joint})) nodes[{link, joint}] = frame.node();
      const Complex way = at.at(to) - at.at(from), across = Complex(0, 1) * way / std::abs(way);
      frame.add(nodes[{link, from}], nodes[{link, to}], {way.real(), way.imag(), 0},
                {across.real(), across.imag(), 0}, bar);
    }
  constexpr double steel_E = 200e3, steel_G = 77e3;
  const double area = pi * d * d / 4, I = pi * std::pow(d, 4) / 64;
  // A pin hardly gets shorter; the closed form has it that it does not.
  const Section round{1000 * steel_E * area, steel_E * I, steel_E * I, steel_G * 2 * I,
                      10 / (9 * steel_G * area)};
  const auto rise_to = [&](const Freedoms& from, Link link, Joint joint, double height) {
    Freedoms top = nodes.at({link, joint});
    top[5] = frame.freedom();
    frame.add(from, top, {0, 0, height}, {1, 0, 0}, round);
    return top;
  };
  const auto join = [&](Joint joint, Link one, Link other) {
    const bool swap = build.layers[one] > build.layers[other];
    const Link lower = swap ? other : one, upper = swap ? one : other;
    rise_to(nodes.at({lower, joint}), upper, joint, thick * (build.layers[upper] - build.layers[lower]));
  };
  join(Joint::A, Link::VA, Link::ACX);
  join(Joint::B, Link::VB, Link::BCY);
  join(Joint::C, Link::ACX, Link::BCY);
  const Freedoms table = frame.node();
  for (const int one : table) frame.hold(one);
  if (linkage.grounding() == Grounding::pole) {
    const bool swap = build.layers[Link::VA] > build.layers[Link::VB];
    const Link lower = swap ? Link::VB : Link::VA, upper = swap ? Link::VA : Link::VB;
    const Freedoms post = rise_to(table, lower, Joint::V, thick * (build.layers[lower] - 0.5));
    rise_to(post, upper, Joint::V, thick * (build.layers[upper] - build.layers[lower]));
  } else {
    rise_to(table, Link::ACX, Joint::X, thick * (build.layers[Link::ACX] - 0.5));
    join(Joint::V, Link::VA, Link::VB);
  }
  const auto point = [&](Joint joint) {
    return nodes.at({joint == Joint::V ? Link::VA : joint == Joint::X ? Link::ACX : Link::BCY, joint});
  };
  const Freedoms tracer = point(linkage.tracer_joint()), pen = point(linkage.pen_joint());
  frame.hold(tracer[0]);
  frame.hold(tracer[1]);
  if (build.tracer_rests) frame.hold(tracer[2]);
  if (build.pen_rests) frame.hold(pen[2]);
  const Eigen::MatrixXd moved = frame.moved({{pen[0], 1}, {pen[1], 1}});
  Answer result;
  for (int i = 0; i < 2; ++i) {
    result.in_plane(0, i) = moved(pen[0], i);
    result.in_plane(1, i) = moved(pen[1], i);
    result.tracer_rise[i] = moved(tracer[2], i);
    result.pen_rise[i] = moved(pen[2], i);
  }
  return result;
}

}  // namespace kempe::space_frame
