// What search, bound and check assume alike, held against geometry that does not: docs/proven-bound.md lists them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/region_reach.hpp"
#include "geometry/regions/region_algebra.hpp"
#include "synthesis/bound/copy_gap.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "workspace/footprint.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// The six joints V A B C X Y by the definition: A = V + p, X = A + q/s, Y = B + s p.
std::array<Complex, 6> joints(Complex V, Complex p, Complex q, Complex s) {
  return {V, V + p, V + q, V + p + q, V + p + q / s, V + q + s * p};
}

/// Every one of the six ways to give pole, tracer and pen to V, X and Y, as a mechanism with V, p, q and s.
TEST(SharedAssumptions, SixPlacingsArePairsThatExchangePAndQ) {
  test::SpecDice dice(401);
  for (int i = 0; i < test::samples(300); ++i) {
    const Complex k = std::polar(dice.log_uniform(0.1, 10), dice.uniform(-pi, pi));
    const Complex pole(dice.uniform(-50, 50), dice.uniform(-50, 50));
    const Complex reach = std::polar(dice.log_uniform(5, 200), dice.uniform(-pi, pi));
    const std::array<Complex, 3> roles{pole, pole + reach, pole + k * reach};  // pole, tracer, pen
    std::array<std::size_t, 3> at_V_X_Y{0, 1, 2};
    do {
      const Complex V = roles[at_V_X_Y[0]], X = roles[at_V_X_Y[1]], Y = roles[at_V_X_Y[2]];
      const Complex s = (Y - V) / (X - V);
      const Complex p = std::polar(dice.log_uniform(5, 200), dice.uniform(-pi, pi));
      const Complex q = s * (X - V - p);
      const auto here = joints(V, p, q, s);
      EXPECT_LT(std::abs(here[4] - X) + std::abs(here[5] - Y),
                1e-9 * (std::abs(reach) + std::abs(p)) * (1 + std::abs(s)) * (1 + 1 / std::abs(s)));
      // The other way round: q first, 1/s, and X and Y change places; A and B, too.
      const auto other = joints(V, q, p, 1.0 / s);
      const std::array<std::size_t, 6> same{0, 2, 1, 3, 5, 4};
      for (std::size_t joint = 0; joint < 6; ++joint)
        EXPECT_LT(std::abs(here[joint] - other[same[joint]]),
                  1e-9 * (std::abs(p) + std::abs(q)) * (1 + std::abs(s)) * (1 + 1 / std::abs(s)));
      // One of both has the roles in one of the program's three orders.
      const std::size_t pole_at =
          static_cast<std::size_t>(std::find(at_V_X_Y.begin(), at_V_X_Y.end(), 0) - at_V_X_Y.begin());
      const bool is_ours = at_V_X_Y == std::array<std::size_t, 3>{0, 1, 2} ||
                           at_V_X_Y == std::array<std::size_t, 3>{1, 0, 2} ||
                           at_V_X_Y == std::array<std::size_t, 3>{2, 0, 1};
      const std::array<std::size_t, 3> exchanged{at_V_X_Y[0], at_V_X_Y[2], at_V_X_Y[1]};
      const bool is_theirs = exchanged == std::array<std::size_t, 3>{0, 1, 2} ||
                             exchanged == std::array<std::size_t, 3>{1, 0, 2} ||
                             exchanged == std::array<std::size_t, 3>{2, 0, 1};
      EXPECT_NE(is_ours, is_theirs) << pole_at;
      // The program's shape for it.
      const std::array<std::size_t, 3>& order = is_ours ? at_V_X_Y : exchanged;
      const Grounding grounding = order[0] == 0   ? Grounding::pole
                                  : order[0] == 1 ? Grounding::tracer
                                                  : Grounding::pen;
      EXPECT_LT(std::abs(shape_of(k, grounding) - (is_ours ? s : 1.0 / s)),
                1e-9 * (1 + std::abs(s) + 1 / std::abs(s)));
    } while (std::next_permutation(at_V_X_Y.begin(), at_V_X_Y.end()));
  }
}

