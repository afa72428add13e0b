// Motions: rates are exact, curves are followed and not cut, dead points are named.
#include "kinematics/planar/run.hpp"

#include <gtest/gtest.h>

#include "kinematics/planar/rates.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

/// A two-bar arm O-A-X, lengths 3 and 2, whose end X is driven.
PlanarLinkage arm() {
  PlanarLinkage linkage;
  const int upper = linkage.add_body("upper"), fore = linkage.add_body("fore");
  linkage.add(Revolute{{0, Point(0, 0)}, {upper, Point(0, 0)}}, "O");
  linkage.add(Revolute{{upper, Point(3, 0)}, {fore, Point(0, 0)}}, "A");
  linkage.drive_point({fore, Point(2, 0)}, "X");
  return linkage;
}

PlanarPosition arm_position(const Point& X) {
  const Point A = test::meet(Point(0, 0), 3, X, 2, 1);
  return {{}, {Point(0, 0), std::atan2(A.y(), A.x())}, {A, std::atan2((X - A).y(), (X - A).x())}};
}

DriveSchedule along(std::vector<PathPiece> pieces) { return {{DriverPath(std::move(pieces))}, 2.0}; }

TEST(PlanarRun, RatesAreTheDerivativesOfPositions) {
  const DriveSchedule schedule = along({PathPiece::arc(Point(2.5, 1), 1, 0.3, 4),
                                        PathPiece::cubic(PathPiece::arc(Point(2.5, 1), 1, 0.3, 4).end(),
                                                         Point(1, 1), Point(3, 0), Point(3.5, 2))});
  const auto run =
      run_motion(arm(),
                 arm_position(schedule.motions.empty() ? Point::Zero()
                                                       : std::get<DriverPath>(schedule.motions[0]).at(0).at),
                 schedule, 40000);
  ASSERT_TRUE(run);
  ASSERT_FALSE(run->stop);
  const double h = schedule.duration / 40000;
  const double corner = std::get<DriverPath>(schedule.motions[0]).ends()[0];
  for (std::size_t i = 10; i + 10 < run->frames.size(); i += 371) {
    const RunFrame& now = run->frames[i];
    if (std::abs(now.share - corner) < 0.01) continue;
    const auto difference = [&](const BodyPoint& point) {
      return Point((place(run->frames[i + 1].position, point) - place(run->frames[i - 1].position, point)) /
                   (2 * h));
    };
    const auto second = [&](const BodyPoint& point) {
      return Point((place(run->frames[i + 1].position, point) - 2 * place(now.position, point) +
                    place(run->frames[i - 1].position, point)) /
                   (h * h));
    };
    for (const BodyPoint& point :
         {BodyPoint{1, Point(3, 0)}, BodyPoint{2, Point(2, 0)}, BodyPoint{2, Point(1, 1)}}) {
      EXPECT_LT((velocity_of(now.position, now.rate, point) - difference(point)).norm(), 2e-4) << now.share;
      EXPECT_LT((acceleration_of(now.position, now.rate, now.second, point) - second(point)).norm(), 2e-2)
          << now.share;
    }
  }
}

TEST(PlanarRun, DistanceAndSlideDriversHaveExactRatesToo) {
  // A strut between the ground and a lever lengthens: cosine rule.
  PlanarLinkage linkage;
  const int lever = linkage.add_body("lever");
  linkage.add(Revolute{{0, Point(0, 0)}, {lever, Point(0, 0)}}, "O");
  linkage.drive(Distance{{0, Point(4, 0)}, {lever, Point(3, 0)}, 2}, "strut");
  const DriveSchedule schedule{{DriverRange{2, 6, {}}}, 4};
  const auto run = run_motion(linkage, {{}, {Point(0, 0), 0.5}}, schedule, 40);
  ASSERT_TRUE(run);
  ASSERT_FALSE(run->stop);
  for (const RunFrame& frame : run->frames) {
    const double s = frame.values[0], c = (25 - s * s) / 24, sine = std::sqrt(1 - c * c);
    EXPECT_NEAR(frame.position[1].angle, std::acos(c), 1e-12);
    const double rate = s / (12 * sine);  // ds/dt = 1
    EXPECT_NEAR(spin_of(frame.rate, lever), rate, 1e-11);
    EXPECT_NEAR(spin_of(frame.second, lever), (1 / 12.0 - c * rate * rate) / sine, 1e-10);
  }
}

