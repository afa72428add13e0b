#include "workspace/contact/self_contact.hpp"

#include <gtest/gtest.h>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

/// Gap between two parts by points strewn along both axes: an independent, slightly too large figure.
double sampled_gap(const ContactPair& pair, const Pose& pose, Complex shape, const LinkStyle& style) {
  const auto strewn = [&](const Part& part) {
    std::vector<Point> points;
    for (const JointHull& piece : axis_of(part, shape, style.plate)) {
      const Point &a = pose[piece.joints[0]], &b = pose[piece.joints[1]], &c = pose[piece.joints[2]];
      const int steps = piece.count == 1 ? 0 : 40;
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= (piece.count == 3 ? steps - i : 0); ++j) {
          const double u = steps == 0 ? 0 : i / 40.0, v = j / 40.0;
          points.push_back(a + u * (b - a) + v * (c - a));
        }
    }
    return points;
  };
  double least = 1e300;
  const auto others = strewn(pair.second);
  for (const Point& one : strewn(pair.first))
    for (const Point& other : others) least = std::min(least, (one - other).norm());
  return least - half_width(pair.first, style) - half_width(pair.second, style);
}

TEST(SelfContact, GapIsTheDistanceOfTheAxesLessTheHalfWidths) {
  Dice dice(11);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const OpeningInterval& all = linkage.assembly_mode().openings;
    const Pose pose = linkage.pose_at(dice.between(all.lower, all.upper), dice.between(-pi, pi));
    for (const ContactPair& pair : contact_pairs(linkage, test::random_layers(dice))) {
      const double exact = gap(pair, pose, linkage.shape(), style);
      const double sampled = sampled_gap(pair, pose, linkage.shape(), style);
      EXPECT_LE(exact, sampled + 1e-9);
      EXPECT_GE(exact, sampled - 15) << name(pair);  // spacing of the points
    }
  }
}

TEST(SelfContact, FreeOpeningsAreThoseOfADenseSampling) {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const LayerAssignment layers = test::random_layers(dice);
    const double clearance = dice.between(0, 2);
    const OpeningInterval within = linkage.assembly_mode().openings;
    const auto free = contact_free_openings(linkage, style, layers, clearance, within);
    for (int sample = 0; sample < 400; ++sample) {
      const double opening = within.lower + within.width() * (sample + 0.5) / 400;
      const double here = tightest_gap(linkage, linkage.pose_at(opening, 0.7), style, layers).gap;
      if (std::abs(here - clearance) < 1e-7) continue;
      const bool listed = std::any_of(
          free.begin(), free.end(), [&](const FreeOpenings& one) { return one.interval.contains(opening); });
      EXPECT_EQ(listed, here > clearance) << "case " << i << " opening " << opening << " gap " << here;
    }
  }
}

TEST(SelfContact, EndsStandAtTheContactTheyName) {
  Dice dice(13);
  int ends = 0;
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const LayerAssignment layers = test::random_layers(dice);
    for (const FreeOpenings& free :
         contact_free_openings(linkage, style, layers, 0.5, linkage.assembly_mode().openings, 1e-9))
      for (const auto& [pair, at] :
           {std::pair(free.below, free.interval.lower), std::pair(free.above, free.interval.upper)})
        if (pair) {
          ++ends;
          const double here = gap(*pair, linkage.pose_at(at, 0), linkage.shape(), style);
          EXPECT_GE(here, 0.5);
          EXPECT_NEAR(here, 0.5, 1e-6) << name(*pair);
        }
  }
  EXPECT_GT(ends, 100);
}

TEST(SelfContact, SmallestGapOverAnIntervalIsNeverBelowItAndIsAttained) {
  Dice dice(14);
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const LayerAssignment layers = test::random_layers(dice);
    const OpeningInterval& all = linkage.assembly_mode().openings;
    double a = dice.between(all.lower, all.upper), b = dice.between(all.lower, all.upper);
    const OpeningInterval within{std::min(a, b), std::max(a, b)};
    const Tightest tightest = smallest_gap_over(linkage, style, layers, within);
    ASSERT_TRUE(tightest.pair);
    EXPECT_TRUE(within.contains(tightest.opening));
    EXPECT_NEAR(tightest_gap(linkage, linkage.pose_at(tightest.opening, 1), style, layers).gap, tightest.gap,
                1e-9);
    for (int sample = 0; sample <= 200; ++sample) {
      const double opening = within.lower + within.width() * sample / 200;
      EXPECT_GE(tightest_gap(linkage, linkage.pose_at(opening, 1), style, layers).gap, tightest.gap - 1e-9);
    }
    const auto keeps = [&](double clearance) {
      const auto pairs = contact_pairs(linkage, layers);
      const auto nearer = pair_nearer_than(clearance, linkage, style, pairs, within);
      if (nearer) {
        EXPECT_LT(smallest_gap_over(linkage, style, std::vector{pairs[*nearer]}, within).gap, clearance);
      }
      return !nearer;
    };
    EXPECT_TRUE(keeps(tightest.gap));
    EXPECT_TRUE(keeps(tightest.gap - dice.between(0, 20)));
    EXPECT_FALSE(keeps(tightest.gap + 1e-9));
    EXPECT_FALSE(keeps(tightest.gap + dice.between(0.001, 20)));
  }
}

TEST(SelfContact, TwoBarsOfOneLayerMeetNearTheChangePoint) {
  // VA and B-C run parallel at distance VB |sin d|; with 12 mm bars and 0.5 mm they need 12.5 mm.
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const auto free = contact_free_openings(linkage, {12, 6, 4, PlateStyle::bent}, {}, 0.5, {1.0, pi}, 1e-9);
  ASSERT_FALSE(free.empty());
  ASSERT_TRUE(free.back().above);
  EXPECT_EQ(name(*free.back().above), "link VA and link BCY");
  EXPECT_NEAR(free.back().interval.upper, pi - std::asin(12.5 / 35), 3e-9);
}

TEST(SelfContact, NothingIsFreeWhenTheLinksAreWiderThanTheLinkage) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  EXPECT_TRUE(
      contact_free_openings(linkage, {100, 6, 4, PlateStyle::bent}, {}, 0.5, linkage.assembly_mode().openings)
          .empty());
}

TEST(SelfContact, ScalesWithTheMechanismFromMicrometresToKilometres) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const CopyingLinkage linkage =
        *CopyingLinkage::make({0, 1.4}, Grounding::tracer, 50 * scale, 35 * scale, 0);
    const LinkStyle style{6 * scale, 3 * scale, 4, PlateStyle::bent};
    const auto free =
        contact_free_openings(linkage, style, {}, 0.5 * scale, linkage.assembly_mode().openings);
    ASSERT_EQ(free.size(), 1u);
    EXPECT_NEAR(free[0].interval.lower, std::asin(6.5 / 35) - pi, 3e-9);
  }
}

}  // namespace
}  // namespace kempe
