// Poses by Burmester's theory: every circle by its points, roots against those of a known four-bar, motions by the general solver.
#include "synthesis/paths/pose_guidance.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

CouplerFourBar known() {
  CouplerFourBar bar;
  bar.crank_pivot = {1, 2};
  bar.rocker_pivot = {61, -5};
  bar.crank = 20;
  bar.coupler = 55;
  bar.rocker = 40;
  bar.coupler_point = {25, 30};
  bar.branch = FourBarBranch::second;
  return bar;
}

/// Poses of a body on its coupler, the body's direction 0.4 rad from the coupler's.
PoseTask task_of_known(int count) {
  PoseTask task;
  task.longest = 300;
  for (int k = 0; k < count; ++k) {
    const auto place = known().at(0.3 + 0.5 * k);
    task.poses.push_back({place->P, std::arg(as_complex(place->B - place->A)) + 0.4});
  }
  return task;
}

Point placed(const BodyPlacement& pose, const Point& w) {
  return pose.at + Point(std::cos(pose.angle) * w.x() - std::sin(pose.angle) * w.y(),
                         std::sin(pose.angle) * w.x() + std::cos(pose.angle) * w.y());
}

void expect_circle(const Dyad& dyad, const std::vector<BodyPlacement>& poses) {
  for (const BodyPlacement& pose : poses)
    EXPECT_NEAR((placed(pose, dyad.circle) - dyad.centre).norm(), dyad.length, 1e-9 * (1 + dyad.length));
}

/// The answer's body, carried by the coupler through the general solver, lies in every pose.
void expect_poses(const PoseTask& task, const PoseAnswer& answer) {
  const CouplerFourBar& bar = answer.path.linkage;
  const auto motion =
      certified_path(bar, CognateDriver::crank, answer.path.crank_angles, answer.path.crank_angles.front());
  ASSERT_TRUE(motion);
  const double body = task.poses[0].angle - motion->coupler_angle[0];
  for (std::size_t k = 0; k < task.poses.size(); ++k) {
    EXPECT_LT((motion->reached[k] - task.poses[k].at).norm(), 1e-9 * bar.longest());
    EXPECT_NEAR(std::remainder(motion->coupler_angle[k] + body - task.poses[k].angle, 2 * pi), 0, 1e-9);
    if (k == 0) continue;
    EXPECT_GT((answer.path.crank_angles[k] - answer.path.crank_angles[k - 1]) *
                  (answer.path.crank_angles.back() - answer.path.crank_angles.front()),
              0);
  }
  EXPECT_LE(bar.longest(), task.longest);
  EXPECT_GE(answer.path.transmission_min, task.transmission);
}

TEST(PoseGuidance, FivePosesOfAFourBarGiveItsTwoDyadsAmongAll) {
  const PoseTask task = task_of_known(5);
  const std::vector<Dyad> dyads = burmester_dyads(task.poses);
  ASSERT_EQ(dyads.size(), 4u);  // real roots come in pairs
  for (const Dyad& dyad : dyads) expect_circle(dyad, task.poses);
  for (const auto& [centre, length] : {std::pair(Point(1, 2), 20.0), std::pair(Point(61, -5), 40.0)})
    EXPECT_TRUE(std::any_of(dyads.begin(), dyads.end(), [&, c = centre, l = length](const Dyad& dyad) {
      return (dyad.centre - c).norm() < 1e-7 && std::abs(dyad.length - l) < 1e-7;
    }));
  const auto search = guide_poses(task);
  ASSERT_TRUE(search) << search.error();
  EXPECT_EQ(search->linkages, 12u);
  for (const PoseAnswer& answer : search->answers) expect_poses(task, answer);
}

/// Newton's method on the circles from scattered places, which knows no conic, finds no dyad that the resultant has missed.
TEST(PoseGuidance, FivePosesLeaveNoDyadOut) {
  const std::vector<std::vector<BodyPlacement>> tasks{
      task_of_known(5).poses,
      {{{0, 0}, 0}, {{20, 16}, 0.17}, {{42, 26}, 0.38}, {{66, 28}, 0.63}, {{88, 20}, 0.91}},
      {{{0, 0}, 1}, {{12, 25}, 0.8}, {{32, 42}, 0.5}, {{58, 50}, 0.3}, {{85, 48}, 0}}};
  for (const auto& poses : tasks) {
    const std::vector<Dyad> dyads = burmester_dyads(poses);
    for (int start = 0; start < 400; ++start) {
      Eigen::Vector4d x(std::fmod(start * 61.803, 400) - 200, std::fmod(start * 41.421, 400) - 200,
                        std::fmod(start * 73.205, 400) - 200, std::fmod(start * 23.607, 400) - 200);
      const auto gaps = [&](const Eigen::Vector4d& at) {
        Eigen::Vector4d value;
        const double first = (placed(poses[0], at.head<2>()) - at.tail<2>()).squaredNorm();
        for (int k = 1; k < 5; ++k)
          value[k - 1] =
              (placed(poses[static_cast<std::size_t>(k)], at.head<2>()) - at.tail<2>()).squaredNorm() - first;
        return value;
      };
      for (int round = 0; round < 60; ++round) {
        Eigen::Matrix4d slope;  // quadratic functions: central differences are exact
        for (int k = 0; k < 4; ++k)
          slope.col(k) = (gaps(x + Eigen::Vector4d::Unit(k)) - gaps(x - Eigen::Vector4d::Unit(k))) / 2;
        x -= slope.partialPivLu().solve(gaps(x));
        if (!x.allFinite() || x.norm() > 1e6) break;
      }
      if (!x.allFinite() || x.norm() > 1e4 || gaps(x).norm() > 1e-6) continue;
      EXPECT_TRUE(std::any_of(dyads.begin(), dyads.end(), [&](const Dyad& dyad) {
        return (dyad.centre - Point(x.tail<2>())).norm() + (dyad.circle - Point(x.head<2>())).norm() <
               1e-4 * (1 + x.norm());
      })) << x.transpose();
    }
  }
}

