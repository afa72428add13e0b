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
    const OpeningInterval& all = linkage.assembly_mode().openings;
    const Point tracer = linkage.tracer_at(dice.between(all.lower, all.upper), dice.between(-pi, pi));
    const double distance = (tracer - linkage.pole()).norm();
    EXPECT_GE(distance, annulus.inner - 1e-9);
    EXPECT_LE(distance, annulus.outer + 1e-9);
  }
}

Ring square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }
Ring turned_over(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(Reach, OpeningsMetAreThoseOfTheRegionsPlacesAndNoOthers) {
  Dice dice(24);
  int met = 0, missed = 0;
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Annulus reach = reachable_annulus(linkage);
    const double half = dice.between(0.05, 0.5) * reach.outer, away = dice.between(0, 1.6) * reach.outer;
    const Point middle = linkage.pole() + Point(away, 0);
    Ring ring = square(half);
    for (Point& corner : ring) corner += middle;
    const OpeningInterval openings = openings_met(linkage, {{{ring, {}}}});
    (openings.empty() ? missed : met) += 1;
    for (int j = 0; j < 40; ++j) {
      const double x = dice.between(-half, half), y = dice.between(-half, half);
      const double distance = (middle + Point(x, y) - linkage.pole()).norm();
      if (distance < reach.inner || distance > reach.outer) continue;
      const auto opening = linkage.opening_at(distance);
      ASSERT_TRUE(opening);
      EXPECT_GE(*opening, openings.lower - 1e-9);
      EXPECT_LE(*opening, openings.upper + 1e-9);
    }
    if (openings.empty()) continue;
    // Beside the pole's axis the square is nearest at its left side and farthest at its right corners.
    const double nearest = std::max(0.0, away - half), farthest = std::hypot(away + half, half);
    for (const double end : {openings.lower, openings.upper}) {
      EXPECT_GE(linkage.radius_at(end), nearest - 1e-9 * reach.outer);
      EXPECT_LE(linkage.radius_at(end), farthest + 1e-9 * reach.outer);
    }
  }
  EXPECT_GT(met, 50);
  EXPECT_GT(missed, 10);
}

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
