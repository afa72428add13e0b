// Friction against the balance of every link, with moments in its pins, solved until the forces no longer change.
#include "synthesis/loads/friction.hpp"

#include <gtest/gtest.h>

#include "tests/samples.hpp"
#include "tests/synthesis/loads/free_links.hpp"

namespace kempe {
namespace {

using namespace free_links;

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
    const double mu = 1e-4;
    PinFriction friction{mu, 4};
    friction.radius = {4, 1.5, 2, 5, 3, 100};  // no pin turns at Y
    const Joint pole = linkage.pole_joint();
    const std::array<Joint, 5> joints{Joint::A, Joint::B, Joint::C, Joint::V, pole};
    std::array<double, 5> moments{};
    Balance balance = links.solve(moments);
    for (int round = 0; round < 3; ++round) {
      for (std::size_t j = 0; j < 5; ++j) {
        const double against = turns[static_cast<std::size_t>(links.pins[j].link)] -
                               turns[static_cast<std::size_t>(links.pins[j].other)];
        moments[j] = -std::copysign(mu * friction.at(joints[j]) * balance.pins[j].norm(), against);
      }
      balance = links.solve(moments);
    }
    const double more = balance.hand.dot(velocity) + drag.dot(pen_speed);
    EXPECT_NEAR(friction_loss(linkage, pose, drag, velocity, friction), more, 0.02 * more);
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
