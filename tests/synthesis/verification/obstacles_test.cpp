#include "synthesis/verification/obstacles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

using test::uniform;

Point place(std::mt19937_64& random, double size) {
  const double x = uniform(random, -size, size), y = uniform(random, -size, size);
  return {x, y};
}

CopyingLinkage linkage_about(std::mt19937_64& random, double far) {
  for (;;) {
    const double scale = std::exp(uniform(random, -1.5, 1.5)), turn = uniform(random, -pi, pi);
    const auto grounding = all_groundings[static_cast<std::size_t>(random() % 3)];
    const double VA = uniform(random, 30, 200), VB = uniform(random, 30, 200);
    const Point pole = place(random, far);
    const auto made = CopyingLinkage::make(std::polar(scale, turn), grounding, VA, VB,
                                           static_cast<int>(random() % 2), pole);
    if (made && made->assembly_mode().openings.width() > radians(40)) return *made;
  }
}

/// A star about a point: its outline may be anything but convex.
Polygon star(std::mt19937_64& random, const Point& at, double size) {
  const int corners = 3 + static_cast<int>(random() % 6);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double radius = uniform(random, 0.2, 1) * size;
    polygon.outer.push_back(at +
                            radius * Point(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)));
  }
  return polygon;
}

/// How often the ring goes around the point, by the angle that it is seen to turn through.
bool goes_around(const Ring& ring, const Point& point) {
  double turned = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    turned += std::arg(as_complex(ring[(i + 1) % ring.size()] - point) / as_complex(ring[i] - point));
  return std::abs(turned) > pi;
}

/// The distance of an axis from a ring by many points of both; 0 if one of the axis lies inside.
double sampled(const Point& from, const Point& to, const Ring& ring) {
  constexpr int count = 120;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= count; ++i) {
    const Point here = from + (to - from) * (static_cast<double>(i) / count);
    if (goes_around(ring, here)) return 0;
    for (std::size_t j = 0; j < ring.size(); ++j)
      for (int n = 0; n < count; ++n) {
        const Point there =
            ring[j] + (ring[(j + 1) % ring.size()] - ring[j]) * (static_cast<double>(n) / count);
        least = std::min(least, (here - there).norm());
      }
  }
  return least;
}

Pose seen_from(const Point& pole, Pose pose) {
  for (const Joint joint : all_joints) pose[joint] -= pole;
  return pose;
}

TEST(ObstacleWatch, GapIsThatOfManyPoints) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 100; ++i) {
    const CopyingLinkage linkage = linkage_about(random, 300);
    const OpeningInterval& openings = linkage.assembly_mode().openings;
    const double opening = uniform(random, openings.lower, openings.upper);
    const Pose pose = linkage.pose_at(opening, uniform(random, -pi, pi));
    VerificationTask task;
    task.mechanism.pole_position = linkage.pole();
    const Point near = linkage.pole() + place(random, 300);
    const double size = uniform(random, 5, 80);
    task.obstacles = {{.shape = star(random, near, size), .lowest_layer = 1, .highest_layer = 2}};
    double axes = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : {std::pair{pose.V, pose.A},
                                   {pose.V, pose.B},
                                   {pose.C, pose.A},
                                   {pose.A, pose.X},
                                   {pose.C, pose.B},
                                   {pose.B, pose.Y}})
      axes = std::min(axes, sampled(from, to, task.obstacles.front().shape.outer));
    const Pose from_pole = seen_from(linkage.pole(), pose);
    const auto found = ObstacleWatch(linkage, task).nearest(from_pole, 1e9);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->obstacle, "obstacle 1");
    const double exact = found->gap + 0.5 * task.style.width;
    EXPECT_LE(exact, axes + 1e-9);
    EXPECT_GE(exact, std::max(0.0, axes - 8));  // half a step of both samples
    EXPECT_FALSE(ObstacleWatch(linkage, task).nearest(from_pole, found->gap - 1e-6));
  }
}

TEST(ObstacleWatch, LooksOnlyWhereALayerIsShared) {
  const CopyingLinkage linkage = *CopyingLinkage::make(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3);
  const Pose pose = linkage.pose_at(radians(130), 0);
  VerificationTask task;
  const Point on_VA = 0.5 * (pose.V + pose.A);
  std::mt19937_64 random(1);
  task.obstacles = {{.shape = star(random, on_VA, 1), .lowest_layer = 1, .highest_layer = 1}};
  EXPECT_EQ(ObstacleWatch(linkage, task).nearest(pose, 0)->part, "link VA");
  for (const int layer : {3, 4, 8}) {
    task.obstacles[0].lowest_layer = task.obstacles[0].highest_layer = layer;
    EXPECT_FALSE(ObstacleWatch(linkage, task).nearest(pose, 1e9));
  }
}

Region sector(const CopyingLinkage& linkage, const OpeningInterval& openings, double bearing) {
  const auto radii = linkage.radii_over(openings);
  Ring ring;
  for (const double share : {0.3, 0.7})
    for (int i = 0; i <= 6; ++i) {
      const double turn = bearing + 0.05 * (share < 0.5 ? i : 6 - i);
      ring.push_back(linkage.pole() + (radii.lower + share * (radii.upper - radii.lower)) *
                                          Point(std::cos(turn), std::sin(turn)));
    }
  std::reverse(ring.begin(), ring.end());
  return {{Polygon{ring, {}}}};
}

bool sees_obstacle(const VerificationTask& task) {
  const Verification found = verify(task, {.outline_samples = 60, .hatch_lines = 1});
  EXPECT_GT(found.samples, 10U) << found.failure;
  return std::any_of(found.broken.begin(), found.broken.end(),
                     [](const BrokenLimit& one) { return one.limit == "obstacles"; });
}

TEST(ObstacleWatch, FindsWhatStandsInTheWayWhereverThePoleStands) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage linkage = linkage_about(random, i % 2 ? 1e5 : 0);
    VerificationTask task;
    const OpeningInterval openings =
        shrink(linkage.assembly_mode().openings, 0.2 * linkage.assembly_mode().openings.width());
    task.region = sector(linkage, openings, uniform(random, -3, 3));
    task.mechanism = {linkage.lengths(),
                      linkage.assembly_mode().sides,
                      linkage.pole_joint(),
                      linkage.tracer_joint(),
                      linkage.pen_joint(),
                      linkage.pole(),
                      openings};
    task.k = linkage.k();
    task.limits = {.clearance = 0, .transmission = 0};
    task.obstacles = {{.shape = star(random, linkage.pole() + Point(1e4, 0), 50), .highest_layer = 8}};
    EXPECT_FALSE(sees_obstacle(task));
    const Ring& corners = task.region.polygons.front().outer;
    const Point& tracer = corners[random() % corners.size()];
    const Pose pose = *linkage.pose_with_tracer_at(tracer);
    task.obstacles = {{.shape = star(random, 0.5 * (pose.V + pose.A), 2), .highest_layer = 8}};
    EXPECT_TRUE(sees_obstacle(task));
    task.obstacles = {{.shape = star(random, 0.5 * (pose.B + pose.Y), 2), .highest_layer = 8}};
    EXPECT_TRUE(sees_obstacle(task));
  }
}

}  // namespace
}  // namespace kempe
