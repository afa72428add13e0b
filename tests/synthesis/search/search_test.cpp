// What synthesize() promises: limits kept, nothing better left lying about, the same bytes for any number of threads.
#include "synthesis/search/search.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "tests/synthesis/shipped_spec.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/footprint.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

SearchOptions quick(int threads = 1) {
  SearchOptions options;
  options.threads = threads;
  options.diagnose = false;
  return options;
}

std::optional<FoundDesign> found_for(const Spec& spec, int threads = 1) {
  const SearchOutcome outcome = synthesize(spec, quick(threads));
  const auto* design = std::get_if<FoundDesign>(&outcome);
  return design ? std::optional(*design) : std::nullopt;
}

Design assembled(const Spec& spec, const FoundDesign& found) {
  MapOptions map;
  map.largest_sheets = false;
  return assemble_design(spec, found, map);
}

/// Every limit but obstacles, in steps of the opening: no formula of the search.
bool keeps_limits(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers) {
  const double pin = spec.links.style.pin_diameter;
  for (const double length : linkage.lengths().values())
    if (length < spec.links.shortest || length < 1.1 * pin || length > spec.links.longest) return false;
  const auto needed = openings_over(linkage, spec.region);
  if (!needed) return false;
  for (int i = 0; i <= 40; ++i)
    if (linkage.transmission_angle(needed->lower + i / 40.0 * (needed->upper - needed->lower)) <
        spec.limits.transmission)
      return false;
  return smallest_gap_over(linkage, spec.links.style, layers, *needed).gap >= spec.limits.clearance;
}

/// Joints of one link by the places of the joints: what the drawing will have, straight plates or bent.
double nearest_joints_of_a_link(const CopyingLinkage& linkage, double opening) {
  const Pose pose = linkage.pose_at(opening, 0);
  double nearest = 1e300;
  for (const std::string_view link : {"VA", "VB", "ACX", "BCY"})
    for (std::size_t i = 0; i < link.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Point one = Point::Zero(), other = Point::Zero();
        for (const Joint joint : all_joints) {
          if (letter(joint) == link[i]) one = pose[joint];
          if (letter(joint) == link[j]) other = pose[joint];
        }
        nearest = std::min(nearest, (one - other).norm());
      }
  return nearest;
}

TEST(Search, HolesOfALinkKeepAWallBetweenThem) {
  test::SpecDice dice(17);
  int designs = 0, held_apart = 0;
  for (int i = 0; i < test::samples(30); ++i) {
    Spec spec = dice.spec();
    spec.links.shortest = 0.01;
    spec.links.style.pin_diameter = spec.links.style.width * dice.uniform(0.6, 1);
    if (dice.one_in(3)) spec.copy = Copy::of(spec.copy.scale(), dice.one_in(2) ? pi : 0);
    if (dice.one_in(2)) spec.links.wall = dice.log_uniform(0.01, 20);
    if (dice.one_in(3)) spec.cutting.hole_fit = dice.uniform(-0.5, 2);
    if (dice.one_in(3))
      spec.objective.objective = dice.one_in(2) ? Objective::footprint : Objective::transmission;
    const auto found = found_for(spec);
    if (!found) continue;
    ++designs;
    const double pin = spec.links.style.pin_diameter, hole = pin + spec.cutting.hole_fit;
    const double least = std::max(pin, hole) + (spec.links.wall ? *spec.links.wall : pin / 10);
    const double nearest = nearest_joints_of_a_link(found->linkage, found->opening.middle());
    EXPECT_GE(nearest, least * (1 - 1e-9)) << i;
    if (nearest < least * (1 + 1e-6)) ++held_apart;
    if (found->proven_bound && spec.objective.objective == Objective::size) {
      EXPECT_GE(found->value, *found->proven_bound * (1 - 1e-9)) << i;
    }
  }
  EXPECT_GT(designs, test::expected(15));
  EXPECT_GT(held_apart, test::expected(2));  // the wall is what holds them apart, or the test says nothing
}

