#include "workspace/map/workspace_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/regions/region_algebra.hpp"
#include "tests/samples.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/map/layer_choice.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::Dice;

Polygon box(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}};
}

Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

Ring regular(const Point& centre, double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(centre + as_point(std::polar(radius, 2 * pi * i / corners)));
  return ring;
}

Obstacle block(Polygon shape, int lowest = 1, int highest = 4) {
  return {std::move(shape), lowest, highest, {}};
}

/// The plagiograph report's linkage, free between 57.4 and 73.9 mm from the pole.
MapTask report_task(Point pole = Point::Zero()) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2, pole);
  return {linkage, {6, 3, 4, PlateStyle::bent}, {}, {.clearance = 0.5, .transmission = radians(10)}};
}

Annulus free_annulus(const MapTask& task) {
  return annulus_over(task.linkage,
                      contact_free_openings(task.linkage, task.style, task.layers, task.limits.clearance,
                                            task.linkage.openings_with_transmission(task.limits.transmission))
                          .at(0)
                          .interval);
}

const MapOptions no_sheets{.largest_sheets = false};

double all_areas(const WorkspaceMap& map) {
  double sum = area(map.collision_free) + area(map.uncertain);
  for (const LostArea& one : map.lost) sum += area(one.area);
  return sum;
}

TEST(WorkspaceMap, WithoutObstaclesTheAreasAreThoseOfTheAnnuli) {
  Dice dice(71);
  int with_free = 0;
  for (int i = 0; i < 200; ++i) {
    const MapTask task{test::random_linkage(dice),
                       test::random_style(dice),
                       test::random_layers(dice),
                       {.clearance = dice.between(0, 1), .transmission = dice.between(0, 0.4)}};
    const WorkspaceMap map = map_workspace(task, no_sheets);
    double free = 0;
    for (const FreeOpenings& one :
         contact_free_openings(task.linkage, task.style, task.layers, task.limits.clearance,
                               task.linkage.openings_with_transmission(task.limits.transmission)))
      free += area(annulus_over(task.linkage, one.interval));
    const Annulus chain = chain_annulus(task.linkage);
    const double whole = pi * chain.outer * chain.outer;
    EXPECT_NEAR(area(map.collision_free), free, 1e-9 * whole);
    EXPECT_NEAR(area(map.reachable), area(reachable_annulus(task.linkage)), 1e-9 * whole);
    EXPECT_NEAR(area(map.usable), area(usable_annulus(task.linkage, task.limits.transmission)), 1e-9 * whole);
    EXPECT_EQ(map.uncertain.size(), 0u);
    EXPECT_NEAR(all_areas(map), whole, 1e-6 * whole) << "every place has its verdict";
    with_free += free > 0;
  }
  EXPECT_GT(with_free, 50);
}

TEST(WorkspaceMap, CertifiedOpeningKeepsEveryLimitOfTheLinkageItself) {
  const MapTask task = report_task();
  const OpeningInterval opening = map_workspace(task, no_sheets).certified_opening;
  EXPECT_NEAR(opening.lower, std::asin(6.5 / 35), 3e-9);
  EXPECT_NEAR(opening.upper, radians(80), 1e-12);
}

MapTask with_obstacles(MapTask task, Dice& dice, int count) {
  for (int i = 0; i < count; ++i)
    task.obstacles.push_back(block(
        {regular(task.linkage.pole() + as_point(std::polar(dice.between(70, 130), dice.between(-pi, pi))),
                 dice.between(1, 6), 3 + dice.below(10)),
         {}}));
  return task;
}

TEST(WorkspaceMap, UncertainBandShrinksWithTheTolerance) {
  Dice dice(72);
  const MapTask task = with_obstacles(report_task(), dice, 4);
  double last = 1e300;
  for (const double tolerance : {0.05, 0.01, 0.002}) {
    const WorkspaceMap map = map_workspace(task, {.map_tolerance = tolerance, .largest_sheets = false});
    EXPECT_LE(area(map.uncertain), tolerance * area(map.collision_free));
    EXPECT_LT(area(map.uncertain), last);
    last = area(map.uncertain);
    EXPECT_NEAR(all_areas(map), pi * 75 * 75, 1e-6 * pi * 75 * 75);
  }
}

