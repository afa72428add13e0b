#include "synthesis/problem/local_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

/// On a grid on which a shift by whole millimetres up to 1e7 is exact.
Point on_grid(const Point& point) { return Point((point * 0x1p20).array().round()) * 0x1p-20; }

void put_on_grid(Region& region) {
  for (Polygon& polygon : region.polygons)
    for (Point& corner : polygon.outer) corner = on_grid(corner);
}

Spec spec_on_grid(test::SpecDice& dice, bool with_obstacle) {
  Spec spec = dice.spec();
  if (with_obstacle) spec.obstacles.push_back(dice.obstacle_beside(spec));
  put_on_grid(spec.region);
  if (!spec.pole.is_fixed()) put_on_grid(std::get<Region>(spec.pole.place));
  for (Obstacle& obstacle : spec.obstacles)
    for (Point& corner : obstacle.shape.outer) corner = on_grid(corner);
  return spec;
}

Point whole_shift(test::SpecDice& dice) {
  const double x = std::round(dice.uniform(-9.9e6, 9.9e6)), y = std::round(dice.uniform(-9.9e6, 9.9e6));
  return {x, y};
}

/// All lengths of a job times a factor.
Region times(Region region, double factor) {
  for (Polygon& polygon : region.polygons)
    for (Point& corner : polygon.outer) corner *= factor;
  return region;
}

Spec times(Spec spec, double factor) {
  spec.region = times(spec.region, factor);
  if (!spec.pole.is_fixed()) spec.pole.place = times(std::get<Region>(spec.pole.place), factor);
  for (Obstacle& obstacle : spec.obstacles)
    obstacle.shape = times(Region{{obstacle.shape}}, factor).polygons[0];
  spec.links.style.width *= factor;
  spec.links.style.pin_diameter *= factor;
  spec.links.style.thickness *= factor;
  spec.links.shortest *= factor;
  spec.links.longest *= factor;
  spec.limits.clearance *= factor;
  if (spec.limits.copy_gap) *spec.limits.copy_gap *= factor;
  return spec;
}

constexpr double by_search = 1e-8;  ///< share of a size: what rounding of the input may do to a search
constexpr double by_bound = 2e-3;   ///< to a bound: twice its tolerance

TEST(LocalFrame, OriginIsNotMovedTwice) {
  test::SpecDice dice(1);
  for (int i = 0; i < 300; ++i) {
    const Spec spec = shifted(dice.spec(), whole_shift(dice));
    EXPECT_EQ(local_origin(shifted(spec, -local_origin(spec))), Point::Zero());
  }
}

/// Exactly for fixed poles; a tree over poles may end elsewhere within its tolerance.
TEST(LocalFrame, BoundIsTheSameFarFromTheOrigin) {
  test::SpecDice dice(2);
  for (int i = 0; i < test::samples(100); ++i) {
    Spec spec = spec_on_grid(dice, dice.one_in(3));
    if (dice.one_in(3)) spec.limits.copy_gap = dice.uniform(0, 10);
    const Point shift = whole_shift(dice);
    const auto here = proven_bound(spec, {.boxes = 1000}),
               there = proven_bound(shifted(spec, shift), {.boxes = 1000});
    ASSERT_TRUE(here && there);
    EXPECT_EQ(here->no_design, there->no_design) << i;
    if (spec.pole.is_fixed()) {
      EXPECT_NEAR(here->value, there->value, by_search * here->value) << i;
    } else if (here->tight && there->tight) {
      EXPECT_NEAR(here->value, there->value, by_bound * here->value) << i;
    }
  }
}

void expect_same(const SearchOutcome& here, const SearchOutcome& there, const Point& shift, double factor,
                 int i) {
  ASSERT_EQ(here.index(), there.index()) << i;
  const auto* one = std::get_if<FoundDesign>(&here);
  if (!one) return;
  const auto& other = std::get<FoundDesign>(there);
  EXPECT_EQ(one->linkage.grounding(), other.linkage.grounding()) << i;
  EXPECT_EQ(one->layers, other.layers) << i;
  EXPECT_NEAR(factor * one->value, other.value, by_search * factor * one->value) << i;
  EXPECT_NEAR(factor * one->proven_bound.value_or(0), other.proven_bound.value_or(0),
              by_bound * factor * one->value)
      << i;
  const Point pole = factor * one->linkage.pole() + shift;
  EXPECT_NEAR((pole - other.linkage.pole()).norm(), 0, 1e-4 * factor * one->value + 1e-8) << i;
}

