// The map and the smallest gap against dense independent sampling: a million tracer places a case, ten cases of 0 to 50
// obstacles.

#include <gtest/gtest.h>

#include <ostream>

#include "tests/geometry/grid_outlines.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "tests/workspace/sampled_mechanism.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::Dice;

Obstacle star(Dice& dice, const Point& centre, double size, int corners) {
  Obstacle obstacle;
  for (int i = 0; i < corners; ++i)
    obstacle.shape.outer.push_back(centre +
                                   as_point(std::polar(size * dice.between(0.5, 1), 2 * pi * i / corners)));
  obstacle.lowest_layer = 1 + dice.below(2);
  obstacle.highest_layer = obstacle.lowest_layer + dice.below(3);
  return obstacle;
}

struct Case {
  int obstacles, corners;
  Complex k;
  Grounding grounding;
  double VA, VB;
  int assembly_mode;
  PlateStyle plate;
  int layers;  ///< index of the assignment
};

/// For the test's name, which would show the bytes.
void PrintTo(const Case& one, std::ostream* out) {
  *out << one.obstacles << " obstacles of " << one.corners << " corners";
}

class MapSampling : public testing::TestWithParam<Case> {};

MapTask task_of(const Case& one) {
  Dice dice(static_cast<std::uint64_t>(100 + one.obstacles));
  const CopyingLinkage linkage =
      *CopyingLinkage::make(one.k, one.grounding, one.VA, one.VB, one.assembly_mode, Point(12, -7));
  MapTask task{linkage,
               {6, 3, 4, one.plate},
               layer_assignments(4)[static_cast<std::size_t>(one.layers)],
               {.clearance = 0.5, .transmission = radians(20)}};
  const double reach = reachable_annulus(linkage).outer;
  for (int i = 0; i < one.obstacles; ++i) {
    const Point centre =
        linkage.pole() + as_point(std::polar(reach * dice.between(0.45, 1.6), dice.between(-pi, pi)));
    task.obstacles.push_back(
        star(dice, centre, dice.between(1, 12) / std::sqrt(1 + 0.3 * one.obstacles), one.corners));
    if (i % 3 != 1) continue;
    std::mt19937_64 random(static_cast<std::uint64_t>(i));
    task.obstacles.back().shape = {test::grid_polygon_about(random, centre, 8).outer, {}};
  }
  return task;
}

TEST_P(MapSampling, NoFreePolygonHoldsAContactAndTheAreasAgree) {
  const MapTask task = task_of(GetParam());
  const WorkspaceMap map = map_workspace(task, {.largest_sheets = false});
  const test::Locator free(map.collision_free, 1e-4, Flatten::shrinks);
  std::vector<test::Locator> lost;
  for (const LostArea& one : map.lost) lost.emplace_back(one.area, 1e-4, Flatten::shrinks);
  const auto obstacles = test::blocks(task.obstacles);
  const Annulus reach = reachable_annulus(task.linkage);
  Dice dice(77);
  constexpr int samples = 1'000'000;
  int truly_free = 0, wrongly_free = 0, wrongly_lost = 0;
  for (int i = 0; i < samples; ++i) {
    const double radius = std::sqrt(dice.between(reach.inner * reach.inner, reach.outer * reach.outer));
    const test::Z tracer = test::Z(12, -7) + std::polar(radius, dice.between(-pi, pi));
    const auto joints = test::joints_with_tracer_at(task.linkage, tracer);
    ASSERT_TRUE(joints);
    const double opening = std::arg((joints->B - joints->V) / (joints->A - joints->V));
    bool is_free = std::sin(radians(20)) <= std::abs(std::sin(opening)) &&
                   std::sin(radians(20)) <= std::abs(std::sin(opening - std::arg(task.linkage.shape())));
    double gap = 1e300;
    if (is_free) {
      const auto solids = test::solids(task.linkage, *joints, task.style, task.layers);
      gap = test::self_gap(solids);
      if (gap >= task.limits.clearance)
        gap = std::min(gap, test::obstacle_gap(solids, obstacles, task.limits.clearance));
      is_free = gap >= task.limits.clearance;
    }
    truly_free += is_free;
    if (!is_free && gap < task.limits.clearance - 1e-9) wrongly_free += free.contains(tracer);
    if (is_free && gap > task.limits.clearance + 1e-9)
      for (const test::Locator& one : lost) wrongly_lost += one.contains(tracer);
  }
  EXPECT_EQ(wrongly_free, 0);
  EXPECT_EQ(wrongly_lost, 0);
  const double share = static_cast<double>(truly_free) / samples;
  const double truth = share * area(reach);
  const double chance = 3 * std::sqrt(share * (1 - share) / samples) * area(reach);
  EXPECT_NEAR(area(map.collision_free), truth, 0.005 * truth + chance);
  EXPECT_LT(area(map.uncertain), 0.01 * truth + 1e-9);
  EXPECT_GT(truth, 0.02 * area(reach)) << "a case without free area proves little";
  double all = area(map.collision_free) + area(map.uncertain);
  for (const LostArea& one : map.lost)
    if (one.cause != Cause::out_of_reach && one.cause != Cause::beyond_change_point) all += area(one.area);
  EXPECT_NEAR(all, area(reach), 1e-5 * area(reach)) << "the parts of the map tile the reach";
}