TEST(WorkspaceMap, BarsThatLieAcrossAnObstacleAreDecidedToo) {
  MapTask task = report_task();
  task.obstacles = {block(box(-20, 70, 40, 60)), block(box(30, -200, 10, 170), 1, 1)};
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_GT(area(map.collision_free), 100);
  EXPECT_LE(area(map.uncertain), 0.005 * area(map.collision_free));
}

TEST(WorkspaceMap, VerdictsAgreeWithTheMap) {
  Dice dice(73);
  const MapTask task = with_obstacles(report_task({10, 20}), dice, 5);
  const WorkspaceMap map = map_workspace(task, no_sheets);
  const auto holds = [](const ArcRegion& region, const Point& point) {
    return contains(flattened(region, 1e-3, Flatten::shrinks), point);
  };
  for (int i = 0; i < 300; ++i) {
    const Point point =
        task.linkage.pole() + as_point(std::polar(dice.between(50, 76), dice.between(-pi, pi)));
    const Verdict verdict = verdict_at(task, point);
    EXPECT_FALSE(verdict.sentence.empty());
    EXPECT_TRUE(verdict.free || !holds(map.collision_free, point)) << verdict.sentence;
    for (const LostArea& lost : map.lost)
      if (holds(lost.area, point)) {
        EXPECT_FALSE(verdict.free) << verdict.sentence;
        EXPECT_EQ(verdict.parts.empty(), lost.parts.empty()) << verdict.sentence;
      }
  }
}

Point moved(const Point& point, Complex turn, const Point& shift) {
  return as_point(turn * as_complex(point)) + shift;
}

TEST(WorkspaceMap, MovesWithItsTask) {
  Dice dice(74);
  for (int i = 0; i < 5; ++i) {
    const MapTask task = with_obstacles(report_task(), dice, 3);
    const Complex turn = std::polar(1.0, dice.between(-pi, pi));
    const Point shift(dice.between(-500, 500), dice.between(-500, 500));
    MapTask other = report_task(shift);
    for (Obstacle obstacle : task.obstacles) {
      for (Point& point : obstacle.shape.outer) point = moved(point, turn, shift);
      other.obstacles.push_back(obstacle);
    }
    const WorkspaceMap a = map_workspace(task, no_sheets), b = map_workspace(other, no_sheets);
    EXPECT_NEAR(area(a.collision_free), area(b.collision_free), area(a.uncertain) + area(b.uncertain));
    for (int sample = 0; sample < 100; ++sample) {
      const Point point = as_point(std::polar(dice.between(50, 76), dice.between(-pi, pi)));
      const Verdict one = verdict_at(task, point), two = verdict_at(other, moved(point, turn, shift));
      EXPECT_EQ(one.free, two.free);
      EXPECT_EQ(one.parts, two.parts);
    }
  }
}

TEST(WorkspaceMap, ShrinksAsClearanceAndWidthGrow) {
  Dice dice(75);
  for (int i = 0; i < 5; ++i) {
    MapTask task = with_obstacles(report_task(), dice, 3);
    WorkspaceMap before = map_workspace(task, no_sheets);
    for (const bool widen : {false, true, false, true}) {
      (widen ? task.style.width : task.limits.clearance) += widen ? 1 : 0.7;
      const WorkspaceMap after = map_workspace(task, no_sheets);
      EXPECT_LE(area(after.collision_free), area(before.collision_free) + area(before.uncertain) + 1e-9);
      before = after;
    }
  }
}

TEST(WorkspaceMap, IsTheSameEveryTime) {
  Dice dice(76);
  const MapTask task = with_obstacles(report_task(), dice, 4);
  const WorkspaceMap a = map_workspace(task, {}), b = map_workspace(task, {});
  EXPECT_EQ(area(a.collision_free), area(b.collision_free));
  ASSERT_EQ(a.largest_sheets.size(), b.largest_sheets.size());
  for (std::size_t i = 0; i < a.largest_sheets.size(); ++i)
    EXPECT_EQ(a.largest_sheets[i].centre, b.largest_sheets[i].centre);
}

