#include "synthesis/verification/drawing_trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "geometry/segment_distance.hpp"
#include "tests/random.hpp"

namespace kempe {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double operator()(double a, double b) { return test::uniform(bits_, a, b); }

 private:
  std::mt19937_64 bits_;
};

TraceTask task(Complex k, Grounding grounding, double VA, double VB, int assembly_mode,
               Point pole = Point::Zero()) {
  const auto linkage = *CopyingLinkage::make(k, grounding, VA, VB, assembly_mode, pole);
  const OpeningInterval all = linkage.assembly_mode().openings;
  return {MapTask{linkage, {}, {}}, shrink(all, 0.15 * all.width())};
}

/// A random stroke all of which the tracer reaches: no way between two corners comes nearer to the pole than they do, for a thin
/// annulus of reach would not hold it.
DrawnStroke reachable_stroke(const TraceTask& task, Random& random, int corners) {
  const CopyingLinkage& linkage = task.mechanism.linkage;
  DrawnStroke stroke;
  double bearing = random(-3, 3);
  while (stroke.points.size() < static_cast<std::size_t>(corners)) {
    const double next = bearing + random(-0.002, 0.002), share = random(0.3, 0.7);
    const Point corner = linkage.tracer_at(task.opening.lower + share * task.opening.width(), next);
    if (!stroke.points.empty()) {
      const double nearest = nearest_share(linkage.pole(), stroke.points.back(), corner);
      if (nearest > 0 && nearest < 1) continue;
    }
    bearing = next;
    stroke.points.push_back(corner);
  }
  return stroke;
}

Point image(const TraceTask& task, const Point& p) {
  const CopyingLinkage& linkage = task.mechanism.linkage;
  return linkage.pole() + as_point(linkage.k() * as_complex(p - linkage.pole()));
}

TEST(DrawingTrace, DrawsTheSimilarImageWithEveryGroundingAndAssembly) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Complex k = i % 4 == 0 ? Complex(random(1.1, 4) * (i % 8 == 0 ? 1 : -1))
                                 : std::polar(random(0.3, 4), random(-3, 3));
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto count = static_cast<int>(assembly_modes(shape_of(k, grounding)).size());
    const TraceTask one =
        task(k, grounding, random(20, 200), random(20, 200), i % count, {random(-50, 50), random(-50, 50)});
    const DrawnStroke stroke = reachable_stroke(one, random, 5);
    const Trace trace = trace_drawing(one, {stroke}, {.step = 1.0});
    ASSERT_EQ(trace.drawn.size(), 1U);
    EXPECT_EQ(trace.poses_missed, 0U);
    const double size = one.mechanism.linkage.size();
    EXPECT_LT(trace.departure, 1e-9 * size);
    EXPECT_LT((trace.drawn[0].points.front() - image(one, stroke.points.front())).norm(), 1e-9 * size);
    EXPECT_LT((trace.drawn[0].points.back() - image(one, stroke.points.back())).norm(), 1e-9 * size);
  }
}

TEST(DrawingTrace, KeepsEveryLinksLength) {
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  Random random(2);
  const Trace trace =
      trace_drawing(one, {reachable_stroke(one, random, 10)}, {.step = 0.5, .keep_poses = true});
  const LinkLengths l = one.mechanism.linkage.lengths();
  for (const TracedPose& row : trace.poses) {
    const Pose& p = row.pose.value();
    const double found[] = {(p.A - p.V).norm(), (p.B - p.V).norm(), (p.C - p.A).norm(), (p.C - p.B).norm(),
                            (p.X - p.A).norm(), (p.X - p.C).norm(), (p.Y - p.B).norm(), (p.Y - p.C).norm()};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(found[i], l.values()[i], 1e-11);
    EXPECT_EQ(p.X, row.tracer);
    EXPECT_LT(p.V.norm(), 1e-11);
  }
}