INSTANTIATE_TEST_SUITE_P(
    TenCases, MapSampling,
    testing::Values(Case{0, 0, {0, 1.4}, Grounding::pole, 50, 35, 2, PlateStyle::bent, 0},
                    Case{1, 4, {0, 1.4}, Grounding::pen, 50, 60, 3, PlateStyle::bent, 0},
                    Case{2, 20, {2.5, 0}, Grounding::tracer, 60, 55, 1, PlateStyle::triangle, 1},
                    Case{3, 7, {-0.5, 0}, Grounding::pole, 60, 35, 1, PlateStyle::bent, 0},
                    Case{5, 20, {0.5, 0.8}, Grounding::pen, 50, 70, 0, PlateStyle::triangle, 8},
                    Case{8, 20, {0, 1.4}, Grounding::tracer, 50, 90, 0, PlateStyle::bent, 1},
                    Case{12, 20, {0.5, 0}, Grounding::pen, 70, 60, 1, PlateStyle::bent, 0},
                    Case{20, 20, {0, 1.4}, Grounding::pole, 50, 35, 2, PlateStyle::bent, 20},
                    Case{
                        35, 20, {0.5, 0.8660254037844386}, Grounding::tracer, 80, 80, 2, PlateStyle::bent, 0},
                    Case{50, 20, {0, 1.4}, Grounding::pole, 50, 35, 2, PlateStyle::triangle, 0}),
    [](const auto& one) { return std::to_string(one.param.obstacles) + "Obstacles"; });

/// Places of a disc, its outline dense.
std::vector<test::Z> places_of_disc(test::Z centre, double radius) {
  std::vector<test::Z> places{centre};
  for (int ring = 1; ring <= 6; ++ring)
    for (int i = 0; i < 60 * ring; ++i)
      places.push_back(centre + std::polar(radius * ring / 6, 2 * pi * i / (60 * ring)));
  return places;
}

TEST(ClearanceSampling, FigureIsThatOfThePlainGapsWhereverTheObstaclesStand) {
  Dice dice(31);
  int obstacles_decide = 0;
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle thin{1, 0.5, 4, dice.below(2) == 0 ? PlateStyle::bent : PlateStyle::triangle};
    MapTask task{linkage, thin, test::random_layers(dice), {.clearance = 0.5, .transmission = 0}};
    const Annulus reach = reachable_annulus(linkage);
    const double out = reach.outer, radius = linkage.radius_at(linkage.assembly_mode().openings.middle());
    const test::Z centre = as_complex(linkage.pole()) + std::polar(radius, dice.between(-pi, pi));
    const double size = 0.4 * std::min(radius - reach.inner, reach.outer - radius);
    Ring disc;
    for (int corner = 0; corner < 360; ++corner)
      disc.push_back(as_point(centre + std::polar(size, pi * corner / 180)));
    task.region = {{{disc, {}}}};
    for (int count = 1 + i % 3; count > 0; --count) {
      const test::Z away = std::polar(out * dice.between(0.4, 2), dice.between(-pi, pi));
      task.obstacles.push_back(star(dice, as_point(as_complex(linkage.pole()) + away), 0.1 * out, 8));
    }
    double plain = 1e300, own = 1e300;
    const std::vector<test::Block> blocked = test::blocks(task.obstacles);
    for (const test::Z place : places_of_disc(centre, size)) {
      const auto joints = test::joints_with_tracer_at(linkage, place);
      ASSERT_TRUE(joints);
      const std::vector<test::Solid> all = test::solids(linkage, *joints, task.style, task.layers);
      own = std::min(own, test::self_gap(all));
      plain = std::min({plain, own, test::obstacle_gap(all, blocked, 1e300)});
    }
    if (plain < 0) continue;  // how deep parts overlap is not measured
    const auto figure = smallest_clearance(task);
    ASSERT_TRUE(figure);
    EXPECT_LE(figure->gap, plain + 1e-2) << figure->parts;
    EXPECT_GE(figure->gap, plain - 1e-3 * out) << figure->parts;  // as dense as the places are
    obstacles_decide += plain < own;
  }
  EXPECT_GT(obstacles_decide, 20);
}

}  // namespace
}  // namespace kempe