// What the tracer must cover.

TEST(Coverage, RegionWithinTheFreeAnnulusIsCovered) {
  MapTask task = report_task();
  task.region = {{box(60, -5, 8, 10)}};
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_TRUE(map.coverage.covered) << map.coverage.why_not;
  EXPECT_TRUE(map.coverage.why_not.empty());
}

TEST(Coverage, RegionBeyondTheReachIsRefusedWithFigures) {
  MapTask task = report_task();
  task.region = {{box(60, -5, 20, 10)}};
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_FALSE(map.coverage.covered);
  EXPECT_FALSE(map.coverage.uncertain);
  ASSERT_TRUE(map.coverage.witness);
  EXPECT_TRUE(contains(task.region, *map.coverage.witness));
  EXPECT_GT(area(map.lost.front().area), pi * 25 * 25)
      << "the part of the region beyond the reach is shown as lost";
}

TEST(Coverage, RegionAroundThePoleIsRefused) {
  MapTask task = report_task();
  task.region = {{box(-60, -60, 120, 120)}};
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  EXPECT_FALSE(coverage.covered);
  EXPECT_EQ(coverage.cause, Cause::out_of_reach);
  EXPECT_NE(coverage.why_not.find("pole"), std::string::npos) << coverage.why_not;
}

TEST(Coverage, RegionWhoseHoleSurroundsThePoleIsCovered) {
  MapTask task = report_task();
  const Annulus free = free_annulus(task);
  task.region = {
      {{regular({0, 0}, free.outer - 0.1, 360), {reversed(regular({0, 0}, free.inner + 0.2, 360))}}}};
  EXPECT_TRUE(map_workspace(task, no_sheets).coverage.covered);
}

TEST(Coverage, RegionThatExactlyTouchesItsLimitIsCovered) {
  MapTask task = report_task();
  const Annulus free = free_annulus(task);
  const double x = std::sqrt(free.outer * free.outer - 25);
  task.region.polygons = {Polygon{{{free.inner, 0}, {x, -5}, {x, 5}}, {}}};
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  EXPECT_TRUE(coverage.covered) << coverage.why_not;
}

TEST(Coverage, ObstacleInTheWayIsNamedWithTheLinkItMeets) {
  MapTask task = report_task();
  task.region = {{box(60, -5, 8, 10)}};
  task.obstacles = {block(box(64, 4, 1, 1))};
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  EXPECT_FALSE(coverage.covered);
  EXPECT_EQ(coverage.cause, Cause::obstacle_contact);
  ASSERT_EQ(coverage.parts.size(), 2u);
  EXPECT_EQ(coverage.parts[1], "obstacle 1");
  ASSERT_TRUE(coverage.witness);
  EXPECT_TRUE(contains(task.region, *coverage.witness));
}

TEST(Coverage, SharesOfTheRegionThatAreLostAddUp) {
  MapTask task = report_task();
  task.region = {{box(50, -10, 30, 20)}};
  task.obstacles = {block(box(64, 4, 1, 1))};
  const WorkspaceMap map = map_workspace(task, no_sheets);
  ASSERT_FALSE(map.coverage.losses.empty());
  double lost = 0, last = 1;
  for (const RegionLoss& loss : map.coverage.losses) {
    EXPECT_LE(loss.share, last);
    last = loss.share;
    lost += loss.share;
  }
  const double free = area(intersection(map.collision_free, as_arcs(task.region))) / area(task.region);
  const double uncertain = area(intersection(map.uncertain, as_arcs(task.region))) / area(task.region);
  EXPECT_NEAR(free + uncertain + lost, 1, 1e-5);
  EXPECT_NE(map.coverage.why_not.find("% of the region is lost"), std::string::npos) << map.coverage.why_not;
}