TEST(DrawingTrace, CutsAtTheEdgeOfTheReach) {
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  const auto radii = one.mechanism.linkage.radii_over(one.opening);
  const DrawnStroke across{{{-200, 10}, {200, 10}}};  // out, in, through the hole about the pole, out again
  const Trace trace = trace_drawing(one, {across});
  ASSERT_EQ(trace.drawn.size(), 2U);
  ASSERT_EQ(trace.missing.size(), 3U);
  EXPECT_NEAR(trace.drawn_length + trace.missing_length, 400, 1e-6);
  EXPECT_NEAR(trace.drawn_length,
              2 * (std::sqrt(radii.upper * radii.upper - 100) - std::sqrt(radii.lower * radii.lower - 100)),
              1e-6);
  for (const TracedLine& line : trace.drawn)
    for (const Point& p : {line.points.front(), line.points.back()}) {
      const double radius = p.norm() / 1.4;
      EXPECT_LT(std::min(std::abs(radius - radii.lower), std::abs(radius - radii.upper)), 1e-7);
    }
  EXPECT_EQ(std::accumulate(trace.missed_by_cause.begin(), trace.missed_by_cause.end(), std::size_t{0}),
            trace.poses_missed);
  EXPECT_GT(trace.missed_by_cause[static_cast<std::size_t>(NotReached::too_far)], 0U);
}

TEST(DrawingTrace, KeepsOrderAndDirection) {
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  Random random(3);
  std::vector<DrawnStroke> strokes;
  for (int i = 0; i < 20; ++i) strokes.push_back(reachable_stroke(one, random, 4));
  strokes[7].closed = true;
  const Trace trace = trace_drawing(one, strokes);
  ASSERT_EQ(trace.drawn.size(), strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    EXPECT_EQ(trace.drawn[i].stroke, i);
    EXPECT_EQ(trace.drawn[i].closed, i == 7);
    EXPECT_LT((trace.drawn[i].points.front() - image(one, strokes[i].points.front())).norm(), 1e-9);
  }
}

TEST(DrawingTrace, LeavesOutWhereAnObstacleStands) {
  TraceTask one = task(2.5, Grounding::tracer, 90, 70, 1);
  Random random(4);
  const DrawnStroke stroke = reachable_stroke(one, random, 8);
  ASSERT_EQ(trace_drawing(one, {stroke}).poses_missed, 0U);
  const Point at = image(one, stroke.points[3]);
  one.mechanism.obstacles = {
      {.shape = {{at + Point(-2, -2), at + Point(2, -2), at + Point(2, 2), at + Point(-2, 2)}, {}},
       .lowest_layer = 1,
       .highest_layer = 9}};
  const Trace trace = trace_drawing(one, {stroke});
  EXPECT_GT(trace.missed_by_cause[static_cast<std::size_t>(NotReached::obstacle)], 0U);
}

TEST(DrawingTrace, AMadeInstrumentDepartsInProportionToItsTolerances) {
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  Random random(5);
  const DrawnStroke stroke = reachable_stroke(one, random, 6);
  const auto departure = [&](double tolerance, std::uint64_t seed) {
    return trace_drawing(one, {stroke}, {.made = TraceOptions::Made{seed, {tolerance, tolerance}}}).departure;
  };
  EXPECT_LT(departure(0, 1), 1e-10);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_GT(departure(0.01, seed), 1e-3);
    EXPECT_NEAR(departure(0.01, seed) / departure(0.001, seed), 10, 0.2);
    EXPECT_EQ(departure(0.01, seed), departure(0.01, seed));
  }
  EXPECT_NE(departure(0.01, 1), departure(0.01, 2));
}

TEST(DrawingTrace, TakesAStrokeOfOnePlaceOrNone) {
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  EXPECT_TRUE(trace_drawing(one, {}).drawn.empty());
  const Point p = one.mechanism.linkage.tracer_at(one.opening.middle(), 0);
  EXPECT_LT(trace_drawing(one, {{{p, p}, false}}).departure, 1e-10);
}