TEST(PoseGuidance, FourAndThreePosesGiveFamilies) {
  for (const int count : {4, 3}) {
    PoseTask task = task_of_known(count);
    task.transmission = radians(45);
    task.pivots_within = {{-100, -150}, {150, -150}, {150, 100}, {-100, 100}};
    const auto search = guide_poses(task);
    ASSERT_TRUE(search) << search.error();
    EXPECT_GT(search->dyads.size(), 50u);
    for (const Dyad& dyad : search->dyads) expect_circle(dyad, task.poses);
    EXPECT_EQ(search->answers.size(), 6u);
    for (const PoseAnswer& answer : search->answers) {
      expect_poses(task, answer);
      for (const Point& pivot : {answer.path.linkage.crank_pivot, answer.path.linkage.rocker_pivot}) {
        EXPECT_LE(std::abs(pivot.x() - 25), 125);
        EXPECT_LE(std::abs(pivot.y() + 25), 125);
      }
    }
  }
}

/// Where circles about three places meet, seen from them at one distance.
Point centre_of(const Point& a, const Point& b, const Point& c) {
  Eigen::Matrix2d rows;
  rows << (b - a).transpose(), (c - a).transpose();
  return rows.partialPivLu().solve(
      Eigen::Vector2d(b.squaredNorm() - a.squaredNorm(), c.squaredNorm() - a.squaredNorm()) / 2);
}

/// The least angle at B over the motion, by the law of cosines at 400 places; zero where the loop opens.
double least_angle(const Point& A0, const Point& B0, double a, double b, double c, double from, double to) {
  double least = pi;
  for (int i = 0; i <= 400; ++i) {
    const double angle = from + (to - from) * i / 400;
    const double square = (A0 + a * Point(std::cos(angle), std::sin(angle)) - B0).squaredNorm();
    const double cosine = (b * b + c * c - square) / (2 * b * c);
    if (std::abs(cosine) > 1) return 0;
    least = std::min({least, std::acos(cosine), pi - std::acos(cosine)});
  }
  return least;
}

/// The oracle: circle points scattered about those of the answer, each with its centre by two lines.
TEST(PoseGuidance, NoFourBarNearbyInTheFamilyOfThreePosesMovesBetter) {
  PoseTask task = task_of_known(3);
  task.longest = 1e4;
  const auto search = guide_poses(task, 1);
  ASSERT_TRUE(search) << search.error();
  const PathAnswer& best = search->answers.front().path;
  const CouplerFourBar& bar = best.linkage;
  const Point A = bar.crank_pivot +
                  bar.crank * Point(std::cos(best.crank_angles[0]), std::sin(best.crank_angles[0])),
              B = bar.at(best.crank_angles[0]).value().B;
  const auto in_body = [&](const Point& p) {
    return as_point(as_complex(p - task.poses[0].at) * std::polar(1.0, -task.poses[0].angle));
  };
  const auto at_pose = [&](std::size_t k, const Point& w) {
    return Point(task.poses[k].at + as_point(as_complex(w) * std::polar(1.0, task.poses[k].angle)));
  };
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto shift = [&](double root) {
      return 0.02 * (2 * std::fmod(i * std::sqrt(root), 1) - 1);  // mm
    };
    const Point wa = in_body(A) + Point(shift(2), shift(3)), wb = in_body(B) + Point(shift(5), shift(7));
    const Point A0 = centre_of(at_pose(0, wa), at_pose(1, wa), at_pose(2, wa)),
                B0 = centre_of(at_pose(0, wb), at_pose(1, wb), at_pose(2, wb));
    const auto angle_at = [&](std::size_t k, double near) {
      const double angle = std::arg(as_complex(at_pose(k, wa) - A0));
      return angle + 2 * pi * std::round((near - angle) / (2 * pi));
    };
    largest =
        std::max(largest, least_angle(A0, B0, (at_pose(0, wa) - A0).norm(), (wb - wa).norm(),
                                      (at_pose(0, wb) - B0).norm(), angle_at(0, best.crank_angles.front()),
                                      angle_at(2, best.crank_angles.back())));
  }
  EXPECT_GT(largest, best.transmission_min - 0.01);
  EXPECT_LT(largest, best.transmission_min + 1e-4);
}

TEST(PoseGuidance, PosesThatOnlyShiftAreToldToHaveNothing) {
  PoseTask task;
  task.longest = 100;
  for (int k = 0; k < 5; ++k) task.poses.push_back({{10.0 * k, 3.0 * k * k}, 0.5});
  const auto search = guide_poses(task);
  ASSERT_FALSE(search);
  EXPECT_NE(search.error().find("not a proof"), std::string::npos);
}

}  // namespace
}  // namespace kempe
