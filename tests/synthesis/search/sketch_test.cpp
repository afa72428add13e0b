// Sketches: designs for specs that differ a little from the last one's.
#include "synthesis/search/sketch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "specs/spec_check.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/steps/local_search.hpp"
#include "synthesis/search/steps/search_task.hpp"
#include "tests/random.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/kept_limits.hpp"
#include "tests/synthesis/shipped_spec.hpp"

namespace kempe {
namespace {

std::optional<FoundDesign> searched(const Spec& spec) {
  SearchOptions options;
  options.diagnose = false;
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  return found ? std::optional(*found) : std::nullopt;
}

void shift(Ring& ring, const Point& by) {
  for (Point& corner : ring) corner += by;
}

/// A spec a little beside this one: a share of it moves by some millimetres, the ratio by some parts of a hundred.
Spec beside(const Spec& spec, std::mt19937_64& random) {
  Spec moved = spec;
  const auto by = [&] { return Point(test::uniform(random, -4, 4), test::uniform(random, -4, 4)); };
  switch (random() % 4) {
    case 0:
      for (Polygon& polygon : moved.region.polygons) {
        const Point way = by();
        shift(polygon.outer, way);
        for (Ring& hole : polygon.holes) shift(hole, way);
      }
      break;
    case 1:
      if (auto* at = std::get_if<Point>(&moved.pole.place)) *at += by();
      break;
    case 2:
      for (Obstacle& obstacle : moved.obstacles) shift(obstacle.shape.outer, by());
      break;
    default:
      moved.copy = Copy::of(spec.copy.scale() * test::uniform(random, 0.97, 1.03),
                            spec.copy.rotation() + test::uniform(random, -2, 2) * degree);
  }
  const auto checked = check_spec(moved);
  return checked ? *checked : spec;
}

// Every limit is looked at by the map, which knows nothing of the search, over all of the region.
TEST(Sketch, KeepsEveryLimit) {
  std::mt19937_64 random(7);
  for (const char* name :
       {"plagiograph", "nameplate", "half-turn", "sixty", "clamped-plate", "pantorouter"}) {
    const Spec spec = test::shipped_spec(name);
    SketchedDesign last = sketch_of(*searched(spec));
    int sketches = 0;
    for (int i = 0; i < test::samples(40); ++i) {
      const Spec moved = beside(spec, random);
      last = sketched(moved, last);
      if (!last.design) continue;
      ++sketches;
      MapOptions options;
      options.largest_sheets = false;
      const auto design = certified_design(moved, *last.design, options);
      ASSERT_TRUE(design) << name << ", step " << i << ": " << design.error();
      EXPECT_EQ(test::first_limit_missed(moved, *design, 1e-9), "") << name << ", step " << i;
      EXPECT_NEAR(design->quality.size, last.design->attained.size, 1e-9 * design->quality.size);
      if (last.bound && moved.objective.objective == Objective::size) {
        EXPECT_LE(*last.bound, last.design->value * (1 + 1e-9)) << name << ", step " << i;
      }
    }
    EXPECT_GE(sketches, test::expected(10)) << name;
  }
}

// Beside what the whole search finds for the same spec, when the hand has rested for a third of a second.
TEST(Sketch, IsNearTheSearchsDesign) {
  int compared = 0, near = 0, missed = 0;
  std::mt19937_64 random(8);
  for (const char* name :
       {"plagiograph", "nameplate", "half-turn", "sixty", "clamped-plate", "pantorouter"}) {
    Spec spec = test::shipped_spec(name);
    SketchedDesign last = sketch_of(*searched(spec));
    for (int i = 0; i < test::samples(10); ++i) {
      spec = beside(spec, random);
      for (int frame = 0; frame < 20; ++frame) last = sketched(spec, last);
      const auto best = searched(spec);
      if (!best) {
        EXPECT_FALSE(last.design) << name << ", step " << i;
        continue;
      }
      ++compared;
      missed += !last.design;
      if (!last.design) continue;
      const double share = last.design->value / best->value - 1;
      near += (is_maximized(best->goal) ? -share : share) <= 0.02;
    }
  }
  if (test::shortened()) return;
  EXPECT_GE(compared, 35);
  EXPECT_LE(missed, compared / 20);
  EXPECT_GE(near, compared - compared / 20) << compared;
}

TEST(Sketch, IsTheSameForTheSameArguments) {
  const Spec spec = test::shipped_spec("clamped-plate");
  std::mt19937_64 random(9);
  const SketchedDesign start = sketch_of(*searched(spec));
  const Spec moved = beside(spec, random);
  const SketchedDesign one = sketched(moved, start), other = sketched(moved, start);
  ASSERT_EQ(one.design.has_value(), other.design.has_value());
  if (one.design) {
    EXPECT_EQ(one.design->value, other.design->value);
    EXPECT_EQ(one.design->linkage.VA(), other.design->linkage.VA());
  }
  EXPECT_EQ(one.bound, other.bound);
}

// A hand that drags a handle into what cannot be, and back.
TEST(Sketch, FindsItsWayBack) {
  const Spec spec = test::shipped_spec("plagiograph");
  SketchedDesign last = sketch_of(*searched(spec));
  const double size = last.design->value;
  Spec impossible = spec;
  impossible.links.longest = spec.links.shortest * 1.01;
  last = sketched(impossible, last);
  EXPECT_FALSE(last.design);
  EXPECT_TRUE(last.proven_none);
  last = sketched(spec, last);
  ASSERT_TRUE(last.design);
  EXPECT_NEAR(last.design->value, size, 1e-6 * size);
}

// The follower's holder, which the tracer carries, would run into the template's holder: the copy decides that, no length does.
TEST(Sketch, EndsWithoutDesignWhereTheCopyDrivesABodyIntoAnObstacle) {
  const Spec spec = test::shipped_spec("pantorouter");
  SketchedDesign last = sketch_of(*searched(spec));
  Spec blocked = spec;
  shift(blocked.region.polygons.front().outer, {-8, 0});
  last = sketched(blocked, last);
  EXPECT_FALSE(last.design);
  EXPECT_FALSE(searched(blocked));
  last = sketched(spec, last);
  EXPECT_TRUE(last.design);
}

// What layers share at a point saves work and changes no figure.
TEST(Sketch, SharedGapsChangeNoMerit) {
  const Spec spec = test::shipped_spec("pantorouter");
  SearchOptions options;
  const SearchTask task = pose(spec, SearchControl(options));
  const std::vector<Subproblem> choices = task.subproblems();
  const auto start = searched(spec);
  const DesignPoint point{{std::log(start->linkage.VA()), std::log(start->linkage.VB())},
                          start->linkage.pole()};
  std::optional<SmallestGaps> shared;
  const Subproblem* first = nullptr;
  for (const Subproblem& sub : choices) {
    if (first == nullptr || !are_alike(*first, sub))
      shared.emplace(sub.problem->gaps_at(point)), first = &sub;
    EXPECT_EQ(merit_at(*sub.problem, point, task.budgets().local, &*shared),
              merit_at(*sub.problem, point, task.budgets().local));
  }
  EXPECT_GT(choices.size(), 100U);
}

TEST(Sketch, LeavesStockLengthsToTheSearch) {
  Spec spec = test::shipped_spec("plagiograph");
  const SketchedDesign start = sketch_of(*searched(spec));
  spec.links.stock_lengths.grid = 5;
  EXPECT_FALSE(sketched(spec, start).design);
}

TEST(Sketch, LeavesRobustDesignsToTheSearch) {
  Spec spec = test::shipped_spec("plagiograph");
  const SketchedDesign start = sketch_of(*searched(spec));
  spec.tolerance = Tolerance{.length = 0.05, .play = 0.05, .robust = true};
  EXPECT_FALSE(sketched(spec, start).design);
}

TEST(Sketch, EndsWhenItIsTold) {
  const Spec spec = test::shipped_spec("clamped-plate");
  const SketchedDesign start = sketch_of(*searched(spec));
  EXPECT_FALSE(sketched(spec, start, {}, [] { return true; }).design);
}

}  // namespace
}  // namespace kempe
