// Path generators: their answers rebuilt by circles that meet, slopes against differences, cognates and defects by the general solver.
#include "synthesis/paths/path_generator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/paths/path_program.hpp"
#include "synthesis/paths/slack.hpp"

namespace kempe {
namespace {

const std::vector<Point> fifty{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};

/// The first case of Cabrera, Simon and Prado 2002: six points of a line, timing free.
PathTask line_of_six() {
  PathTask task;
  for (int i = 0; i < 6; ++i) task.points.emplace_back(20, 20 + 5 * i);
  task.longest = 60;
  task.pivots_within = {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
  return task;
}

/// The second: five points with timing.
PathTask five_timed() {
  PathTask task;
  task.points = {{3, 3}, {2.759, 3.363}, {2.372, 3.663}, {1.890, 3.862}, {1.355, 3.943}};
  for (int i = 0; i < 5; ++i) task.turns.push_back(i * pi / 12);
  task.longest = 50;
  task.pivots_within = fifty;
  return task;
}

/// The third: a loop of eighteen points, 20 degrees from one to the next.
PathTask loop_of_eighteen() {
  PathTask task;
  task.points = {{0.5, 1.1},  {0.4, 1.1}, {0.3, 1.1}, {0.2, 1.0},  {0.1, 0.9},  {0.05, 0.75},
                 {0.02, 0.6}, {0, 0.5},   {0, 0.4},   {0.03, 0.3}, {0.1, 0.25}, {0.15, 0.2},
                 {0.2, 0.3},  {0.3, 0.4}, {0.4, 0.5}, {0.5, 0.7},  {0.6, 0.9},  {0.6, 1.0}};
  for (int i = 0; i < 18; ++i) task.turns.push_back(i * pi / 9);
  task.longest = 50;
  task.pivots_within = fifty;
  return task;
}

/// Where circles about a and b meet nearest to `near`.
Point meeting_near(const Point& a, double ra, const Point& b, double rb, const Point& near) {
  const Point along = b - a;
  const double d = along.norm(), t = (ra * ra - rb * rb + d * d) / (2 * d);
  const double h = std::sqrt(std::max(0.0, ra * ra - t * t));
  const Point foot = a + along / d * t, across = Point(-along.y(), along.x()) / d * h;
  return (foot + across - near).norm() < (foot - across - near).norm() ? Point(foot + across)
                                                                       : Point(foot - across);
}

/// Moves a four-bar in small steps from its first angle, B by circles that meet, and looks at every point.
void expect_reached(const PathTask& task, const PathAnswer& answer) {
  const CouplerFourBar& bar = answer.linkage;
  const Point at_first = answer.reached.front();
  // B at the first point: the corner of the triangle A, B, P that is at the coupler point's distances.
  Point A =
      bar.crank_pivot + bar.crank * Point(std::cos(answer.crank_angles[0]), std::sin(answer.crank_angles[0]));
  const Point q = bar.coupler_point;
  Point B;
  for (const double side : {1.0, -1.0}) {
    const Point guess = meeting_near(A, bar.coupler, bar.rocker_pivot, bar.rocker,
                                     bar.rocker_pivot + side * left_of(A - bar.rocker_pivot) * 1e3);
    const Point along = (guess - A) / bar.coupler;
    if ((A + q.x() * along + q.y() * left_of(along) - at_first).norm() < 1e-6 * bar.longest()) B = guess;
  }
  double square = 0, largest = 0;
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const double from = answer.crank_angles[i == 0 ? 0 : i - 1], to = answer.crank_angles[i];
    for (int step = 1; step <= 200; ++step) {
      const double angle = from + (to - from) * step / 200;
      A = bar.crank_pivot + bar.crank * Point(std::cos(angle), std::sin(angle));
      B = meeting_near(A, bar.coupler, bar.rocker_pivot, bar.rocker, B);
    }
    const Point along = (B - A) / bar.coupler, P = A + q.x() * along + q.y() * left_of(along);
    EXPECT_LT((P - answer.reached[i]).norm(), 1e-8 * bar.longest()) << i;
    const double distance = (P - task.points[i]).norm();
    square += distance * distance / static_cast<double>(task.points.size());
    largest = std::max(largest, distance);
    if (!task.turns.empty()) {
      EXPECT_NEAR(answer.crank_angles[i] - answer.crank_angles[0], task.turns[i], 1e-12);
    }
  }
  EXPECT_NEAR(std::sqrt(square), answer.error_rms, 1e-8 * bar.longest());
  EXPECT_NEAR(largest, answer.error_max, 1e-8 * bar.longest());
  EXPECT_LE(bar.longest(), task.longest);
  EXPECT_GE(answer.transmission_min, task.transmission);
  for (const Point& pivot : {bar.crank_pivot, bar.rocker_pivot})
    EXPECT_LE(pivot.cwiseAbs().maxCoeff(), task.pivots_within[2].x());
}

/// Both cognates, driven by the general solver between the points too, draw what the first linkage draws.
void expect_cognates(const PathAnswer& answer) {
  ASSERT_TRUE(answer.cognates);
  std::vector<double> angles;
  const double first = answer.crank_angles.front(), last = answer.crank_angles.back();
  for (int i = 0; i <= 40; ++i) angles.push_back(first + (last - first) * i / 40);
  const auto curve = certified_path(answer.linkage, CognateDriver::crank, angles, first);
  ASSERT_TRUE(curve);
  for (const Cognate& cognate : *answer.cognates) {
    std::vector<double> driven;
    for (const double angle : angles) driven.push_back(angle + cognate.offset);
    const double start =
        cognate.driver == CognateDriver::crank
            ? driven.front()
            : curve->coupler_angle.front() + std::arg(as_complex(answer.linkage.coupler_point));
    const auto same = certified_path(cognate.linkage, cognate.driver, driven, start);
    ASSERT_TRUE(same);
    for (std::size_t i = 0; i < angles.size(); ++i)
      EXPECT_LT((same->reached[i] - curve->reached[i]).norm(), 1e-10 * answer.linkage.longest());
  }
}

TEST(PathGenerator, MeetsSixPointsOfALine) {
  const PathTask task = line_of_six();
  const auto search = generate_path(task);
  ASSERT_TRUE(search) << search.error();
  EXPECT_GE(search->answers.size(), 2u);
  EXPECT_LT(search->answers.front().error_max, 1e-9);
  EXPECT_GT(search->answers.front().transmission_min, radians(70));  // 64.5 degrees before it is led on
  for (const PathAnswer& answer : search->answers) {
    expect_reached(task, answer);
    expect_cognates(answer);
  }
}

/// Places scattered on the coupler curve of a known four-bar: what comes back meets them, and moves better than it.
TEST(PathGenerator, LeadsWhatMeetsThePointsOnToALargerTransmissionAngle) {
  PathTask task = line_of_six();
  CouplerFourBar known;
  known.rocker_pivot = {30, 5};
  known.crank = 8;
  known.coupler = 26;
  known.rocker = 24;
  known.coupler_point = {12, 15};
  task.points.clear();
  for (const double angle : {0.2, 0.7, 1.0, 1.6, 2.3}) task.points.push_back(known.at(angle).value().P);
  const auto search = generate_path(task, 1);
  ASSERT_TRUE(search) << search.error();
  const PathAnswer& best = search->answers.front();
  expect_reached(task, best);
  EXPECT_LT(best.error_max, 1e-8);
  EXPECT_GT(best.transmission_min, known.least_transmission_angle(0.2, 2.3).value());
}

TEST(PathGenerator, MeetsFivePointsWithTiming) {
  const PathTask task = five_timed();
  const auto search = generate_path(task);
  ASSERT_TRUE(search) << search.error();
  EXPECT_LT(search->answers.front().error_max, 1e-9);
  for (const PathAnswer& answer : search->answers) {
    expect_reached(task, answer);
    expect_cognates(answer);
  }
}

TEST(PathGenerator, FollowsALoopByMeanSquareAndByLargestDistance) {
  PathTask task = loop_of_eighteen();
  const auto squares = generate_path(task);
  ASSERT_TRUE(squares) << squares.error();
  const PathAnswer& best = squares->answers.front();
  EXPECT_LT(18 * best.error_rms * best.error_rms, 0.00903);
  task.aim = PathAim::largest_distance;
  const auto largest = generate_path(task);
  ASSERT_TRUE(largest) << largest.error();
  EXPECT_LT(largest->answers.front().error_max, 0.0307);
  EXPECT_GT(largest->answers.front().error_rms, best.error_rms);
  for (const PathAnswer& answer : {best, largest->answers.front()}) {
    expect_reached(task, answer);
    expect_cognates(answer);
  }
}

TEST(PathGenerator, TheSameTaskGivesTheSameAnswer) {
  const auto one = generate_path(five_timed()), other = generate_path(five_timed());
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->answers.front().linkage.crank, other->answers.front().linkage.crank);
  EXPECT_EQ(one->answers.front().reached, other->answers.front().reached);
}

TEST(PathGenerator, RefusesWhatHasADefectOrBreaksALimit) {
  PathTask task = line_of_six();
  const auto search = generate_path(task);
  ASSERT_TRUE(search) << search.error();
  const PathAnswer& answer = search->answers.front();
  EXPECT_TRUE(judged_path(task, answer.linkage, answer.crank_angles));
  std::vector<double> disordered = answer.crank_angles;
  std::swap(disordered[2], disordered[3]);
  EXPECT_FALSE(judged_path(task, answer.linkage, disordered));
  CouplerFourBar short_rocker = answer.linkage;  // comes apart
  short_rocker.rocker = 0.01 * short_rocker.coupler;
  EXPECT_FALSE(judged_path(task, short_rocker, answer.crank_angles));
  PathTask narrow = task;
  narrow.longest = 0.99 * answer.linkage.longest();
  EXPECT_FALSE(judged_path(narrow, answer.linkage, answer.crank_angles));
  PathTask stiff = task;
  stiff.transmission = answer.transmission_min + 1e-6;
  EXPECT_FALSE(judged_path(stiff, answer.linkage, answer.crank_angles));
  PathTask elsewhere = task;
  elsewhere.pivots_within = {{200, 200}, {201, 200}, {200, 201}};
  EXPECT_FALSE(judged_path(elsewhere, answer.linkage, answer.crank_angles));
}

/// A dead point between two crank angles, at both of which the loop closes, stops the motion.
TEST(PathGenerator, TheGeneralSolverDoesNotPassAPlaceWhereTheLoopOpens) {
  CouplerFourBar bar;  // a double rocker: the crank cannot pass 180 degrees
  bar.rocker_pivot = {10, 0};
  bar.crank = 8;
  bar.coupler = 3;
  bar.rocker = 5;
  bar.coupler_point = {1, 1};
  ASSERT_TRUE(bar.at(0.4));
  ASSERT_TRUE(bar.at(2 * pi - 0.4));
  EXPECT_FALSE(certified_path(bar, CognateDriver::crank, {0.4, 2 * pi - 0.4}, 0.4));
}

/// Whether the crank goes round, by looking: whether the loop closes at every whole degree.
bool goes_round(const CouplerFourBar& bar, bool by_crank) {
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = radians(degree);
    const Point& pivot = by_crank ? bar.crank_pivot : bar.rocker_pivot;
    const Point& other = by_crank ? bar.rocker_pivot : bar.crank_pivot;
    const Point end = pivot + (by_crank ? bar.crank : bar.rocker) * Point(std::cos(angle), std::sin(angle));
    const double gap = (end - other).norm(), far = by_crank ? bar.rocker : bar.crank;
    if (gap > bar.coupler + far || gap < std::abs(bar.coupler - far)) return false;
  }
  return true;
}