TEST(Search, AThickerWallBeatsNoBoundOfAThinOneAndOneWithinShortestChangesNothing) {
  test::SpecDice dice(23);
  for (int i = 0; i < test::samples(20); ++i) {
    Spec spec = dice.spec();
    spec.pole.place = Point(Point::Zero());
    const double room = spec.links.shortest - spec.links.style.pin_diameter;
    spec.links.wall = std::max(1e-6, room);
    const auto before = found_for(spec);
    if (room > 1e-6) {
      spec.links.wall = 1e-6;
      const auto thin = found_for(spec);
      ASSERT_EQ(thin.has_value(), before.has_value());
      if (thin) {
        EXPECT_EQ(thin->value, before->value) << i;
      }
    }
    spec.links.wall = std::max(1e-6, room) + 5;
    const auto thick = found_for(spec);
    if (thick && before && before->proven_bound) {
      EXPECT_GE(thick->value, *before->proven_bound * (1 - 1e-9)) << i;
    }
  }
}

TEST(Search, DesignsOfRandomSpecsAreVerifiedAndAboveTheirBound) {
  test::SpecDice dice(5);
  int designs = 0;
  for (int i = 0; i < test::samples(60); ++i) {
    Spec spec = dice.spec();
    if (dice.one_in(3)) spec.objective.objective = Objective::transmission;
    if (dice.one_in(4)) spec.limits.copy_gap = dice.uniform(0, 10);
    const auto found = found_for(spec);
    if (!found) continue;
    ++designs;
    EXPECT_TRUE(keeps_limits(spec, found->linkage, found->layers)) << i;
    const Design design = assembled(spec, *found);
    EXPECT_TRUE(design.map.coverage.covered) << i << design.map.coverage.why_not;
    const Verification verified = verify(verification_task(design));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
    if (!design.quality.proven_bound) continue;
    if (is_maximized(spec.objective.objective))
      EXPECT_LE(found->value, *design.quality.proven_bound) << i;
    else
      EXPECT_GE(found->value, *design.quality.proven_bound) << i;
  }
  EXPECT_GT(designs, test::expected(30));
}

/// A search that may hardly look anywhere.
SearchOptions hurried() {
  SearchOptions options = quick();
  SearchBudgets& budgets = options.budgets;
  budgets.group = 1;
  for (ChoiceBudget* one : {&budgets.choice.relaxed_fixed_pole, &budgets.choice.relaxed_free_pole,
                            &budgets.choice.fixed_pole, &budgets.choice.free_pole})
    *one = {.poles = 1, .lattice = 2, .evaluations = 4, .starts = 1, .starts_if_none = 1};
  budgets.choice.under_load.starts_if_none = 1;
  budgets.proof.boxes = 1;
  budgets.improve.hops = budgets.improve.searches = 0;
  return options;
}

TEST(Search, LittleWorkMissesNoLimitAndBeatsNoBound) {
  test::SpecDice dice(41);
  int designs = 0;
  std::uint64_t little = 0, usual = 0;
  for (int i = 0; i < test::samples(30); ++i) {
    const Spec spec = dice.spec();
    const SearchOutcome outcome = synthesize(spec, hurried());
    const auto* found = std::get_if<FoundDesign>(&outcome);
    const auto best = found_for(spec);
    if (!found || !best) continue;
    ++designs;
    little += found->evaluations;
    usual += best->evaluations;
    EXPECT_TRUE(keeps_limits(spec, found->linkage, found->layers)) << i;
    if (best->proven_bound) {
      EXPECT_GE(found->value, *best->proven_bound * (1 - 1e-9)) << i;
    }
  }
  EXPECT_GT(designs, test::expected(10));
  EXPECT_LE(5 * little, usual);
}

