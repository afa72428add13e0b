#pragma once
// The links of a copying linkage as an engineer draws them free: every one in balance under the forces of its pins, with moments of
// friction if there are any.

#include <Eigen/Dense>
#include <array>

#include "kinematics/copying_linkage.hpp"
#include "tests/random.hpp"

namespace kempe::free_links {

using test::uniform;

inline CopyingLinkage random_linkage(std::mt19937_64& random) {
  for (;;) {
    const Complex k = copy_ratio(std::exp(uniform(random, -1, 1)),
                                 uniform(random, 0, 4) < 1 ? pi : uniform(random, -pi, pi));
    if (std::abs(k - 1.0) < 0.3) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(uniform(random, 0, 3))];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const auto mode = static_cast<std::size_t>(uniform(random, 0, static_cast<double>(modes.size())));
    if (modes[mode].openings.width() < 1) continue;
    return *CopyingLinkage::make(k, grounding, uniform(random, 60, 300), uniform(random, 60, 300),
                                 static_cast<int>(mode), {10, 20});
  }
}

/// The numbers of the links, and of the ground.
enum { VA, VB, ACX, BCY, ground };
struct PinOf {
  Joint joint;
  int link, other;
};

inline int link_with(Joint joint) { return joint == Joint::V ? VA : joint == Joint::X ? ACX : BCY; }

/// What the hand pushes with, and what each pin bears (in the order of `pins`).
struct Balance {
  Point hand;
  std::array<Point, 5> pins;
};

class FreeLinks {
 public:
  FreeLinks(const CopyingLinkage& linkage, const Pose& pose, const Point& pen_force)
      : linkage_(linkage), pose_(pose), pen_force_(pen_force) {
    if (linkage.pole_joint() == Joint::V)
      pins = {{{Joint::A, VA, ACX},
               {Joint::B, VB, BCY},
               {Joint::C, ACX, BCY},
               {Joint::V, VB, ground},
               {Joint::V, VA, ground}}};
    else
      pins = {{{Joint::A, VA, ACX},
               {Joint::B, VB, BCY},
               {Joint::C, ACX, BCY},
               {Joint::V, VB, VA},
               {Joint::X, ACX, ground}}};
  }

  /// `moments`: on `link` of each pin, N mm; on `other` the opposite.
  Balance solve(const std::array<double, 5>& moments) const {
    Eigen::Matrix<double, 12, 12> system = Eigen::Matrix<double, 12, 12>::Zero();
    Eigen::Matrix<double, 12, 1> right = Eigen::Matrix<double, 12, 1>::Zero();
    const auto act = [&](int link, Joint joint, int column, double sign) {
      if (link == ground) return;
      system(3 * link, column) += sign;
      system(3 * link + 1, column + 1) += sign;
      system(3 * link + 2, column) -= sign * pose_[joint].y();
      system(3 * link + 2, column + 1) += sign * pose_[joint].x();
    };
    for (int i = 0; i < 5; ++i) {
      const PinOf& pin = pins[static_cast<std::size_t>(i)];
      act(pin.link, pin.joint, 2 * i, 1);
      act(pin.other, pin.joint, 2 * i, -1);
      right[3 * pin.link + 2] -= moments[static_cast<std::size_t>(i)];
      if (pin.other != ground) right[3 * pin.other + 2] += moments[static_cast<std::size_t>(i)];
    }
    act(link_with(linkage_.tracer_joint()), linkage_.tracer_joint(), 10, 1);
    const int pen = link_with(linkage_.pen_joint());
    const Point at = pose_[linkage_.pen_joint()];
    right[3 * pen] -= pen_force_.x();
    right[3 * pen + 1] -= pen_force_.y();
    right[3 * pen + 2] -= cross(at, pen_force_);
    const Eigen::Matrix<double, 12, 1> found = system.fullPivLu().solve(right);
    Balance balance{found.segment<2>(10), {}};
    for (int i = 0; i < 5; ++i) balance.pins[static_cast<std::size_t>(i)] = found.segment<2>(2 * i);
    return balance;
  }

  std::array<PinOf, 5> pins;

 private:
  const CopyingLinkage& linkage_;
  const Pose& pose_;
  Point pen_force_;
};

}  // namespace kempe::free_links