/// A straight linkage, both assemblies.
struct Twins {
  CopyingLinkage one, other;
};
Twins straight_twins(test::SpecDice& dice) {
  while (true) {
    const Complex k(dice.log_uniform(0.2, 5) * (dice.one_in(2) ? -1 : 1), 0);
    if (std::abs(k - 1.0) < 0.1) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(dice.uniform(0, 2.999))];
    const double VA = dice.uniform(30, 120);
    const double VB = dice.uniform(30, 120);
    return {*CopyingLinkage::make(k, grounding, VA, VB, 0), *CopyingLinkage::make(k, grounding, VA, VB, 1)};
  }
}

TEST(SharedAssumptions, TheOtherAssemblyOfAStraightLinkageIsItsMirrorImage) {
  test::SpecDice dice(409);
  int places = 0;
  for (int i = 0; i < test::samples(200); ++i) {
    const Twins twins = straight_twins(dice);
    ASSERT_EQ(assembly_modes(twins.one.shape()).size(), 2u);
    for (int j = 0; j < 20; ++j) {
      const double away = dice.uniform(5, 250);
      const Point tracer = as_point(std::polar(away, dice.uniform(-pi, pi)));
      const auto one = twins.one.pose_with_tracer_at(tracer), other = twins.other.pose_with_tracer_at(tracer);
      ASSERT_EQ(one.has_value(), other.has_value());
      if (!one) continue;
      ++places;
      const Complex along = as_complex(tracer) / away;
      for (const Joint joint : {Joint::V, Joint::A, Joint::B, Joint::C, Joint::X, Joint::Y}) {
        const Complex mirrored = along * std::conj(as_complex((*one)[joint]) / along);
        EXPECT_LT(std::abs(mirrored - as_complex((*other)[joint])), 1e-7 * twins.one.size());
      }
    }
    const auto tolerance = CopyTolerance::uniform({.length = 0.1, .play = 0.05});
    const Point centre = as_point(std::polar(dice.uniform(40, 120), dice.uniform(-pi, pi)));
    const Region region{{dice.star(centre, 15, 5)}};
    const auto error = copy_error_over(twins.one, tolerance, region);
    const auto other_error = copy_error_over(twins.other, tolerance, region);
    ASSERT_EQ(error.has_value(), other_error.has_value());
    if (error) {
      EXPECT_NEAR(error->worst, other_error->worst, 1e-6 * error->worst);
    }
  }
  EXPECT_GT(places, test::expected(1000));
}

/// The mirror images of poses about different lines are no mirror image of what they sweep.
TEST(SharedAssumptions, OnlyItsFootprintDiffersAndTheSearchLooksAtBoth) {
  test::SpecDice dice(419);
  int differ = 0;
  for (int i = 0; i < test::samples(6); ++i) {
    Spec spec = dice.spec();
    spec.copy = Copy::of(dice.log_uniform(0.3, 3), pi);
    spec.pole.place = Point(Point::Zero());
    spec.objective.objective = Objective::footprint;
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto* found = std::get_if<FoundDesign>(&outcome);
    if (!found) continue;
    const CopyingLinkage& linkage = found->linkage;
    const auto twin = CopyingLinkage::make(linkage.k(), linkage.grounding(), linkage.VA(), linkage.VB(),
                                           1 - linkage.assembly_mode().number, linkage.pole());
    ASSERT_TRUE(twin);
    const double area = footprint(*twin, spec.links.style, spec.region).area;
    differ += std::abs(area - found->value) > 1e-4 * area;
    EXPECT_LE(found->value, area * (1 + 5e-3)) << i;  // an estimate steers the search: docs/search.md
  }
  EXPECT_GT(differ, test::expected(0));
}