TEST(PlanarRun, ACircleIsFollowedAndItsChordsAreNot) {
  // The circle runs 1e-5 outside the arm's inner reach of 1; its chords of 120 degrees would cross it.
  const DriveSchedule schedule = along({PathPiece::arc(Point(0, 0), 1.00001, 0, 2 * pi)});
  const auto run = run_motion(arm(), arm_position(Point(1.00001, 0)), schedule, 3);
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->stop);
  const PlanarPosition start = arm_position(Point(1.00001, 0));
  EXPECT_LT((place(run->frames.back().position, {1, Point(3, 0)}) - place(start, {1, Point(3, 0)})).norm(),
            1e-9);
}

TEST(PlanarRun, DeadPointsAreNamedByTheJointsInLine) {
  const DriveSchedule schedule = along({PathPiece::line(Point(3, 0), Point(6, 0))});
  const auto run = run_motion(arm(), arm_position(Point(3, 0)), schedule, 12);
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->stop);
  EXPECT_EQ(run->stop->end, PathEnd::dead_point);
  EXPECT_NEAR(run->stop->share, 2.0 / 3, 1e-12);
  ASSERT_FALSE(run->stop->sentences.empty());
  EXPECT_EQ(run->stop->sentences[0], "O, A and X in line (upper, fore)");
  EXPECT_EQ(run->frames.size(), 10u);  // steps 0 .. 8, then the last good position
  EXPECT_NEAR(run->frames.back().values[0], 5, 1e-11);
  EXPECT_EQ(run->frames.back().rate.size(), 0);
}

TEST(PlanarRun, APointThatRunsOffEndsTheWorkAndIsNamed) {
  // An arm that turns into the line it cuts: the cut runs off to infinity and never arrives.
  PlanarLinkage linkage;
  const int arm = linkage.add_body("arm"), cut = linkage.add_particle("cut");
  linkage.add(Revolute{{0, Point(0, 1)}, {arm, Point(0, 0)}}, "F");
  linkage.add(Coordinate{{cut, Point(0, 0)}, {arm, Point(0, 0)}, Point(0, 1), 0}, "on the arm");
  linkage.add(Coordinate{{cut, Point(0, 0)}, {0, Point(0, 0)}, Point(0, 1), 0}, "on the line");
  linkage.drive(RelativeAngle{arm, 0, 0}, "arm");
  const DriveSchedule schedule{{DriverRange{-1, 0.5, {}}}, 1};
  const auto run =
      run_motion(linkage, {{}, {Point(0, 1), -1}, {Point(1 / std::tan(1.0), 0), 0}}, schedule, 36);
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->stop);
  EXPECT_EQ(run->stop->end, PathEnd::gave_up);
  EXPECT_LT(run->stop->share, 2.0 / 3);
  EXPECT_GT(run->stop->share, 0.6);
  ASSERT_EQ(run->stop->sentences.size(), 2U);
  EXPECT_NE(run->stop->sentences[1].find("cut runs off"), std::string::npos);
  const RunFrame& last = run->frames.back();
  EXPECT_NEAR(last.position[2].at.x(), -1 / std::tan(last.values[0]),
              1e-7 * std::abs(last.position[2].at.x()));
}

TEST(PlanarRun, AWishToStopIsObeyed) {
  int looked = 0;
  const auto stop = [&] { return ++looked > 3; };
  const DriveSchedule schedule = along({PathPiece::arc(Point(2.5, 1), 1, 0.3, 4)});
  const auto run = run_motion(arm(), arm_position(std::get<DriverPath>(schedule.motions[0]).at(0).at),
                              schedule, 100000, {stop});
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->stop);
  EXPECT_EQ(run->stop->end, PathEnd::interrupted);
  EXPECT_LT(run->frames.size(), 1000U);
}