TEST(Coverage, HoleOfTheRegionLeavesRoomForAnObstacle) {
  MapTask task = report_task();
  Polygon frame = box(58, -7, 14, 14);
  frame.holes.push_back(reversed(box(59, -6, 12, 12).outer));
  task.region = {{frame}};
  task.obstacles = {block(box(65, -0.2, 0.4, 0.4))};
  // The tracer's plate needs 3.5 mm around it on every side, and its bars reach in from outside the region.
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  const auto clearance = smallest_clearance(task);
  ASSERT_TRUE(clearance);
  EXPECT_EQ(coverage.covered, clearance->gap >= task.limits.clearance) << coverage.why_not;
}

TEST(Coverage, PartsCutOffFromEachOtherAreNamed) {
  // Two walls across the annulus leave two components; the region has a part in each.
  MapTask task = report_task();
  task.layers = {{2, 1, 1, 2}};
  task.obstacles = {block(box(55, -1, 20, 2), 1, 2), block(box(-75, -1, 20, 2), 1, 2)};
  const WorkspaceMap alone = map_workspace(task, no_sheets);
  std::vector<Point> places;
  for (const ArcPolygon& polygon : alone.collision_free)
    if (area(polygon) > 50) places.push_back(polygon.outer.front().at);
  ASSERT_GE(alone.collision_free.size(), 2u);
  // A small square in the middle of the two largest components.
  auto largest = alone.collision_free;
  std::sort(largest.begin(), largest.end(),
            [](const ArcPolygon& a, const ArcPolygon& b) { return area(a) > area(b); });
  for (int i = 0; i < 2; ++i) {
    double bearing = 0;
    Complex mean = 0;
    for (const ArcVertex& grounding : largest[static_cast<std::size_t>(i)].outer)
      mean += as_complex(grounding.at) / std::abs(as_complex(grounding.at));
    bearing = std::arg(mean);
    const Point centre = as_point(std::polar(66.0, bearing));
    ASSERT_TRUE(verdict_at(task, centre).free);
    task.region.polygons.push_back({regular(centre, 0.5, 5), {}});
  }
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  EXPECT_FALSE(coverage.covered);
  EXPECT_FALSE(coverage.uncertain);
  EXPECT_EQ(coverage.cause, Cause::obstacle_contact);
  EXPECT_NE(coverage.why_not.find("cut off"), std::string::npos) << coverage.why_not;
}

TEST(Coverage, SheetsThatOverlapAreRefusedAndThoseApartAreNot) {
  MapTask task = report_task();
  task.region = {{box(60, -5, 8, 10)}};
  task.limits.copy_gap = 5;
  EXPECT_TRUE(map_workspace(task, no_sheets).coverage.covered);
  task.limits.copy_gap = 100;
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_FALSE(map.coverage.covered);
  EXPECT_EQ(map.coverage.cause, Cause::copy_overlap);
  EXPECT_GT(area(map.lost.back().area), 0);
}

