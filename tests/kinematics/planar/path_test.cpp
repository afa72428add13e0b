// The general solver on the sources' plagiograph and on four-bars, against circle intersections.
#include "kinematics/planar/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::four_bar;
using test::meet;
using test::Random;

/// The report's plagiograph as bodies: OA = 5, OB = AC = 3.5, AX = 2.5, BC = 5, BY = 7, rotation 90 degrees.
struct Plagiograph {
  PlanarLinkage linkage;
  BodyPoint A, B, C, X, Y;

  Plagiograph() {
    const int OA = linkage.add_body("OA"), OB = linkage.add_body("OB"), ACX = linkage.add_body("ACX"),
              BCY = linkage.add_body("BCY");
    A = {OA, Point(5, 0)};
    B = {OB, Point(3.5, 0)};
    C = {ACX, Point(3.5, 0)};
    X = {ACX, Point(0, -2.5)};
    Y = {BCY, Point(0, 7)};
    linkage.add(Revolute{{0, Point(0, 0)}, {OA, Point(0, 0)}}, "O");
    linkage.add(Revolute{{0, Point(0, 0)}, {OB, Point(0, 0)}}, "O");
    linkage.add(Revolute{A, {ACX, Point(0, 0)}}, "A");
    linkage.add(Revolute{B, {BCY, Point(0, 0)}}, "B");
    linkage.add(Revolute{C, {BCY, Point(5, 0)}}, "C");
    linkage.drive_point(X, "X");
  }

  /// The report's position for X = (7, 1), with the places moved a little.
  static PlanarPosition rough_position() {
    const double a = std::atan2(1.85, 4.65), b = std::atan2(3.3, 1.2);
    return {
        {}, {Point(0.1, 0), a + 0.05}, {Point(0, 0.1), b - 0.05}, {Point(4.6, 1.8), b}, {Point(1.2, 3.3), a}};
  }
};

TEST(PlanarPath, ClosesThePublishedPlagiograph) {
  const Plagiograph p;
  EXPECT_EQ(p.linkage.fault(), "");
  const auto closed = solve_from(p.linkage, Plagiograph::rough_position(), {7, 1});
  ASSERT_TRUE(closed);
  EXPECT_LT(closed->closure_error, 1e-13 * p.linkage.size());
  const auto expect_at = [&](const BodyPoint& point, double x, double y) {
    EXPECT_LT((place(closed->position, point) - Point(x, y)).norm(), 1e-7);
  };
  expect_at(p.A, 4.64714054, 1.8450162);
  expect_at(p.C, 5.83016322, 5.13901944);
  expect_at(p.B, 1.18302268, 3.29400324);
  expect_at(p.Y, -1.4, 9.8);
}

TEST(PlanarPath, CopiesInCoarseStepsWithoutChangingItsAssembly) {
  const Plagiograph p;
  auto path = PlanarPath::from(p.linkage, Plagiograph::rough_position(), {7, 1});
  ASSERT_TRUE(path);
  const int orientation = path->orientation();
  for (int i = 0; i <= 360; ++i) {
    const double bearing = radians(45.0 * i), radius = i % 2 == 0 ? 5.7 : 7.4;
    const Complex tracer = std::polar(radius, bearing);
    ASSERT_TRUE(path->advance({tracer.real(), tracer.imag()})) << i;
    const Complex pen = Complex(0, 1.4) * tracer;
    EXPECT_LT((path->at(p.Y) - as_point(pen)).norm(), 1e-12) << i;
    EXPECT_EQ(path->orientation(), orientation);
    EXPECT_LT(path->residual(), 1e-13 * p.linkage.size());
  }
}