/// Regions of all kinds: beside the pole, around it, with the pole in a hole, islands.
Region any_region(test::SpecDice& dice, int kind) {
  const Point centre = as_point(std::polar(dice.uniform(60, 120), dice.uniform(-pi, pi)));
  const double radius = dice.uniform(10, 50);
  if (kind == 0) return {{dice.star(centre, radius, 9)}};
  if (kind == 1) return {{dice.star(centre, radius / 3, 7), dice.star(-1.5 * centre, radius / 3, 5)}};
  Polygon ring = dice.star(Point::Zero(), radius + 60, 24);
  Ring hole;
  const double inner = dice.uniform(2, 12);
  for (int i = 0; i < 12; ++i) hole.push_back(as_point(std::polar(inner, -2 * pi * i / 12)));
  ring.holes.push_back(hole);
  return {{ring}};
}

TEST(SharedAssumptions, NearestAndFarthestPlaceSayWhatOpeningsARegionNeeds) {
  test::SpecDice dice(421);
  int seen = 0;
  for (int i = 0; i < test::samples(150); ++i) {
    const Region region = any_region(dice, i % 3);
    const RegionReach reach(region);
    const DistanceRange range = reach.range(Point::Zero());
    const Complex k = std::polar(dice.log_uniform(0.3, 3), dice.uniform(-pi, pi));
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const double VA = dice.uniform(30, 150);
    const double VB = dice.uniform(30, 150);
    const auto linkage = CopyingLinkage::make(
        k, grounding, VA, VB, i % static_cast<int>(assembly_modes(shape_of(k, grounding)).size()),
        Point::Zero());
    if (!linkage) continue;
    const auto needed = openings_over(*linkage, region);
    double least = 1e300, most = 0;
    bool all_reached = true;
    const Box box = bounding_box(region);
    for (int j = 0; j < 4000; ++j) {
      const double x = dice.uniform(box.lower.x(), box.upper.x());
      const double y = dice.uniform(box.lower.y(), box.upper.y());
      const Point place(x, y);
      if (!contains(region, place)) continue;
      least = std::min(least, place.norm());
      most = std::max(most, place.norm());
      EXPECT_GE(place.norm(), range.nearest * (1 - 1e-12));
      EXPECT_LE(place.norm(), range.farthest * (1 + 1e-12));
      const auto pose = linkage->pose_with_tracer_at(place);
      all_reached = all_reached && pose.has_value();
      if (pose && needed) {
        const double opening = linkage->opening_at(place.norm()).value();
        EXPECT_TRUE(opening >= needed->lower - 1e-9 && opening <= needed->upper + 1e-9);
        ++seen;
      }
    }
    EXPECT_NEAR(least, range.nearest, 0.1 * range.farthest);
    EXPECT_NEAR(most, range.farthest, 0.1 * range.farthest);
    if (needed) {
      EXPECT_TRUE(all_reached) << i;
    }
  }
  EXPECT_GT(seen, test::expected(2000));
}

TEST(SharedAssumptions, SheetsSaidToBeTooNearForABoxOfPolesAreTooNearForEach) {
  test::SpecDice dice(431);
  int too_near = 0;
  for (int i = 0; i < test::samples(200); ++i) {
    Spec spec;
    spec.region = any_region(dice, i % 3);
    const double scale = dice.log_uniform(0.3, 3);
    spec.copy = Copy::of(scale, dice.uniform(-pi, pi));
    spec.limits.copy_gap = dice.uniform(0, 20);
    const RegionReach reach(spec.region);
    const bounding::CopyGap sheets(spec, reach);
    for (int j = 0; j < 10; ++j) {
      const Point pole = as_point(std::polar(dice.uniform(0, 200), dice.uniform(-pi, pi)));
      const double radius = dice.log_uniform(0.1, 20);
      if (sheets.verdict(pole, radius) != bounding::CopyGap::Verdict::too_near) continue;
      ++too_near;
      const Point one = pole + as_point(std::polar(radius * dice.uniform(0, 1), dice.uniform(-pi, pi)));
      EXPECT_FALSE(
          are_apart(spec.region, similar_image(spec.region, spec.copy.k(), one), *spec.limits.copy_gap))
          << i << " " << j;
    }
  }
  EXPECT_GT(too_near, test::expected(100));
}

}  // namespace
}  // namespace kempe
