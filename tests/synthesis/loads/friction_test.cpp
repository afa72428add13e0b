// Friction against the balance of every link, with moments in its pins, solved until the forces no longer change.
#include "synthesis/loads/friction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>

#include "tests/random.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

using test::uniform;

CopyingLinkage random_linkage(std::mt19937_64& random) {
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

/// The links as an engineer draws them free: VA, VB, ACX, BCY and the ground.
enum { VA, VB, ACX, BCY, ground };
struct PinOf {
  Joint joint;
  int link, other;
};

int link_with(Joint joint) { return joint == Joint::V ? VA : joint == Joint::X ? ACX : BCY; }

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

double turn_of(const Point& from, const Point& to, const Point& from_speed, const Point& to_speed) {
  return cross(to - from, to_speed - from_speed) / (to - from).squaredNorm();
}

TEST(Friction, PinsBearWhatTheBalanceOfEveryLinkSays) {
  std::mt19937_64 random(21);
  for (int i = 0; i < test::samples(200); ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    const OpeningInterval openings = shrink(linkage.assembly_mode().openings, 0.2);
    const Pose pose =
        linkage.pose_at(openings.lower + uniform(random, 0, 1) * openings.width(), uniform(random, -pi, pi));
    const Point force(uniform(random, -5, 5), uniform(random, -5, 5));
    const Balance balance = FreeLinks(linkage, pose, force).solve({});
    const PinLoads loads = pin_loads(linkage, pose, force);
    EXPECT_LT((hand_force_against(linkage, force) - balance.hand).norm(), 1e-9 * (1 + balance.hand.norm()));
    const std::array<double, 5> found{loads.A, loads.B, loads.C, loads.V, loads.pole};
    for (std::size_t j = 0; j < 5; ++j)
      EXPECT_NEAR(found[j], balance.pins[j].norm(), 1e-8 * (1 + balance.pins[j].norm())) << j;
  }
}

TEST(Friction, TakesTheWorkThatTheHandDoesMore) {
  std::mt19937_64 random(22);
  for (int i = 0; i < test::samples(200); ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    const OpeningInterval openings = shrink(linkage.assembly_mode().openings, 0.3);
    const Pose pose =
        linkage.pose_at(openings.lower + uniform(random, 0, 1) * openings.width(), uniform(random, -pi, pi));
    const Point velocity = as_point(std::polar(1.0, uniform(random, -pi, pi)));
    const auto speeds = linkage.velocities(pose, velocity);
    ASSERT_TRUE(speeds);
    const Point pen_speed = (*speeds)[linkage.pen_joint()], drag = -3 * pen_speed / pen_speed.norm();
    const FreeLinks links(linkage, pose, drag);
    const double of_p = turn_of(pose.V, pose.A, speeds->V, speeds->A),
                 of_q = turn_of(pose.V, pose.B, speeds->V, speeds->B);
    const std::array<double, 5> turns{of_p, of_q, of_q, of_p, 0};  // of VA, VB, ACX, BCY and the ground
    const double mu = 1e-4, radius = 4;
    std::array<double, 5> moments{};
    Balance balance = links.solve(moments);
    for (int round = 0; round < 3; ++round) {
      for (std::size_t j = 0; j < 5; ++j) {
        const double against = turns[static_cast<std::size_t>(links.pins[j].link)] -
                               turns[static_cast<std::size_t>(links.pins[j].other)];
        moments[j] = -std::copysign(mu * radius * balance.pins[j].norm(), against);
      }
      balance = links.solve(moments);
    }
    const double more = balance.hand.dot(velocity) + drag.dot(pen_speed);
    EXPECT_NEAR(friction_loss(linkage, pose, drag, velocity, {mu, radius}), more, 0.02 * more);
  }
}

TEST(Friction, LocksTowardsTheChangePoints) {
  std::mt19937_64 random(23);
  for (int i = 0; i < 20; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    const double middle = linkage.assembly_mode().openings.middle();
    const PinFriction friction{0.15, 4};
    if (friction_share(linkage, middle, friction) >= 1) continue;
    const OpeningInterval free = openings_without_lock(linkage, {middle, middle}, friction);
    EXPECT_LT(free.lower, middle);
    EXPECT_GT(free.upper, middle);
    EXPECT_GT(friction_share(linkage, free.upper + radians(0.01), friction), 0.99);
    EXPECT_GT(friction_share(linkage, free.lower - radians(0.01), friction), 0.99);
  }
}

}  // namespace
}  // namespace kempe
