// Instant centres against hand constructions and against velocities.
#include "kinematics/planar/instant_centres.hpp"

#include <gtest/gtest.h>

#include "kinematics/planar/path.hpp"
#include "kinematics/planar/rates.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::Random;
using Kind = InstantCentre::Kind;
using Source = InstantCentre::Source;

const InstantCentre& centre(const std::vector<InstantCentre>& all, int a, int b) {
  for (const InstantCentre& each : all)
    if (each.first == std::min(a, b) && each.second == std::max(a, b)) return each;
  throw std::logic_error("no such pair");
}

/// Where two lines meet, each through two points.
Point crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c;
  return a + u * (cross(c - a, v) / cross(u, v));
}

TEST(InstantCentres, OfAFourBarAreWhereItsSidesMeet) {
  const PlanarLinkage linkage = test::four_bar(3, 1, 2.5, 2);
  const Point A(0, 0), D(3, 0), B(std::cos(0.9), std::sin(0.9)), C = test::meet(B, 2.5, D, 2, 1);
  auto path = PlanarPath::from(
      linkage,
      {{}, {A, 0.9}, {B, std::atan2((C - B).y(), (C - B).x())}, {D, std::atan2((C - D).y(), (C - D).x())}},
      {0.9});
  ASSERT_TRUE(path);
  const auto all = instant_centres(linkage, path->position(), path->velocity({1}));
  ASSERT_EQ(all.size(), 6u);
  EXPECT_LT((centre(all, 0, 2).at - crossing(A, B, D, C)).norm(), 1e-12);
  EXPECT_LT((centre(all, 1, 3).at - crossing(A, D, B, C)).norm(), 1e-12);
  EXPECT_EQ(centre(all, 0, 2).source, Source::lines);
  EXPECT_EQ(centre(all, 0, 1).source, Source::primary);
  for (const InstantCentre& each : all) EXPECT_LT(each.velocity_error, 1e-12);
}

TEST(InstantCentres, OfTheFiveLinkPlagiographOppositeSidesLieAtInfinity) {
  PlanarLinkage linkage;
  const int OA = linkage.add_body("OA"), OB = linkage.add_body("OB"), ACX = linkage.add_body("ACX"),
            BCY = linkage.add_body("BCY");
  linkage.add(Revolute{{0, Point(0, 0)}, {OA, Point(0, 0)}}, "O");
  linkage.add(Revolute{{0, Point(0, 0)}, {OB, Point(0, 0)}}, "O");
  linkage.add(Revolute{{OA, Point(5, 0)}, {ACX, Point(0, 0)}}, "A");
  linkage.add(Revolute{{OB, Point(3.5, 0)}, {BCY, Point(0, 0)}}, "B");
  linkage.add(Revolute{{ACX, Point(3.5, 0)}, {BCY, Point(5, 0)}}, "C");
  const BodyPoint X{ACX, Point(0, -2.5)};
  linkage.drive_point(X, "X");
  const double a = 0.378, b = 1.226;
  auto path = PlanarPath::from(
      linkage, {{}, {Point(0, 0), a}, {Point(0, 0), b}, {Point(4.6, 1.8), b}, {Point(1.2, 3.3), a}}, {7, 1});
  ASSERT_TRUE(path);
  for (const double way : {0.0, 0.7, 2.1, 4.4}) {  // any direction of the tracer's motion
    const std::vector<double> speeds{std::cos(way), std::sin(way)};
    const auto all = instant_centres(linkage, path->position(), path->velocity(speeds));
    ASSERT_EQ(all.size(), 10u);
    EXPECT_EQ(centre(all, OA, BCY).kind, Kind::at_infinity);
    EXPECT_EQ(centre(all, OB, ACX).kind, Kind::at_infinity);
    // OA and BCY translate against each other along a circle of OB: the centre lies in OB's direction.
    EXPECT_NEAR(std::abs(cross(centre(all, OA, BCY).direction,
                               Point(std::cos(path->angle(OB)), std::sin(path->angle(OB))))),
                0, 1e-12);
    const InstantCentre tracer_link = centre(all, 0, ACX);
    ASSERT_EQ(tracer_link.kind, Kind::finite);
    // The tracer moves square to the line to its link's centre, and the centre lies on the line of OA.
    EXPECT_NEAR((path->at(X) - tracer_link.at).dot(Point(speeds[0], speeds[1])), 0, 1e-9);
    EXPECT_NEAR(cross(tracer_link.at, path->at({OA, Point(5, 0)})), 0, 1e-9);
    for (const InstantCentre& each : all) EXPECT_LT(each.velocity_error, 1e-10);
  }
}