TEST(PlanarPath, StopsAtTheReachAndAtTheChangePoint) {
  const Plagiograph p;
  auto outward = PlanarPath::from(p.linkage, Plagiograph::rough_position(), {7, 0});
  ASSERT_TRUE(outward);
  const auto beyond = outward->advance({8, 0});
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().end, PathEnd::dead_point);
  EXPECT_NEAR(outward->at(p.X).norm(), 7.5, 1e-12);
  EXPECT_NEAR(outward->at(p.Y).norm(), 10.5, 1e-7);

  auto inward = PlanarPath::from(p.linkage, Plagiograph::rough_position(), {7, 0});
  const auto within = inward->advance({3, 0});  // the report's "bizarre configurations"
  ASSERT_FALSE(within);
  EXPECT_EQ(within.error().end, PathEnd::change_point);
  EXPECT_NEAR(inward->at(p.X).norm(), std::sqrt(5 * 5 + 2.5 * 2.5), 1e-6);
}

PlanarPosition four_bar_position(double d, double a, double b, double c, double crank, int side) {
  const Point B(a * std::cos(crank), a * std::sin(crank)), D(d, 0), C = meet(B, b, D, c, side);
  return {{},
          {Point(0, 0), crank},
          {B, std::atan2(C.y() - B.y(), C.x() - B.x())},
          {D, std::atan2(C.y() - D.y(), C.x() - D.x())}};
}

TEST(PlanarPath, FollowsRandomCrankRockersAroundInCoarseSteps) {
  Random random(2);
  const auto uniform = [&](double lower, double upper) { return random.uniform(lower, upper); };
  int tried = 0;
  while (tried < 300) {
    const double a = uniform(0.2, 2), b = uniform(0.5, 5), c = uniform(0.5, 5), d = uniform(0.5, 5);
    const double nearest = std::abs(d - a), farthest = d + a;  // what the coupler and rocker must span
    if (nearest < std::abs(b - c) + 1e-3 || farthest > b + c - 1e-3) continue;
    ++tried;
    const int side = tried % 2 ? 1 : -1;
    auto path = PlanarPath::from(four_bar(d, a, b, c), four_bar_position(d, a, b, c, 0.3, side), {0.3});
    ASSERT_TRUE(path);
    for (int i = 1; i <= 16; ++i) {
      const double crank = 0.3 + i * radians(137);
      ASSERT_TRUE(path->advance({crank}));
      const PlanarPosition expected = four_bar_position(d, a, b, c, crank, side);
      EXPECT_LT((path->at({2, Point(b, 0)}) - place(expected, {2, Point(b, 0)})).norm(), 1e-10);
    }
  }
}

/// A bar on equal cranks, which it keeps parallel: one equation too many for each crank beyond the second.
struct ParallelCranks {
  PlanarLinkage linkage;
  int bar = 0;

  ParallelCranks(const std::vector<Point>& feet, double length, int driven) {
    std::vector<int> cranks;
    for (std::size_t i = 0; i < feet.size(); ++i) cranks.push_back(linkage.add_body("crank"));
    bar = linkage.add_body("bar");
    for (std::size_t i = 0; i < feet.size(); ++i) {
      linkage.add(Revolute{{0, feet[i]}, {cranks[i], Point(0, 0)}}, "foot");
      linkage.add(Revolute{{cranks[i], Point(length, 0)}, {bar, feet[i]}}, "head");
    }
    linkage.drive(RelativeAngle{cranks[static_cast<std::size_t>(driven)], 0, 0}, "crank");
  }

  static PlanarPosition position(const std::vector<Point>& feet, double length, double angle) {
    PlanarPosition result(1);
    for (const Point& foot : feet) result.push_back({foot, angle});
    result.push_back({length * Point(std::cos(angle), std::sin(angle)), 0});
    return result;
  }
};