TEST(DrawingTrace, StoppedKeepsWhatIsDrawnAndSaysThatItIsNotAll) {
  Random random(5);
  const TraceTask one = task({0, 1.4}, Grounding::pole, 50, 35, 3);
  const std::vector<DrawnStroke> strokes{reachable_stroke(one, random, 20),
                                         reachable_stroke(one, random, 20)};
  const Trace whole = trace_drawing(one, strokes, {.step = 0.001});
  EXPECT_TRUE(whole.complete);
  std::size_t asked = 0;
  const Trace part = trace_drawing(one, strokes, {.step = 0.001, .stop = [&] { return ++asked > 50; }});
  EXPECT_FALSE(part.complete);
  EXPECT_LE(part.poses_tried, 60U);
  EXPECT_LT(part.drawn_length, whole.drawn_length);
  ASSERT_EQ(part.drawn.size(), 1U);
  EXPECT_TRUE(
      std::equal(part.drawn[0].points.begin(), part.drawn[0].points.end(), whole.drawn[0].points.begin()));
  EXPECT_EQ(asked, 51U);
}

TEST(DrawingTrace, OfALoadedInstrumentLiesBesideTheImageByItsGive) {
  Random random(9);
  for (int i = 0; i < 30; ++i) {
    const TraceTask one =
        task(std::polar(random(0.3, 3), random(-3, 3)), all_groundings[static_cast<std::size_t>(i) % 3],
             random(60, 200), random(60, 200), 0);
    const CopyingLinkage& linkage = one.mechanism.linkage;
    const DrawnStroke stroke = reachable_stroke(one, random, 4);
    TraceOptions options{.step = 0.5, .keep_poses = true};
    options.work =
        HandWork(linkage, {.width = 15, .thickness = 5}, {}, {"steel", 200e3, 7850, 235}, {.pen_force = 10});
    options.keep_hand = options.gives_way = true;
    const Trace trace = trace_drawing(one, {stroke}, options);
    ASSERT_EQ(trace.drawn.size(), 1U);
    ASSERT_EQ(trace.drawn[0].hand.size(), trace.drawn[0].points.size());
    double most = 0;
    for (const TracedPose& pose : trace.poses) {
      EXPECT_NEAR(pose.heading.norm(), 1, 1e-12);
      most = std::max(most, options.work->at(*pose.pose, pose.heading)->give.norm());
    }
    EXPECT_GE(trace.departure, most - 1e-9);
    EXPECT_LE(trace.departure, 1.2 * most);  // at a corner the give has the direction of neither row
    options.gives_way = false;
    EXPECT_LT(trace_drawing(one, {stroke}, options).departure, 1e-9);
  }
}

TEST(DrawingTrace, OfALoadedInstrumentGivesWayTheOtherWayWhereTheStrokeTurnsBack) {
  Random random(10);
  const TraceTask one = task({0, 1.4}, Grounding::pole, 120, 90, 3);
  DrawnStroke stroke = reachable_stroke(one, random, 2);
  stroke.points.push_back(stroke.points.front());
  TraceOptions options{.step = 1000};
  options.work = HandWork(one.mechanism.linkage, {.width = 15, .thickness = 5}, {},
                          {"steel", 200e3, 7850, 235}, {.pen_force = 10});
  options.gives_way = true;
  const Trace trace = trace_drawing(one, {stroke}, options);
  ASSERT_EQ(trace.drawn.size(), 1U);
  const Stroke& points = trace.drawn[0].points;
  ASSERT_EQ(points.size(), 4U);  // at the far end the pen springs from one side of its image to the other
  EXPECT_LT((0.5 * (points[1] + points[2]) - image(one, stroke.points[1])).norm(), 1e-9);
  EXPECT_GT((points[1] - points[2]).norm(), 1e-6);
}

}  // namespace
}  // namespace kempe