TEST(PlanarRun, OnePlaceIsThatOfTheWholeMotion) {
  const DriveSchedule schedule = along({PathPiece::arc(Point(2.5, 1), 1, 0.3, 4)});
  const PlanarPosition start = arm_position(std::get<DriverPath>(schedule.motions[0]).at(0).at);
  const auto run = run_motion(arm(), start, schedule, 8);
  for (const int step : {0, 3, 8}) {
    const auto there = run_to(arm(), start, schedule, step / 8.0);
    ASSERT_TRUE(run && there && !there->stop);
    const RunFrame &one = there->frames.back(), &other = run->frames[static_cast<std::size_t>(step)];
    for (std::size_t body = 1; body < 3; ++body)
      EXPECT_NEAR(one.position[body].angle, other.position[body].angle, 1e-12);
    EXPECT_LT((one.rate - other.rate).norm(), 1e-11);
  }
}

TEST(PlanarRun, AMotionInManyPiecesEndsWhereOneDoes) {
  const auto turn = [&](int steps) {
    const DriveSchedule schedule{{DriverRange{0.2, 0.2 + 4 * pi, {}}}, 1};
    const Point B(std::cos(0.2), std::sin(0.2)), D(3, 0), C = test::meet(B, 2.5, D, 2, 1);
    const PlanarPosition start{{},
                               {Point(0, 0), 0.2},
                               {B, std::atan2((C - B).y(), (C - B).x())},
                               {D, std::atan2((C - D).y(), (C - D).x())}};
    return run_motion(test::four_bar(3, 1, 2.5, 2), start, schedule, steps);
  };
  const auto coarse = turn(1), fine = turn(997);
  ASSERT_TRUE(coarse && fine);
  for (std::size_t body = 0; body < 4; ++body) {
    EXPECT_LT((coarse->frames.back().position[body].at - fine->frames.back().position[body].at).norm(),
              1e-12);
    EXPECT_NEAR(coarse->frames.back().position[body].angle, fine->frames.back().position[body].angle, 1e-12);
  }
}

TEST(DriverPath, RunsAtEvenSpeedOverLinesArcsAndCubics) {
  const DriverPath path({PathPiece::line(Point(0, 0), Point(3, 4)),
                         PathPiece::arc(Point(3, 5), 1, -pi / 2, -pi),
                         PathPiece::cubic(Point(3, 6), Point(5, 9), Point(6, 2), Point(9, 6))});
  const double length = path.length();
  EXPECT_NEAR(path.pieces()[0].length(), 5, 1e-15);
  EXPECT_NEAR(path.pieces()[1].length(), pi, 1e-15);
  double polygon = 0;  // of the cubic, by 20000 chords
  for (int i = 0; i < 20000; ++i)
    polygon += (path.pieces()[2].at(path.pieces()[2].length() * (i + 1) / 20000).at -
                path.pieces()[2].at(path.pieces()[2].length() * i / 20000).at)
                   .norm();
  EXPECT_NEAR(polygon, path.pieces()[2].length(), 1e-7);
  const double h = 1e-5;
  for (double share = 0.01; share < 0.99; share += 0.0137) {
    if (path.piece_at(share - h) != path.piece_at(share + h)) continue;
    const Point speed = (path.at(share + h).at - path.at(share - h).at) / (2 * h * length);
    EXPECT_NEAR(speed.norm(), 1, 1e-7) << share;
    EXPECT_LT((speed - path.at(share).tangent).norm(), 1e-6);
    const Point bend = (path.at(share + h).tangent - path.at(share - h).tangent) / (2 * h * length);
    EXPECT_LT((bend - path.at(share).bend).norm(), 1e-5);
  }
  EXPECT_EQ(path.at(1).at, path.pieces()[2].end());
}

}  // namespace
}  // namespace kempe