TEST(Coverage, ManyCornersAndHolesAreDecided) {
  MapTask task = report_task();
  Polygon comb{regular({64, 0}, 6, 60'000), {}};
  for (int i = 0; i < 40; ++i)
    comb.holes.push_back(reversed(regular({60.5 + 0.9 * (i % 8), -2.4 + 1.2 * (i / 8)}, 0.3, 1000)));
  task.region = {{comb}};
  task.obstacles = {block({regular({0, -95}, 3, 20), {}})};
  const Coverage coverage = map_workspace(task, no_sheets).coverage;
  const auto clearance = smallest_clearance(task);
  ASSERT_TRUE(clearance);
  EXPECT_EQ(coverage.covered, clearance->gap >= task.limits.clearance) << coverage.why_not;
}

TEST(Coverage, AgreesWithVerdictsAndClearanceOnRandomTasks) {
  Dice dice(78);
  int covered = 0, refused = 0;
  for (int i = 0; i < test::samples(150); ++i) {
    MapTask task{test::random_linkage(dice),
                 {5, 3, 4, PlateStyle::bent},
                 test::random_layers(dice),
                 {.clearance = 0.5, .transmission = radians(8)}};
    const Annulus reach = reachable_annulus(task.linkage);
    const double size = reach.outer;
    for (int k = dice.below(4); k > 0; --k) {
      const Point at =
          task.linkage.pole() + as_point(std::polar(size * dice.between(0.3, 2), dice.between(-pi, pi)));
      task.obstacles.push_back(
          block({regular(at, size * dice.between(0.01, 0.1), 3 + dice.below(8)), {}}, 1 + dice.below(3)));
    }
    const double radius =
        dice.between(0.3 * reach.inner + 0.7 * reach.outer, 0.7 * reach.inner + 0.3 * reach.outer);
    const Point middle = task.linkage.pole() + as_point(std::polar(radius, dice.between(-pi, pi)));
    const double extent = (reach.outer - reach.inner) * dice.between(0.02, 0.3);
    task.region = {{{regular(middle, extent, 3 + dice.below(6)), {}}}};
    const WorkspaceMap map = map_workspace(task, no_sheets);
    const double all = area(map.collision_free) + area(map.uncertain);
    EXPECT_LE(area(map.uncertain),
              0.005 * std::max(area(map.collision_free), 0.011 * all) + 0.0001 * area(reach))
        << i;
    if (map.coverage.covered) {
      ++covered;
      EXPECT_GE(map.clearance_min, task.limits.clearance - 1e-2) << i;
      for (int sample = 0; sample < 20; ++sample) {
        const Point point = middle + extent * Point(dice.between(-1, 1), dice.between(-1, 1));
        if (contains(task.region, point)) {
          const Verdict verdict = verdict_at(task, point);
          EXPECT_TRUE(verdict.free) << i << " " << verdict.sentence;
        }
      }
    } else if (!map.coverage.uncertain && map.coverage.why_not.find("cut off") == std::string::npos) {
      ++refused;
      ASSERT_TRUE(map.coverage.witness) << i;
      EXPECT_FALSE(verdict_at(task, *map.coverage.witness).free) << i << " " << map.coverage.why_not;
      EXPECT_LT(distance(task.region, *map.coverage.witness), 1e-6 * size) << i;
    }
  }
  EXPECT_GT(covered, test::expected(15));
  EXPECT_GT(refused, test::expected(15));
}

// The smallest gap over the region.

TEST(Clearance, IsAttainedAndNoSampleIsBelowIt) {
  Dice dice(77);
  for (int i = 0; i < 20; ++i) {
    MapTask task = with_obstacles(report_task(), dice, 6);
    const double bearing = dice.between(-pi, pi);
    task.region = {{{regular(as_point(std::polar(65.0, bearing)), 6, 7), {}}}};
    const auto clearance = smallest_clearance(task);
    ASSERT_TRUE(clearance);
    EXPECT_LT(distance(task.region, clearance->at), 1e-6);
    task.limits.clearance = clearance->gap - 1e-2;
    for (int sample = 0; sample < 300; ++sample) {
      const Point point =
          as_point(std::polar(65.0, bearing)) + Point(dice.between(-6, 6), dice.between(-6, 6));
      if (!contains(task.region, point)) continue;
      const Verdict verdict = verdict_at(task, point);
      const bool in_contact =
          verdict.cause == Cause::self_contact || verdict.cause == Cause::obstacle_contact;
      EXPECT_FALSE(in_contact) << verdict.sentence;
    }
    task.limits.clearance = clearance->gap + 1e-3;
    EXPECT_FALSE(verdict_at(task, clearance->at).free);
  }
}

// Layers.

TEST(LayerChoice, BestHasTheLargestGapAndTheReasonAgainstFewerIsGiven) {
  MapTask task = report_task();
  task.style.width = 24;  // in two layers VA and B-C would meet over most of the opening
  task.region = {{box(60, -5, 8, 10)}};
  const LayerChoice choice = choose_layers(task, 4);
  EXPECT_EQ(choice.findings.size(), 38u);  // without obstacles only those that leave no layer empty
  for (const LayerFinding& finding : choice.findings)
    EXPECT_LE(finding.gap, choice.findings.front().gap + 1e-9);
  EXPECT_GT(choice.best.highest(), 2);
  ASSERT_FALSE(choice.why_not_fewer.empty());
  EXPECT_NE(choice.why_not_fewer[0].find("2 layers are not enough"), std::string::npos)
      << choice.why_not_fewer[0];
}

TEST(LayerChoice, ObstacleInALayerDrivesTheLinksOutOfIt) {
  MapTask task = report_task();
  task.region = {{box(60, -5, 8, 10)}};
  const LayerChoice free = choose_layers(task, 2);
  task.obstacles = {block(box(30, 20, 2, 2), free.best[Link::VA], free.best[Link::VA])};
  const LayerChoice blocked = choose_layers(task, 2);
  const auto gap = [&](const LayerAssignment& layers) {
    MapTask one = task;
    one.layers = layers;
    return smallest_clearance(one)->gap;
  };
  for (const LayerAssignment& layers : layer_assignments(2)) EXPECT_LE(gap(layers), gap(blocked.best) + 1e-2);
}

TEST(LayerChoice, WhatIsSaidOfFewerLayersIsTrueOfTheirBestAssignment) {
  test::Dice dice(41);
  int asked = 0;
  for (int i = 0; i < 40; ++i) {
    MapTask task = report_task();
    task.region = {{box(60, -5, 8, 10)}};
    for (int obstacle = 0; obstacle < 4; ++obstacle) {
      const double angle = dice.between(0, 2 * pi), away = dice.between(10, 120);
      const int layer = 1 + dice.below(3);
      task.obstacles.push_back(
          block(box(away * std::cos(angle), away * std::sin(angle), 6, 6), layer, layer));
    }
    const LayerChoice choice = choose_layers(task, 4);
    const auto gap = [&](const LayerAssignment& layers) {
      MapTask one = task;
      one.layers = layers;
      return smallest_clearance(one)->gap;
    };
    for (int fewer = 2; fewer < choice.best.highest(); ++fewer) {
      const auto told = std::find_if(choice.findings.begin(), choice.findings.end(),
                                     [&](const LayerFinding& one) { return one.layers.highest() == fewer; });
      ASSERT_NE(told, choice.findings.end());
      for (const LayerAssignment& layers : layer_assignments(fewer))
        if (layers.highest() == fewer && layers.is_stacked()) {
          EXPECT_LE(gap(layers), told->gap + 0.02) << i;
        }
      ++asked;
    }
  }
  EXPECT_GT(asked, 20);
}

TEST(LayerChoice, LinksStandAboveAnEmptyLayerWhereThatHelpsAndItSaysSo) {
  MapTask task{.linkage = *CopyingLinkage::make({-0.5, 0}, Grounding::pole, 37.7, 44.8, 0),
               .style = {15, 6, 4, PlateStyle::bent},
               .layers = {},
               .limits = {.clearance = 1, .transmission = radians(25)},
               .obstacles = {block(box(6, -200, 8, 400), 1, 1), block(box(-14, -200, 8, 400), 1, 1)},
               .region = {{box(62, -28, 56, 56)}}};
  const LayerChoice choice = choose_layers(task, 3);
  EXPECT_FALSE(choice.best.has_links_in(1));
  ASSERT_EQ(choice.why_not_fewer.size(), 2u);
  EXPECT_EQ(choice.why_not_fewer[0].find("2 layers are not enough"), 0u) << choice.why_not_fewer[0];
  EXPECT_EQ(choice.why_not_fewer[1].find("3 layers, none of them empty, are not enough: with the tracer at"),
            0u)
      << choice.why_not_fewer[1];
}

// What people feed in.

TEST(BadInput, ObstacleOverThePoleLosesEverythingAndSaysSo) {
  MapTask task = report_task();
  task.obstacles = {block(box(-2, -2, 4, 4))};
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_EQ(area(map.collision_free), 0);
  EXPECT_FALSE(map.coverage.covered);
  EXPECT_NE(map.coverage.why_not.find("pole post V"), std::string::npos) << map.coverage.why_not;
}

TEST(BadInput, ObstaclesWithoutAreaAreWalls) {
  MapTask task = report_task();
  task.obstacles = {block({{{60, 5}, {70, 5}}, {}})};
  EXPECT_FALSE(verdict_at(task, {65, 4}).free);
  EXPECT_LT(area(map_workspace(task, no_sheets).collision_free), area(free_annulus(task)));
  task.obstacles = {block({{{65, 5}}, {}})};
  EXPECT_FALSE(verdict_at(task, {65, 4}).free);
  task.obstacles = {block({{}, {}})};
  EXPECT_NEAR(area(map_workspace(task, no_sheets).collision_free), area(free_annulus(task)), 1e-6);
}

TEST(BadInput, OverlappingAndSelfCrossingObstaclesCountAsTheirUnion) {
  MapTask task = report_task(), other = task;
  task.obstacles = {block({{{60, 20}, {70, 30}, {70, 20}, {60, 30}}, {}})};  // a bow tie
  other.obstacles = {block({{{60, 20}, {65, 25}, {60, 30}}, {}}),
                     block({{{70, 30}, {65, 25}, {70, 20}}, {}})};
  const WorkspaceMap a = map_workspace(task, no_sheets), b = map_workspace(other, no_sheets);
  EXPECT_NEAR(area(a.collision_free), area(b.collision_free), area(a.uncertain) + area(b.uncertain));
  other.obstacles = {block(box(60, 20, 10, 5)), block(box(62, 22, 10, 5))};
  task.obstacles = {
      block({{{60, 20}, {70, 20}, {70, 22}, {72, 22}, {72, 27}, {62, 27}, {62, 25}, {60, 25}}, {}})};
  const WorkspaceMap c = map_workspace(task, no_sheets), d = map_workspace(other, no_sheets);
  EXPECT_NEAR(area(c.collision_free), area(d.collision_free), area(c.uncertain) + area(d.uncertain));
}

TEST(BadInput, CoordinatesOfAnyMagnitudeAreRightOrUncertain) {
  MapTask task = report_task();
  const double free = area(map_workspace(task, no_sheets).collision_free);
  task.obstacles = {block(box(1e12, 1e12, 1e12, 1e12))};
  EXPECT_EQ(area(map_workspace(task, no_sheets).collision_free), free);
  task.obstacles = {
      block({{{-1e12, 300}, {1e12, 300}, {1e12, 1e12}, {-1e12, 1e12}}, {}})};  // a far half plane
  EXPECT_EQ(area(map_workspace(task, no_sheets).collision_free), free);
  task.obstacles = {block({{{-1e12, 60}, {1e12, 60}, {1e12, 1e12}, {-1e12, 1e12}}, {}})};  // a near one
  const WorkspaceMap map = map_workspace(task, no_sheets);
  EXPECT_LT(area(map.collision_free) + area(map.uncertain), free);
  EXPECT_GT(area(map.collision_free), 0);
  EXPECT_FALSE(verdict_at(task, {0, 65}).free);
  task.obstacles = {block(box(65, 0, 1e-12, 1e-12))};
  EXPECT_FALSE(verdict_at(task, {65, 1}).free);
}

TEST(BadInput, ObstacleOfAMillionCornersIsAsGoodAsItsCircle) {
  MapTask task = report_task(), other = task;
  task.obstacles = {block({regular({100, 0}, 20, 1'000'000), {}})};
  other.obstacles = {block({regular({100, 0}, 20, 720), {}})};
  const WorkspaceMap a = map_workspace(task, no_sheets), b = map_workspace(other, no_sheets);
  EXPECT_NEAR(area(a.collision_free), area(b.collision_free), area(a.uncertain) + area(b.uncertain) + 1);
}

TEST(BadInput, LinksWiderThanTheLinkageLeaveNothingAndSayWhy) {
  MapTask task = report_task();
  task.style.width = 100;
  task.region = {{box(60, -5, 8, 10)}};
  const WorkspaceMap map = map_workspace(task, {});
  EXPECT_TRUE(map.collision_free.empty());
  EXPECT_TRUE(map.certified_opening.empty());
  EXPECT_FALSE(map.coverage.covered);
  EXPECT_EQ(map.coverage.cause, Cause::self_contact);
}

}  // namespace
}  // namespace kempe
