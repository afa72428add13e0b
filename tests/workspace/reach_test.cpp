#include "workspace/reach.hpp"

#include <gtest/gtest.h>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

TEST(Reach, ReportsPlagiographUsesDistancesFrom5590To75) {
  // plagiograph report, k = 1.4i, OA = 50, OB = 35 mm: change point at sqrt(50^2 + 25^2), outer reach at 75.
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const Annulus annulus = reachable_annulus(linkage);
  EXPECT_NEAR(annulus.inner, std::sqrt(3125), 1e-12);
  EXPECT_NEAR(annulus.outer, 75, 1e-12);
  EXPECT_NEAR(chain_annulus(linkage).inner, 25, 1e-12);
  EXPECT_NEAR(chain_annulus(linkage).outer, 75, 1e-12);
}

TEST(Reach, AreasEqualTheClosedFormOfTheAnnuli) {
  Dice dice(21);
  for (int i = 0; i < 500; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    for (const Annulus& annulus : {reachable_annulus(linkage), usable_annulus(linkage, dice.between(0, 0.5)),
                                   chain_annulus(linkage)}) {
      const double expected =
          annulus.empty() ? 0 : pi * (annulus.outer * annulus.outer - annulus.inner * annulus.inner);
      const double scale = pi * annulus.outer * annulus.outer;
      EXPECT_NEAR(area(annulus), expected, 1e-12 * scale);
      EXPECT_NEAR(area(as_region(annulus)), expected, 1e-9 * std::max(1.0, expected) + 1e-12 * scale);
    }
  }
}

TEST(Reach, UsableLiesInReachableInChainAndTheDifferencesAddUp) {
  Dice dice(22);
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Annulus usable = usable_annulus(linkage, dice.between(0, 0.8));
    const Annulus reachable = reachable_annulus(linkage), chain = chain_annulus(linkage);
    EXPECT_GE(reachable.inner, chain.inner - 1e-9);
    EXPECT_LE(reachable.outer, chain.outer + 1e-9);
    EXPECT_NEAR(area(difference(reachable, usable)) + area(usable), area(reachable), 1e-9 * area(chain));
    EXPECT_NEAR(area(difference(chain, reachable)) + area(reachable), area(chain), 1e-9 * area(chain));
  }
}

TEST(Reach, EveryPoseOfAnIntervalStandsInItsAnnulus) {
  Dice dice(23);
  for (int i = 0; i < 500; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Annulus annulus = reachable_annulus(linkage);
    const OpeningInterval& all = linkage.assembly_interval();
    const Point tracer = linkage.tracer_at(dice.between(all.lower, all.upper), dice.between(-pi, pi));
    const double distance = (tracer - linkage.pole()).norm();
    EXPECT_GE(distance, annulus.inner - 1e-9);
    EXPECT_LE(distance, annulus.outer + 1e-9);
  }
}

Ring square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }
Ring turned_over(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(Reach, CoversIsDecidedByTheNearestAndFarthestPoint) {
  const Annulus annulus{{0, 0}, 10, 50};
  EXPECT_TRUE(covers(annulus, {{{{{11, -5}, {20, -5}, {20, 5}, {11, 5}}, {}}}}));
  EXPECT_FALSE(covers(annulus, {{{square(20), {}}}}));  // the pole inside the region
  EXPECT_TRUE(
      covers(annulus, {{{square(20), {turned_over(square(11))}}}}));  // the pole in a hole of the region
  EXPECT_FALSE(
      covers(annulus, {{{square(20), {turned_over(square(9))}}}}));  // the hole's sides come nearer than 10
  EXPECT_FALSE(covers(annulus, {{{square(40), {turned_over(square(11))}}}}));  // corners beyond 50
  EXPECT_TRUE(covers(annulus, {}));
}

}  // namespace
}  // namespace kempe
