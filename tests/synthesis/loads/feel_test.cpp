// The most of the hand's force against what the hand pushes with at many poses and in many directions.
#include "synthesis/loads/feel.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "synthesis/loads/hand_work.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/loads/any_linkage.hpp"
#include "tests/synthesis/loads/free_links.hpp"

namespace kempe {
namespace {

using free_links::random_linkage;
using test::uniform;

struct HandCase {
  CopyingLinkage linkage;
  OpeningInterval openings;
  LinkStyle style{};
  JointHardware hardware{};
  Load load{};

  Feel feel() const { return feel_over(linkage, style, hardware, any_linkage::steel, load, openings); }
};

HandCase random_hand_case(std::mt19937_64& random, double tilt) {
  const CopyingLinkage linkage = random_linkage(random);
  HandCase one{linkage, shrink(linkage.assembly_mode().openings, 0.3)};
  one.load.pen_force = uniform(random, 0.1, 20);
  one.load.pen_mass = uniform(random, 0, 3);
  one.load.tracer_mass = uniform(random, 0, 1);
  one.load.friction = uniform(random, 0, 0.3);
  one.load.tilt = tilt;
  return one;
}

/// The most at random poses and headings.
double most_seen(const HandCase& one, std::mt19937_64& random, int poses) {
  const HandWork work(one.linkage, one.style, one.hardware, any_linkage::steel, one.load);
  double most = 0;
  for (int i = 0; i < poses; ++i) {
    const double opening = one.openings.lower + uniform(random, 0, 1) * one.openings.width();
    const auto here = work.at(one.linkage.pose_at(opening, uniform(random, -pi, pi)),
                              as_point(std::polar(1.0, uniform(random, -pi, pi))));
    most = std::max(most, here->hand.norm());
  }
  return most;
}

TEST(Feel, HandPushesNowhereMoreThanItsLargestForce) {
  std::mt19937_64 random(61);
  for (int i = 0; i < test::samples(100); ++i) {
    const HandCase one =
        random_hand_case(random, uniform(random, 0, 1) < 0.3 ? 0 : uniform(random, 0, pi / 2));
    const double most = one.feel().hand_most, seen = most_seen(one, random, 5000);
    EXPECT_LT(seen, 1.01 * most) << i;  // it is sampled; at most 0.99995 was seen
    EXPECT_GT(seen, 0.8 * most) << i;
  }
}

TEST(Feel, OnALevelTableTheHandHasWorkAndFrictionAlone) {
  std::mt19937_64 random(62);
  for (int i = 0; i < test::samples(100); ++i) {
    const HandCase one = random_hand_case(random, 0);
    const Feel feel = one.feel();
    const double work = std::abs(one.linkage.k()) * one.load.pen_force;
    EXPECT_GE(feel.hand_most, work * (1 - 1e-12));
    EXPECT_LE(feel.hand_most, work * (1 + feel.friction_share) * (1 + 1e-9));
    EXPECT_GE(feel.hand_most, work * (1 + 0.97 * feel.friction_share));
  }
}

TEST(Feel, WithoutFrictionTheHandHasWorkAndWeightInOneLine) {
  std::mt19937_64 random(63);
  for (int i = 0; i < test::samples(100); ++i) {
    HandCase one = random_hand_case(random, uniform(random, 0.1, pi / 2));
    one.load.friction = 0;
    const Feel feel = one.feel();
    const double sum = std::abs(one.linkage.k()) * one.load.pen_force + feel.weight_most;
    EXPECT_NEAR(feel.hand_most, sum, 0.005 * sum);
  }
}

}  // namespace
}  // namespace kempe