/// Thousands of pairs of lengths with every grounding and assembly.
TEST(Search, NoRandomPairOfLengthsIsBetter) {
  test::SpecDice dice(17);
  int compared = 0;
  for (int i = 0; i < test::samples(16); ++i) {
    Spec spec = dice.spec();
    spec.pole.place = Point(Point::Zero());
    const auto found = found_for(spec);
    double best = 1e300;
    for (const Grounding grounding : all_groundings)
      for (int assembly_mode = 0;
           assembly_mode < static_cast<int>(assembly_modes(shape_of(spec.copy.k(), grounding)).size());
           ++assembly_mode)
        for (int j = 0; j < 3000; ++j) {
          const double VA = dice.log_uniform(5, 3000), VB = dice.log_uniform(5, 3000);
          const auto linkage =
              CopyingLinkage::make(spec.copy.k(), grounding, VA, VB, assembly_mode, Point::Zero());
          if (!linkage || linkage->size() >= best) continue;
          for (const LayerAssignment& layers : layer_assignments(spec.links.layers))
            if (keeps_limits(spec, *linkage, layers)) {
              best = linkage->size();
              break;
            }
        }
    if (best > 1e299) continue;
    ++compared;
    ASSERT_TRUE(found) << "case " << i << " has a design of size " << best;
    EXPECT_LE(found->value, best * (1 + 1e-9)) << i;
  }
  EXPECT_GT(compared, test::expected(8));
}

TEST(Search, IsTheSameForAnyNumberOfThreads) {
  test::SpecDice dice(23);
  std::vector<Spec> specs{test::shipped_spec("sixty"), test::shipped_spec("clamped-plate")};
  for (int i = 0; i < 6; ++i) specs.push_back(dice.spec());
  for (const Spec& spec : specs) {
    const auto one = found_for(spec, 1), two = found_for(spec, 2), seven = found_for(spec, 7);
    ASSERT_EQ(one.has_value(), two.has_value());
    ASSERT_EQ(one.has_value(), seven.has_value());
    if (!one) continue;
    for (const auto& other : {*two, *seven}) {
      EXPECT_EQ(one->linkage.VA(), other.linkage.VA());
      EXPECT_EQ(one->linkage.VB(), other.linkage.VB());
      EXPECT_EQ(one->linkage.pole(), other.linkage.pole());
      EXPECT_EQ(one->evaluations, other.evaluations);
      EXPECT_TRUE(one->layers.of == other.layers.of);
    }
  }
}

TEST(Search, GoesRoundObstacles) {
  test::SpecDice dice(31);
  int designs = 0, moved = 0;
  for (int i = 0; i < test::samples(24); ++i) {
    Spec spec = dice.spec();
    const auto without = found_for(spec);
    for (int j = 0; j < 3; ++j) spec.obstacles.push_back(dice.obstacle_beside(spec));
    const auto found = found_for(spec);
    if (!found) continue;
    ++designs;
    ASSERT_TRUE(without);
    EXPECT_GE(found->value, without->value * (1 - 1e-9)) << "fewer obstacles cannot cost more";
    moved += found->value > without->value * (1 + 1e-6);
    const Design design = assembled(spec, *found);
    EXPECT_TRUE(design.map.coverage.covered) << i << design.map.coverage.why_not;
    EXPECT_GE(design.quality.clearance_min, spec.limits.clearance);
    const Verification verified = verify(verification_task(design));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
  }
  EXPECT_GT(designs, test::expected(10));
  EXPECT_GT(moved, test::expected(2)) << "no obstacle was ever in the way";
}

/// A post between pole and original: the best designs swing past it with a plate's side, all along a curve of tracer places.
TEST(Search, GoesRoundAPostBesideThePole) {
  Spec spec = test::shipped_spec("plagiograph");
  Obstacle post{.shape = Region::circle({21, 3}, 8).polygons.front()};
  post.highest_layer = 8;  // all of them
  spec.obstacles.push_back(post);
  const auto found = found_for(spec);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->complete);
  EXPECT_LT(found->evaluations, 100'000U);
  EXPECT_TRUE(assembled(spec, *found).map.coverage.covered);
}

double boundary_distance(const Region& one, const Region& other) {
  double least = 1e300;
  const auto walk = [](const Ring& ring) {
    std::vector<Point> places;
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (int j = 0; j < 60; ++j)
        places.push_back(ring[i] + (ring[(i + 1) % ring.size()] - ring[i]) * j / 60);
    return places;
  };
  for (const Point& a : walk(one.polygons[0].outer))
    for (const Point& b : walk(other.polygons[0].outer)) least = std::min(least, (a - b).norm());
  return least;
}