TEST(InstantCentres, OfASliderCrankWithItsPistonAsALink) {
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank"), rod = linkage.add_body("rod"),
            piston = linkage.add_body("piston");
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}}, "O");
  linkage.add(Revolute{{crank, Point(3, 0)}, {rod, Point(0, 0)}}, "A");
  linkage.add(Revolute{{rod, Point(10, 0)}, {piston, Point(0, 0)}}, "B");
  linkage.add(Coordinate{{piston, Point(0, 0)}, {0, Point(0, 0)}, Point(0, 1), 0}, "piston");
  linkage.add(RelativeAngle{piston, 0, 0}, "piston does not turn");
  linkage.drive(RelativeAngle{crank, 0, 0}, "crank");
  const double t = 0.8, lean = std::asin(-3 * std::sin(t) / 10);
  const Point A(3 * std::cos(t), 3 * std::sin(t)), B(A.x() + 10 * std::cos(lean), 0);
  auto path = PlanarPath::from(linkage, {{}, {Point(0, 0), t}, {A, lean}, {B, 0}}, {t});
  ASSERT_TRUE(path);
  const auto all = instant_centres(linkage, path->position(), path->velocity({1}));
  EXPECT_EQ(centre(all, 0, piston).kind, Kind::at_infinity);
  EXPECT_NEAR(std::abs(centre(all, 0, piston).direction.y()), 1, 1e-15);
  EXPECT_EQ(centre(all, 0, piston).source, Source::primary);
  const Point rod_centre(B.x(), B.x() * std::tan(t));  // the crank's line over the normal of the guide
  EXPECT_LT((centre(all, 0, rod).at - rod_centre).norm(), 1e-10);
  const Point crank_piston = crossing(A, B, Point(0, 0), Point(0, 1));
  EXPECT_LT((centre(all, crank, piston).at - crank_piston).norm(), 1e-10);
  EXPECT_NEAR(velocity_of(path->position(), path->velocity({1}), {piston, Point(0, 0)}).x(),
              -crank_piston.y(), 1e-12);
}

TEST(InstantCentres, PitchPointsOfWheelsAndRacks) {
  PlanarLinkage linkage;
  const int first = linkage.add_body("first"), second = linkage.add_body("second"),
            rack = linkage.add_body("rack");
  linkage.add(Revolute{{0, Point(0, 0)}, {first, Point(0, 0)}}, "O");
  linkage.add(Revolute{{0, Point(6, 0)}, {second, Point(0, 0)}}, "D");
  linkage.add(GearPair{first, second, 0, 4, 2, 0}, "gears");
  linkage.add(Coordinate{{rack, Point(0, 0)}, {0, Point(0, 4)}, Point(0, 1), 0}, "rack");
  linkage.add(RelativeAngle{rack, 0, 0}, "rack does not turn");
  linkage.add(RackAndPinion{{first, Point(0, 0)}, {rack, Point(0, 0)}, Point(1, 0), -4, 0}, "rack");
  linkage.drive(RelativeAngle{first, 0, 0}, "first");
  auto path = PlanarPath::from(linkage, {{}, {Point(0, 0), 0.1}, {Point(6, 0), 0}, {Point(0, 4), 0}}, {0.1});
  ASSERT_TRUE(path);
  const auto all = instant_centres(linkage, path->position(), path->velocity({1}));
  EXPECT_LT((centre(all, first, second).at - Point(4, 0)).norm(), 1e-12);
  EXPECT_LT((centre(all, first, rack).at - Point(0, 4)).norm(), 1e-12);
  for (const InstantCentre& each : all) EXPECT_LT(each.velocity_error, 1e-12);
  EXPECT_NEAR(path->velocity({1})[3 * rack - 3], -4, 1e-12);  // the rack lies above a wheel that turns left
}

TEST(InstantCentres, OfRandomSixBarsAgreeWithVelocities) {
  Random random(31);
  int tried = 0;
  while (tried < 300) {
    PlanarLinkage linkage = test::four_bar(2, random.uniform(0.3, 1), 2, 2);
    const int first = linkage.add_body("EG"), second = linkage.add_body("FG");
    linkage.add(Revolute{{2, random.point(2)}, {first, Point(0, 0)}}, "E");
    linkage.add(Revolute{{tried % 2 ? 3 : 0, random.point(3)}, {second, Point(0, 0)}}, "F");
    linkage.add(Revolute{{first, Point(2, 0)}, {second, Point(1.7, 0)}}, "G");
    const double crank = random.uniform(-pi, pi);
    auto path = PlanarPath::from(linkage, test::random_position(random, 6, 2), {crank});
    if (!path) continue;
    ++tried;
    const auto all = instant_centres(linkage, path->position(), path->velocity({1}));
    ASSERT_EQ(all.size(), 15u);
    for (const InstantCentre& each : all) {
      EXPECT_NE(each.source, Source::none);
      EXPECT_NE(each.source, Source::rates);  // one freedom: joints and lines suffice
      EXPECT_LT(each.velocity_error, 1e-7);
      if (!each.lines || each.kind != Kind::finite) continue;
      const auto centre_of = [&](int a, int b) {
        return *std::find_if(all.begin(), all.end(), [&](const InstantCentre& other) {
          return other.first == std::min(a, b) && other.second == std::max(a, b);
        });
      };
      for (const CentreLine& line : *each.lines) {  // each passes through the two centres that gave it
        const InstantCentre a = centre_of(each.first, *line.via), b = centre_of(*line.via, each.second);
        for (const InstantCentre& other : {a, b}) {
          if (other.kind != Kind::finite) continue;
          const Point way = other.at - each.at;
          EXPECT_LT(std::abs(way.x() * line.direction.y() - way.y() * line.direction.x()),
                    1e-6 * (1 + way.norm()));
        }
      }
    }
  }
}

}  // namespace
}  // namespace kempe