TEST(PathGenerator, KeepsTheMotionThatIsAskedFor) {
  using enum CrankMotion;
  for (const std::vector<CrankMotion>& motions : std::initializer_list<std::vector<CrankMotion>>{
           {crank_rocker}, {double_crank}, {rocker_crank}, {double_rocker}, {crank_rocker, double_crank}}) {
    PathTask task = motions.size() == 2 ? line_of_six() : five_timed();
    task.motions = motions;
    const auto search = generate_path(task);
    ASSERT_TRUE(search) << search.error();
    for (const PathAnswer& answer : search->answers) {
      expect_reached(task, answer);
      const bool crank = goes_round(answer.linkage, true), rocker = goes_round(answer.linkage, false);
      if (motions.size() == 2) {
        EXPECT_TRUE(crank);
        continue;
      }
      EXPECT_EQ(crank, motions[0] == crank_rocker || motions[0] == double_crank);
      EXPECT_EQ(rocker, motions[0] == rocker_crank || motions[0] == double_crank);
    }
  }
}

/// The oracle: the angle at B of the triangle A, B, B0 at 20,000 places between, by the law of cosines.
TEST(PathGenerator, KeepsTheTransmissionAngleBetweenThePointsToo) {
  for (PathTask task : {line_of_six(), loop_of_eighteen()}) {
    task.transmission = radians(task.turns.empty() ? 72 : 40);
    const auto search = generate_path(task);
    ASSERT_TRUE(search) << search.error();
    for (const PathAnswer& answer : search->answers) {
      const CouplerFourBar& bar = answer.linkage;
      const double first = answer.crank_angles.front(), last = answer.crank_angles.back();
      double least = pi;
      for (int i = 0; i <= 20000; ++i) {
        const double angle = first + (last - first) * i / 20000;
        const Point A = bar.crank_pivot + bar.crank * Point(std::cos(angle), std::sin(angle));
        const double square = (A - bar.rocker_pivot).squaredNorm();
        const double at_B = std::acos((bar.coupler * bar.coupler + bar.rocker * bar.rocker - square) /
                                      (2 * bar.coupler * bar.rocker));
        least = std::min({least, at_B, pi - at_B});
      }
      EXPECT_GE(least, task.transmission - 1e-12);
      EXPECT_NEAR(least, answer.transmission_min, 1e-6);
    }
  }
}