TEST(Search, KeepsTheSheetsApart) {
  test::SpecDice dice(37);
  int designs = 0;
  for (int i = 0; i < test::samples(20); ++i) {
    Spec spec = dice.spec();
    spec.limits.copy_gap = dice.uniform(1, 15);
    const auto found = found_for(spec);
    if (!found) continue;
    ++designs;
    const Region copy = similar_image(spec.region, spec.copy.k(), found->linkage.pole());
    EXPECT_GE(boundary_distance(spec.region, copy), *spec.limits.copy_gap * (1 - 1e-9));
    EXPECT_FALSE(contains(spec.region, copy.polygons[0].outer[0]));
    EXPECT_FALSE(contains(copy, spec.region.polygons[0].outer[0]));
  }
  EXPECT_GT(designs, test::expected(5));
}

TEST(Search, MakesTheCopyErrorSmall) {
  test::SpecDice dice(41);
  int compared = 0;
  for (int i = 0; i < test::samples(12); ++i) {
    Spec spec = dice.spec();
    spec.tolerance = Tolerance{0.05, 0.02};
    const auto small = found_for(spec);
    spec.objective.objective = Objective::copy_error;
    const auto accurate = found_for(spec);
    ASSERT_EQ(small.has_value(), accurate.has_value());
    if (!small) continue;
    ++compared;
    const CopyTolerance tolerance = CopyTolerance::uniform(*spec.tolerance);
    const double of_small = copy_error_over(small->linkage, tolerance, spec.region)->worst;
    const double of_accurate = copy_error_over(accurate->linkage, tolerance, spec.region)->worst;
    EXPECT_LE(of_accurate, of_small * (1 + 1e-9));
    EXPECT_NEAR(accurate->value, of_accurate, 1e-9 * of_accurate);
    // A limit between the two makes the small design a little larger, not smaller.
    spec.objective.objective = Objective::size;
    spec.limits.copy_error = 0.5 * (of_small + of_accurate);
    const auto limited = found_for(spec);
    ASSERT_TRUE(limited);
    EXPECT_LE(copy_error_over(limited->linkage, tolerance, spec.region)->worst,
              *spec.limits.copy_error * (1 + 1e-9));
    EXPECT_GE(limited->value, small->value * (1 - 1e-9));
  }
  EXPECT_GT(compared, test::expected(5));
}

TEST(Search, MakesTheFootprintSmall) {
  test::SpecDice dice(43);
  std::vector<Spec> specs{test::shipped_spec("plagiograph")};
  for (int i = 0; i < test::samples(6); ++i) {
    specs.push_back(dice.spec());
    specs.back().pole.place = Point(Point::Zero());
  }
  int compared = 0;
  for (Spec& spec : specs) {
    const auto small = found_for(spec);
    if (!small) continue;
    spec.objective.objective = Objective::footprint;
    const auto found = found_for(spec);
    ASSERT_TRUE(found);
    ++compared;
    const auto area = [&](const CopyingLinkage& linkage) {
      return footprint(linkage, spec.links.style, spec.region).area;
    };
    EXPECT_LE(found->value, area(small->linkage) * 1.005);
    EXPECT_NEAR(found->value, area(found->linkage), 1e-9 * found->value);
    EXPECT_TRUE(keeps_limits(spec, found->linkage, found->layers));
  }
  EXPECT_GE(compared, 1 + test::expected(3));
}

TEST(Search, ContradictoryLimitsAreProvenToHaveNoDesign) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.limits.transmission = radians(80);
  const SearchOutcome outcome = synthesize(spec, quick());
  const auto* none = std::get_if<NoDesign>(&outcome);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->proven);
}

TEST(Search, StopsAtOnceAndSaysSo) {
  const std::atomic<bool> stop{true};
  SearchOptions options = quick();
  options.stop = &stop;
  Spec spec = test::shipped_spec("clamped-plate");
  const SearchOutcome outcome = synthesize(spec, options);
  if (const auto* design = std::get_if<FoundDesign>(&outcome))
    EXPECT_FALSE(design->complete);
  else
    EXPECT_TRUE(std::holds_alternative<Stopped>(outcome));
}

}  // namespace
}  // namespace kempe