TEST(LocalFrame, DesignsAreTheSameFarFromTheOriginAndVerified) {
  test::SpecDice dice(3);
  const SearchOptions options{.diagnose = false};
  for (int i = 0; i < test::samples(14); ++i) {
    const Spec spec = spec_on_grid(dice, dice.one_in(3));
    const Point shift = whole_shift(dice);
    const Spec far = shifted(spec, shift);
    const SearchOutcome found = synthesize(far, options);
    expect_same(synthesize(spec, options), found, shift, 1, i);
    const auto* design = std::get_if<FoundDesign>(&found);
    if (!design) continue;
    const Design whole = assemble_design(far, *design, {.largest_sheets = false});
    EXPECT_TRUE(whole.map.coverage.covered) << i << whole.map.coverage.why_not;
    const Verification verified = verify(verification_task(whole));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
  }
}

TEST(LocalFrame, DesignsAreTheSameAtAnySize) {
  test::SpecDice dice(4);
  const SearchOptions options{.diagnose = false};
  for (int i = 0; i < test::samples(14); ++i) {
    const Spec spec = spec_on_grid(dice, dice.one_in(3));
    const double factor = std::pow(10, std::round(dice.uniform(-6, 2)));
    const Spec other = times(spec, factor);
    const SearchOutcome found = synthesize(other, options);
    expect_same(synthesize(spec, options), found, Point::Zero(), factor, i);
    const auto* design = std::get_if<FoundDesign>(&found);
    if (!design) continue;
    const Design whole = assemble_design(other, *design, {.largest_sheets = false});
    EXPECT_TRUE(whole.map.coverage.covered) << i << whole.map.coverage.why_not;
    const Verification verified = verify(verification_task(whole));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
  }
}

/// However near to straight the plates: verified, and size and bound change by no more than the rotation does.
TEST(LocalFrame, DesignsChangeSmoothlyTowardsStraightPlates) {
  test::SpecDice dice(5);
  const SearchOptions options{.diagnose = false};
  for (int i = 0; i < test::samples(4); ++i) {
    Spec spec = spec_on_grid(dice, false);
    spec.pole.place = Point(Point::Zero());
    const double scale = dice.uniform(1.5, 5);
    spec.limits.transmission = radians(25);
    std::optional<double> straight;
    for (const double bend : {0.0, 1e-14, 1e-12, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3}) {
      spec.copy = Copy::of(scale, (i % 2 ? pi : 0) - bend);
      const auto bound = proven_bound(spec);
      ASSERT_TRUE(bound);
      const double value = bound->no_design ? 0 : bound->value;
      if (!straight) straight = value;
      EXPECT_NEAR(value, *straight, (5 * bend + 2e-3) * *straight) << i << " " << bend;
      const SearchOutcome outcome = synthesize(spec, options);
      const auto* found = std::get_if<FoundDesign>(&outcome);
      if (!found) continue;
      const Design design = assemble_design(spec, *found, {.largest_sheets = false});
      EXPECT_TRUE(design.map.coverage.covered) << i << " " << bend << design.map.coverage.why_not;
      const Verification verified = verify(verification_task(design));
      EXPECT_TRUE(verified.holds) << i << " " << bend << " " << verified.failure;
    }
  }
}

/// A limit of 0 leaves designs a thousandth of a degree from dead and change points: covered, verified, above the bound.
TEST(LocalFrame, DesignsWithoutATransmissionLimitAreVerified) {
  test::SpecDice dice(6);
  const SearchOptions options{.diagnose = false};
  int near_the_end = 0;
  for (int i = 0; i < test::samples(14); ++i) {
    Spec spec = dice.spec();
    spec.limits.transmission = dice.one_in(3) ? dice.uniform(0, 2 * least_usable_angle) : 0;
    const SearchOutcome outcome = synthesize(spec, options);
    const auto* found = std::get_if<FoundDesign>(&outcome);
    if (!found) continue;
    const Design design = assemble_design(spec, *found, {.largest_sheets = false});
    EXPECT_TRUE(design.map.coverage.covered) << i << design.map.coverage.why_not;
    EXPECT_GE(design.quality.transmission_min, least_usable_angle * (1 - 1e-4)) << i;
    near_the_end += design.quality.transmission_min < 2 * least_usable_angle;
    if (found->proven_bound) {
      EXPECT_GE(found->value, *found->proven_bound) << i;
    }
    const Verification verified = verify(verification_task(design));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
  }
  EXPECT_GT(near_the_end, test::expected(1));
}

}  // namespace
}  // namespace kempe
