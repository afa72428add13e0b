// What is said of boxes of designs by the load error together with the goal, against designs of the box.
#include "synthesis/bound/load_trade.hpp"

#include <gtest/gtest.h>

#include "synthesis/bound/load_waves.hpp"
#include "synthesis/loads/load_error.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/bound/design_in_a_box.hpp"

namespace kempe {
namespace {

using test::DesignAtDistances;
using test::DesignInABox;
using test::DesignInside;
using test::designs_in;
using test::given;
using test::LoadedBranch;
using test::random_branch;
using test::Wanted;

TEST(LoadTrade, NoBoxWithABetterDesignIsSaidToHaveNone) {
  test::SpecDice dice(417);
  int without = 0, with = 0;
  for (int i = 0; i < test::samples(20000); ++i) {
    LoadedBranch one = random_branch(dice);
    const DesignAtDistances design(one, dice);
    if (!design.linkage) continue;
    const double wide = dice.log_uniform(1e-6, 0.3);
    const DesignInABox in(one, design, wide, dice);
    const auto has = given(*in.profile, in.linkage, in.pole, in.places);
    if (!has) continue;
    const auto about = [&](double figure) { return figure * (1 + wide * dice.uniform(-0.3, 0.3)); };
    const Wanted wanted{about(has->load), about(has->transmission),
                        dice.one_in(2) ? std::optional(about(has->size)) : std::nullopt};
    one.spec.limits.load_error = wanted.load;
    const bounding::LoadTrade trade(one.spec, one.branch.mode);
    const bool has_none =
        bounding::BoxTrade(trade, in.places, in.box, {wanted.transmission, wanted.size}).none_better();
    without += has_none;
    if (!has_none && !wanted.is_kept_by(*has)) continue;
    ++with;
    ASSERT_FALSE(has_none && wanted.is_kept_by(*has)) << i;
    for (const DesignInside& other : designs_in(one, in, 20, dice))
      ASSERT_FALSE(has_none && wanted.is_kept_by(other.has)) << i;
  }
  EXPECT_GT(without, test::expected(400));
  EXPECT_GT(with, test::expected(1000));
}

/// What is lost goes with the square of the width: of boxes a thousandth wide, whose designs all miss something by a fifth of that, nearly all
/// are told.
TEST(LoadTrade, SmallBoxesWithoutABetterDesignAreTold) {
  test::SpecDice dice(420);
  int told = 0, all = 0;
  constexpr double wide = 1e-3;
  for (int i = 0; i < test::samples(4000); ++i) {
    LoadedBranch one = random_branch(dice);
    const DesignAtDistances design(one, dice);
    if (!design.linkage) continue;
    const DesignInABox in(one, design, wide, dice);
    const auto has = given(*in.profile, in.linkage, in.pole, in.places);
    if (!has) continue;
    const auto about = [&](double figure) { return figure * (1 + wide * dice.uniform(-1, 1)); };
    const Wanted wanted{about(has->load), about(has->transmission), about(has->size)};
    const std::vector<DesignInside> designs = designs_in(one, in, 300, dice);
    if (std::any_of(designs.begin(), designs.end(),
                    [&](const DesignInside& each) { return wanted.is_kept_by(each.has, 1 + 0.2 * wide); }))
      continue;
    ++all;
    one.spec.limits.load_error = wanted.load;
    const bounding::LoadTrade trade(one.spec, one.branch.mode);
    told += bounding::BoxTrade(trade, in.places, in.box, {wanted.transmission, wanted.size}).none_better();
  }
  EXPECT_GT(all, test::expected(1000));
  EXPECT_GT(told, 0.9 * all);
}

/// The waves against the load error itself.
TEST(LoadWaves, TheirSquaresAreTheLoadErrorOverItsLimit) {
  test::SpecDice dice(421);
  for (int i = 0; i < test::samples(1000); ++i) {
    const LoadedBranch one = random_branch(dice);
    const bounding::ModeFacts& mode = one.branch.mode;
    const auto profile = load_error_profile(one.spec, one.spec.copy.k(), mode.grounding);
    const double VA = dice.log_uniform(20, 500), VB = dice.log_uniform(20, 500);
    const double margin = 0.02 * (mode.near_end - mode.far_end);
    const auto some_psi = [&] { return dice.uniform(mode.far_end + margin, mode.near_end - margin); };
    const double psi = some_psi(), other = some_psi();
    const OutwardRounding rounding;
    const bounding::LoadWaves loads(one.spec, mode);
    const bounding::Phase there = bounding::phase_at(mode, Interval(psi)),
                          elsewhere = bounding::phase_at(mode, Interval(other));
    const auto waves = loads.of(Interval(VA), Interval(VB), there);
    const auto root_at = [&](const bounding::Phase& d) {
      Interval sum(0);
      for (const bounding::LoadWave& each : waves) sum += CGAL::square(each.wave.at(d));
      return CGAL::sqrt(sum);
    };
    const Interval sine = loads.sign_of_sine() * there.sine, square = CGAL::square(root_at(there) / sine);
    const double worst = profile.at({VA, VB}, one.branch.opening_of(psi)).worst / *one.spec.limits.load_error;
    EXPECT_GT(sine.inf(), 0) << i;
    EXPECT_NEAR(square.inf(), worst, 1e-6 * worst) << i;
    EXPECT_NEAR(square.sup(), worst, 1e-6 * worst) << i;
    const bounding::Wave below = bounding::touching_from_below(waves, there);
    EXPECT_NEAR(below.at(there).inf(), root_at(there).sup(), 1e-7 * root_at(there).sup()) << i;
    EXPECT_LE(below.at(elsewhere).inf(), root_at(elsewhere).sup()) << i;
  }
}

}  // namespace
}  // namespace kempe