// Rows that are independent at the start need not be so all the way: others are then solved for.
TEST(PlanarPath, CranksBeyondTheSecondStopAParallelogramNowhere) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const int count = 3 + i % 3;
    std::vector<Point> feet{{0, 0}, {random.uniform(1, 3), 0}};
    while (static_cast<int>(feet.size()) < count)
      feet.emplace_back(random.uniform(-3, 3), random.uniform(0.5, 3) * (i % 2 ? 1 : -1));
    const double length = random.uniform(0.3, 2), start = random.uniform(-3, 3);
    const ParallelCranks cranks(feet, length, i % count);
    auto path = PlanarPath::from(cranks.linkage, ParallelCranks::position(feet, length, start), {start});
    ASSERT_TRUE(path);
    for (int step = 1; step <= 12; ++step) {  // twice around: with feet in no line there is no change point
      const double angle = start + step * pi / 3;
      const auto moved = path->advance({angle});
      ASSERT_TRUE(moved.has_value()) << name(moved.error().end) << " at " << moved.error().values[0];
      EXPECT_LT(
          (path->at({cranks.bar, Point(0, 0)}) - length * Point(std::cos(angle), std::sin(angle))).norm(),
          1e-10);
      EXPECT_LT(std::abs(path->angle(cranks.bar)), 1e-10);
    }
  }
}

TEST(PlanarPath, CranksWithFeetInALineHaveTheirChangePointWhereAllLieInIt) {
  Random random(8);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const std::vector<Point> feet{{0, 0}, {2, 0}, {random.uniform(-3, -0.5), 0}};
    const double length = random.uniform(0.3, 1.7), start = random.uniform(0.2, 2.9);
    const ParallelCranks cranks(feet, length, i % 3);
    auto path = PlanarPath::from(cranks.linkage, ParallelCranks::position(feet, length, start), {start});
    ASSERT_TRUE(path);
    const auto stopped = path->advance({i % 2 ? start + 2 * pi : start - 2 * pi});
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().end, PathEnd::change_point);
    EXPECT_NEAR(stopped.error().values[0], i % 2 ? pi : 0, 1e-6);
  }
}

TEST(PlanarPath, FindsTheDeadPointOfARockerWhereTheTriangleSaysIt) {
  Random random(3);
  const auto uniform = [&](double lower, double upper) { return random.uniform(lower, upper); };
  int tried = 0;
  while (tried < 200) {
    const double a = uniform(0.5, 3), b = uniform(0.5, 3), c = uniform(0.5, 3), d = uniform(0.5, 3);
    if (a + d < b + c + 1e-2 || std::abs(a - d) > b + c - 1e-2 || std::abs(a - d) < std::abs(b - c) + 1e-2)
      continue;
    ++tried;
    const double limit =
        std::acos((a * a + d * d - (b + c) * (b + c)) / (2 * a * d));  // coupler and rocker in line
    const double start = 0.5 * limit;
    auto path = PlanarPath::from(four_bar(d, a, b, c), four_bar_position(d, a, b, c, start, 1), {start});
    ASSERT_TRUE(path);
    const auto moved = path->advance({pi});
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error().end, PathEnd::dead_point);
    EXPECT_NEAR(path->values()[0], limit, 1e-12);
  }
}

TEST(PlanarPath, SaysWhyItCannotStart) {
  const PlanarLinkage bars = four_bar(2, 1, 2, 2);
  const auto nothing = PlanarPath::from(bars.undriven(), four_bar_position(2, 1, 2, 2, 0.3, 1), {});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().why, NoPath::freedom_left);
  EXPECT_EQ(nothing.error().freedoms, 1);

  PlanarLinkage twice = bars;
  twice.drive(RelativeAngle{3, 0, 0}, "rocker");
  const PlanarPosition position = four_bar_position(2, 1, 2, 2, 0.3, 1);
  const auto both = PlanarPath::from(twice, position, {0.3, position[3].angle});
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().why, NoPath::drivers_dependent);

  const auto open = PlanarPath::from(four_bar(9, 1, 2, 2), position, {0.3});
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().why, NoPath::does_not_assemble);
  EXPECT_GT(open.error().assembly_mode.closure_error, 1);
}

}  // namespace
}  // namespace kempe