/// The largest distance of places of one curve from places of the other, 400 between two points.
double apart_by_looking(const PathAnswer& one, const PathAnswer& other) {
  const auto curve = [](const PathAnswer& answer) {
    std::vector<double> angles;
    for (std::size_t i = 1; i < answer.crank_angles.size(); ++i)
      for (int k = 0; k <= 400; ++k)
        angles.push_back(answer.crank_angles[i - 1] +
                         (answer.crank_angles[i] - answer.crank_angles[i - 1]) * k / 400);
    return certified_path(answer.linkage, CognateDriver::crank, angles, angles.front()).value().reached;
  };
  const std::vector<Point> first = curve(one), second = curve(other);
  double farthest = 0;
  for (std::size_t i = 0; i < first.size(); i += 20) {
    double nearest = 1e9;
    for (const Point& q : second) nearest = std::min(nearest, (first[i] - q).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(PathGenerator, AnswersDifferInTheirCurvesAndSayWhichLimitHoldsThemBack) {
  PathTask task = loop_of_eighteen();
  task.transmission = radians(40);
  const auto search = generate_path(task, 6);
  ASSERT_TRUE(search) << search.error();
  ASSERT_GE(search->answers.size(), 2u);
  for (std::size_t k = 0; k < search->answers.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      const PathAnswer &better = search->answers[i], &worse = search->answers[k];
      EXPECT_GT(std::max(apart_by_looking(better, worse), apart_by_looking(worse, better)),
                0.099 * better.error_max);
    }
  const PathAnswer& best = search->answers.front();
  const auto has = [](const PathAnswer& answer, const std::string& key) {
    return std::any_of(answer.active.begin(), answer.active.end(),
                       [&](const ActiveLimit& limit) { return limit.key == key; });
  };
  EXPECT_TRUE(has(best, "limits.transmission_deg"));
  EXPECT_FALSE(has(best, "limits.longest_mm"));
  // A looser limit there gives a smaller error, one elsewhere does not.
  PathTask looser = task;
  looser.transmission -= radians(0.5);
  const auto less = generate_path(looser, 1);
  ASSERT_TRUE(less);
  EXPECT_LT(less->answers.front().error_rms, best.error_rms * (1 - 1e-5));
  looser = task;
  looser.longest *= 1.01;
  const auto same = generate_path(looser, 1);
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->answers.front().error_rms, best.error_rms, 1e-7 * best.error_rms);
}

TEST(PathGenerator, CurvesOfCognatesAreOne) {
  const PathTask task = loop_of_eighteen();
  const PathAnswer answer = generate_path(task, 1).value().answers.front();
  PathAnswer other = answer;
  other.linkage = answer.cognates.value()[1].linkage;
  for (double& angle : other.crank_angles) angle += answer.cognates.value()[1].offset;
  EXPECT_LT(curves_apart(answer, other, 1), 1e-12);
  other = answer;
  other.linkage.coupler_point += Point(0.01, 0);
  EXPECT_NEAR(curves_apart(answer, other, 1), 0.01, 0.005);
  EXPECT_GT(curves_apart(answer, other, 0.004), 1e9);
}

/// The second case as it was published: the crank's pivot, the ground link's direction and the first angle are given too.
PathTask five_timed_as_published() {
  PathTask task = five_timed();
  task.crank_pivot = {0, 0};
  task.ground_angle = 0;
  task.first_angle = pi / 6;
  return task;
}

TEST(PathGenerator, KeepsThePivotTheDirectionAndTheFirstAngleThatAreGiven) {
  PathTask task = five_timed_as_published();
  task.motions = {CrankMotion::crank_rocker};
  const auto search = generate_path(task);
  ASSERT_TRUE(search) << search.error();
  const PathAnswer& best = search->answers.front();
  EXPECT_LT(5 * best.error_rms * best.error_rms, 1.0e-6);  // the best published: 1.28e-6
  for (const PathAnswer& answer : search->answers) {
    expect_reached(task, answer);
    EXPECT_LT(answer.linkage.crank_pivot.norm(), 1e-12);
    EXPECT_LT(std::abs(answer.linkage.rocker_pivot.y()), 1e-12);
    EXPECT_GT(answer.linkage.rocker_pivot.x(), 0);
    EXPECT_NEAR(answer.crank_angles[0], pi / 6, 1e-12);
    EXPECT_TRUE(std::any_of(answer.active.begin(), answer.active.end(),
                            [](const ActiveLimit& limit) { return limit.key == "limits.first_angle_deg"; }));
  }
  PathTask moved = task;
  moved.crank_pivot = {1e-3, 0};
  EXPECT_FALSE(judged_path(moved, best.linkage, best.crank_angles));
  moved = task;
  moved.ground_angle = 1e-3;
  EXPECT_FALSE(judged_path(moved, best.linkage, best.crank_angles));
  moved = task;
  moved.first_angle = pi / 6 + 1e-3;
  EXPECT_FALSE(judged_path(moved, best.linkage, best.crank_angles));
}

/// A task turned about a point as a whole, with free timing: the same four-bars, turned.
TEST(PathGenerator, WhatIsGivenTurnsWithTheTask) {
  PathTask task = line_of_six();
  task.pivots_within.clear();
  task.points.push_back({30, 50});
  task.points.push_back({50, 45});
  task.crank_pivot = {5, 10};
  task.ground_angle = 0.3;
  PathTask turned = task;
  const auto turn = [](const Point& p) { return as_point(as_complex(p) * std::polar(1.0, 2.0)); };
  for (Point& p : turned.points) p = turn(p);
  turned.crank_pivot = turn(*task.crank_pivot);
  turned.ground_angle = 2.3;
  const auto one = generate_path(task, 1), other = generate_path(turned, 1);
  ASSERT_TRUE(one) << one.error();
  ASSERT_TRUE(other) << other.error();
  const PathAnswer &first = one->answers.front(), &second = other->answers.front();
  EXPECT_NEAR(second.error_rms, first.error_rms, 1e-6 * (1 + first.error_rms));
  EXPECT_LT((turn(first.linkage.crank_pivot) - second.linkage.crank_pivot).norm(), 1e-9);
  const Point ground = second.linkage.rocker_pivot - second.linkage.crank_pivot;
  EXPECT_NEAR(std::atan2(ground.y(), ground.x()), 2.3, 1e-9);
}

/// From where the first solver ends the second goes no farther up, for either aim, and keeps the limits.
TEST(PathGenerator, TheSecondSolverEndsNoHigherThanTheFirst) {
  const PathTask task = loop_of_eighteen();
  int seen = 0;
  for (const PathAim aim : {PathAim::mean_square, PathAim::largest_distance})
    for (int start = 0; start < 6; ++start) {
      const PathProgram program(task, start % 2 ? FourBarBranch::first : FourBarBranch::second, true);
      Eigen::VectorXd x = Eigen::VectorXd::Zero(program.size()), errors, limits;
      x.segment<4>(6) << -1.2 + 0.1 * start, 0.3 + 0.1 * start, 0.4 - 0.1 * start, 0.5 * start;
      if (!program.project(x)) continue;
      const auto highest = [&](const Eigen::VectorXd& at) {
        EXPECT_TRUE(program.errors(at, errors, nullptr));
        if (aim == PathAim::mean_square) return errors.squaredNorm() / program.count();
        return errors.reshaped(2, program.count()).colwise().squaredNorm().maxCoeff();
      };
      std::size_t evaluations = 0;
      x = refined_path(program, aim, 1500, x, evaluations);
      program.limits(x, limits, nullptr);
      if (limits.maxCoeff() > slack::path_limit_broken) continue;
      ++seen;
      const std::size_t before = evaluations;
      const Eigen::VectorXd end = polished_path(program, aim, x, evaluations);
      EXPECT_GT(evaluations, before);
      EXPECT_LE(highest(end), highest(x) * (1 + 1e-6)) << start;
      program.limits(end, limits, nullptr);
      EXPECT_LE(limits.maxCoeff(), slack::path_limit_broken) << start;
    }
  EXPECT_GE(seen, 6);
}

/// No step away from it lessens the squares, along any unknown that is not given.
TEST(PathGenerator, ProjectsOntoTheBestOfWhatIsNotGiven) {
  PathTask task = five_timed();
  for (int given = 0; given < 4; ++given) {
    if (given & 1) task.crank_pivot = {0.5, -1};
    task.ground_angle = given & 2 ? std::optional(2.4) : std::nullopt;
    const PathProgram program(task, FourBarBranch::first, true);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(program.size()), value, near;
    x.segment<4>(6) << -0.9, 0.1, 0.2, 0.4;
    const bool found = program.project(x);
    ASSERT_TRUE(found || given >= 2) << given;
    ASSERT_TRUE(program.errors(x, value, nullptr));
    for (int k = 0; k < 6; ++k)
      for (const double step : {1e-3, -1e-3}) {
        if (program.is_given(k)) continue;
        Eigen::VectorXd beside = x;
        beside[k] += step;
        program.errors(beside, near, nullptr);
        EXPECT_GT(near.squaredNorm(), value.squaredNorm()) << given << " " << k;
      }
    const CouplerFourBar bar = program.linkage(x);
    if (task.crank_pivot) {
      EXPECT_LT((bar.crank_pivot - *task.crank_pivot).norm(), 1e-12);
    }
    if (task.ground_angle) {
      EXPECT_EQ(x[3], 0);
    }
    task.crank_pivot.reset();
  }
}

void expect_slopes(const PathTask& task) {
  PathProgram program(task, FourBarBranch::second, true);
  Eigen::VectorXd x(program.size());
  x.head<9>() << 0.3, -0.2, 0.5, 0.1, 0.4, -0.6, -0.9, 0.1, 0.2;
  for (Eigen::Index i = 9; i < x.size(); ++i) x[i] = 0.4 + 0.3 * static_cast<double>(i - 9);
  program.watch_extremes(x);
  program.choose_motion(x);
  Eigen::VectorXd value, above, below;
  Eigen::MatrixXd errors, limits;
  ASSERT_TRUE(program.errors(x, value, &errors));
  program.limits(x, value, &limits);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Eigen::VectorXd more = x, less = x;
    more[k] += 1e-6;
    less[k] -= 1e-6;
    program.errors(more, above, nullptr);
    program.errors(less, below, nullptr);
    if (program.is_given(static_cast<int>(k))) {
      EXPECT_EQ(errors.col(k).norm(), 0) << k;
      continue;
    }
    EXPECT_LT((errors.col(k) - (above - below) / 2e-6).lpNorm<Eigen::Infinity>(), 1e-7) << k;
    program.limits(more, above, nullptr);
    program.limits(less, below, nullptr);
    EXPECT_LT((limits.col(k) - (above - below) / 2e-6).lpNorm<Eigen::Infinity>(), 1e-7) << k;
  }
}

TEST(PathGenerator, SlopesAreThoseOfTheErrorsAndLimits) {
  expect_slopes(line_of_six());
  expect_slopes(loop_of_eighteen());
  expect_slopes(five_timed_as_published());
  for (const CrankMotion motion : {CrankMotion::crank_rocker, CrankMotion::double_crank,
                                   CrankMotion::rocker_crank, CrankMotion::double_rocker}) {
    PathTask task = loop_of_eighteen();
    task.motions = {motion};
    expect_slopes(task);
  }
}

/// The rows of a choice and the rule of Grashof on scattered lengths: the same, but near a change point.
TEST(PathGenerator, RowsOfAMotionAreGrashofsRule) {
  PathTask task = five_timed();
  task.longest = 1e6;
  task.pivots_within.clear();
  for (const CrankMotion motion : {CrankMotion::crank_rocker, CrankMotion::double_crank,
                                   CrankMotion::rocker_crank, CrankMotion::double_rocker}) {
    task.motions = {motion};
    int of_it = 0;
    for (int i = 1; i <= 500; ++i) {
      PathProgram program(task, FourBarBranch::first, true);
      Eigen::VectorXd x = Eigen::VectorXd::Zero(program.size()), value;
      x[2] = 1;
      for (int k = 0; k < 3; ++k) x[6 + k] = 2 * std::fmod(i * std::sqrt(k == 2 ? 5.0 : 2.0 + k), 1) - 1;
      program.choose_motion(x);
      program.limits(x, value, nullptr);
      const bool is_it = program.linkage(x).links().motion() == motion;
      EXPECT_EQ(value.tail<3>().maxCoeff() <= 0, is_it) << i;
      of_it += is_it;
    }
    EXPECT_GT(of_it, 20);
  }
}

}  // namespace
}  // namespace kempe
