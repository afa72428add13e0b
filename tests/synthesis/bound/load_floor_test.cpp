// What the bound says of the load error over a box of designs, against a frame of beams at designs of the box; and the tree that leaves
// designs out by it, against designs that keep the limit.
#include "synthesis/bound/load_floor.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/search/search.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/bound/loaded_branch.hpp"
#include "tests/synthesis/loads/frame_oracle.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::DesignAtDistances;
using test::loaded;
using test::LoadedBranch;
using test::random_branch;

/// How far the pen gives way in its softest direction, by the frame; its shape from the definition, pen - pole = k (tracer - pole).
double by_frame(const LoadedBranch& one, const BarLengths& lengths, double opening) {
  const Complex k = one.spec.copy.k();
  const Grounding grounding = one.branch.mode.grounding;
  const Complex s = grounding == Grounding::pole     ? k
                    : grounding == Grounding::tracer ? 1.0 - k
                                                     : 1.0 - 1.0 / k;
  const Complex p = lengths.VA, q = std::polar(lengths.VB, opening);
  test::FrameTask task;
  task.joints = {Point(0, 0),     as_point(p),         as_point(q),
                 as_point(p + q), as_point(p + q / s), as_point(q + s * p)};
  if (grounding == Grounding::pole)
    task.pole = test::joint_V, task.tracer = test::joint_X, task.pen = test::joint_Y;
  if (grounding == Grounding::pen)
    task.pole = test::joint_X, task.tracer = test::joint_Y, task.pen = test::joint_V;
  task.width = one.spec.links.style.width;
  task.thickness = one.spec.links.style.thickness;
  task.young = one.spec.material->E;
  task.straight_ACX = task.straight_BCY = is_straight(s);
  return one.spec.load->pen_force * test::solve_frame(task).compliance.jacobiSvd().singularValues()[0];
}

double within(test::SpecDice& dice, const bounding::Range& range) {
  return std::clamp(dice.log_uniform(range.lower, range.upper), range.lower, range.upper);
}

TEST(LoadFloor, NoDesignOfABoxGivesWayByLess) {
  test::SpecDice dice(415);
  double nearest = HUGE_VAL;
  for (int i = 0; i < test::samples(400); ++i) {
    const LoadedBranch one = random_branch(dice);
    const bounding::ModeFacts& mode = one.branch.mode;
    const bounding::LoadFloor floor(one.spec, mode);
    const double t = dice.log_uniform(0.3, 3), w = dice.log_uniform(1e3, 1e5),
                 wide = dice.log_uniform(1e-6, 1);
    const bounding::LengthBox box{{t, t * (1 + wide)}, {w, w * (1 + wide)}};
    const double margin = 0.02 * (mode.near_end - mode.far_end);
    const double psi = dice.uniform(mode.far_end + margin, mode.near_end - margin);
    const double least = floor.at_least(psi, box);
    ASSERT_GE(least, 0);
    for (int j = 0; j < 5; ++j) {
      const double here = within(dice, box.t), there = within(dice, box.w);
      const BarLengths lengths{std::sqrt(there / here / 2), std::sqrt(there * here / 2) * std::abs(mode.s)};
      const double given = by_frame(one, lengths, one.branch.opening_of(psi));
      EXPECT_LE(least, given * (1 + 1e-7)) << "t " << here << " of " << box.t.lower << " to " << box.t.upper;
      if (wide < 1e-5) nearest = std::min(nearest, least / given);
    }
  }
  EXPECT_GT(nearest, 0.9999);  // a small box's floor is near to what its designs have
}

TEST(LoadFloor, NoDesignGivesWayByLessWhereItReachesADistance) {
  test::SpecDice dice(418);
  double nearest = HUGE_VAL;
  int bounded = 0;
  for (int i = 0; i < test::samples(400); ++i) {
    LoadedBranch one = random_branch(dice);
    one.spec.limits.load_error = 1e-12;  // a floor below the limit need not be the best one
    const bounding::ModeFacts& mode = one.branch.mode;
    const bounding::LoadFloor floor(one.spec, mode);
    const double t = dice.log_uniform(0.3, 3), w = dice.log_uniform(1e3, 1e5),
                 wide = dice.log_uniform(1e-6, 2);
    const bounding::LengthBox box{{t, t * (1 + wide)}, {w, w * (1 + wide)}};
    const double angle = dice.uniform(0.02, 0.2);
    const bounding::Range usable = mode.usable(angle);
    if (usable.empty()) continue;
    for (int j = 0; j < 5; ++j) {
      const double here = within(dice, box.t), there = within(dice, box.w);
      const double psi = dice.uniform(usable.lower, usable.upper);
      const double distance = std::sqrt(there * ((here + 1 / here) / 2 + std::cos(psi))) / mode.chain;
      const BarLengths lengths{std::sqrt(there / here / 2), std::sqrt(there * here / 2) * std::abs(mode.s)};
      const double given = by_frame(one, lengths, one.branch.opening_of(psi));
      const double exactly =
          floor.at_least_reaching(distance, bounding::LoadFloor::Reaching::exactly, angle, box);
      EXPECT_LE(exactly, given * (1 + 1e-7)) << i;
      EXPECT_LE(floor.at_least_reaching(distance * dice.uniform(0.5, 1),
                                        bounding::LoadFloor::Reaching::at_least, angle, box),
                given * (1 + 1e-7))
          << i;
      bounded += exactly > 0;
      if (wide < 1e-5) nearest = std::min(nearest, exactly / given);
    }
  }
  EXPECT_GT(bounded, test::expected(1000));
  EXPECT_GT(nearest, 0.99);
}

TEST(LoadFloor, ADistanceThatNoDesignOfTheBoxReachesHasNoFloor) {
  test::SpecDice dice(419);
  const LoadedBranch one = random_branch(dice);
  const bounding::LoadFloor floor(one.spec, one.branch.mode);
  const bounding::LengthBox box{{1, 1.1}, {1000, 1100}};
  for (const auto reaching :
       {bounding::LoadFloor::Reaching::exactly, bounding::LoadFloor::Reaching::at_least})
    EXPECT_EQ(floor.at_least_reaching(1e4 / one.branch.mode.chain, reaching, 0.1, box), infinity);
}

TEST(LoadFloor, LeavesOutNoBoxWithADesignThatKeepsTheLimit) {
  test::SpecDice dice(416);
  int left_out = 0, without_an_opening = 0, without_a_distance = 0, kept = 0;
  for (int i = 0; i < test::samples(2000); ++i) {
    LoadedBranch one = random_branch(dice);
    const bounding::ModeFacts& mode = one.branch.mode;
    const DesignAtDistances design(one, dice);
    if (!design.linkage) continue;
    const auto& [t, w, linkage, openings, covered] = design;
    // Of all poles of a box less is known than of each.
    bounding::PoleDistances distances = covered;
    if (dice.one_in(2)) distances.nearest_at_most *= dice.uniform(1, 1.5);
    if (dice.one_in(2)) distances.farthest_at_least /= dice.uniform(1, 1.5);
    distances.squares_at_least = 0;
    const double wide = dice.log_uniform(1e-6, 1);
    const bounding::LengthBox box{{t / (1 + wide * dice.uniform(0, 1)), t * (1 + wide)},
                                  {w / (1 + wide * dice.uniform(0, 1)), w * (1 + wide)}};
    const double has = load_error_profile(one.spec, one.spec.copy.k(), mode.grounding)
                           .over({linkage->VA(), linkage->VB()}, openings)
                           .worst;
    one.spec.limits.load_error = has * dice.log_uniform(0.5, 2);
    const bool keeps = has <= *one.spec.limits.load_error;
    const double angle = dice.uniform(0, 1) * std::min(linkage->transmission_angle(openings.lower),
                                                       linkage->transmission_angle(openings.upper));
    const bool is_left_out = bounding::LoadFloor(one.spec, mode).exceeded_by_all(distances, angle, box);
    EXPECT_FALSE(keeps && is_left_out) << i;
    const bounding::LoadFloor floor(one.spec, mode);
    const BarLengths lengths{linkage->VA(), linkage->VB()};
    EXPECT_EQ(floor.keeps(lengths, openings), keeps);
    EXPECT_TRUE(!keeps || floor.keeps_at_ends(lengths, openings)) << i;
    left_out += is_left_out;
    without_an_opening += is_left_out && bounding::passed_by_all(mode, distances, box).empty();
    without_a_distance += is_left_out && distances.nearest_at_most > distances.farthest_at_least;
    kept += keeps;
  }
  EXPECT_GT(left_out, test::expected(200));
  EXPECT_GT(without_an_opening, test::expected(50));
  EXPECT_GT(without_a_distance, test::expected(20));
  EXPECT_GT(kept, test::expected(200));
}

/// A plagiograph beside a fence.
Spec beside_a_fence() {
  Spec spec;
  spec.copy = Copy::of(1.4, pi / 2);
  spec.region = Region::rectangle({60, -14}, {8, 28});
  spec.links.style = {.width = 6, .pin_diameter = 3, .thickness = 3};
  spec.links.layers = 2;
  spec.limits.clearance = 0.5;
  spec.limits.transmission = radians(10);
  spec.obstacles.push_back({{{{-4, 40}, {36, 40}, {36, 44}, {-4, 44}}, {}}, 1, 1, "fence"});
  return spec;
}

TEST(LoadFloor, TheTreeUnderLoadIsABoundNearTheDesign) {
  const SearchOutcome free = synthesize(loaded(beside_a_fence(), 1e6), {});
  const auto* without = std::get_if<FoundDesign>(&free);
  ASSERT_NE(without, nullptr);
  const Spec spec = loaded(beside_a_fence(), 0.9 * without->attained.load_error);
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* found = std::get_if<FoundDesign>(&outcome);
  ASSERT_NE(found, nullptr);
  EXPECT_LE(found->attained.load_error, *spec.limits.load_error * (1 + 1e-12));
  const auto bound = proven_bound(spec, {.incumbent = found->value, .load_limit = true});
  ASSERT_TRUE(bound);
  EXPECT_TRUE(bound->tight);
  EXPECT_LE(bound->value, found->value * (1 + 1e-12));
  EXPECT_GE(bound->value, found->value * (1 - 2e-3));
  const auto told = proven_bound(spec, {.incumbent = found->value});
  ASSERT_TRUE(told);
  EXPECT_LE(told->value, without->value * (1 + 1e-12));  // a bound that is told goes without the limit
  ASSERT_TRUE(found->proven_bound);
  EXPECT_LE(*found->proven_bound, without->value * (1 + 1e-12));
}

/// The bound that a search under the limit tells goes on with its own boxes. Beside it the bound of a tree of its own, and designs.
TEST(LoadFloor, TheBoundOfASearchUnderLoadIsThatOfATreeWithoutTheLimit) {
  test::SpecDice dice(58);
  int compared = 0;
  for (int i = 0; i < test::samples(15); ++i) {
    Spec spec = loaded(dice.spec(), 1e6);
    spec.links.layers = 2;
    for (int n = 0; n < 2; ++n) spec.obstacles.push_back(dice.obstacle_beside(spec));
    if (i % 3 == 0) spec.objective.objective = Objective::transmission;
    const SearchOutcome free = synthesize(spec, {.diagnose = false});
    const auto* without = std::get_if<FoundDesign>(&free);
    if (!without || !(without->attained.load_error < 1e5)) continue;
    spec.limits.load_error = dice.uniform(0.8, 0.95) * without->attained.load_error;
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto* found = std::get_if<FoundDesign>(&outcome);
    if (!found) continue;
    ++compared;
    const double sign = spec.objective.objective == Objective::size ? 1 : -1;
    ASSERT_TRUE(found->proven_bound) << i;
    const double told = sign * *found->proven_bound, best = sign * without->value,
                 value = sign * found->value;
    const double rounding = 1e-9 * std::abs(best);
    EXPECT_LE(told, best + rounding) << i;
    EXPECT_LE(told, value + rounding) << i;
    const auto other =
        proven_bound(spec, {.incumbent = found->value, .tolerance = 1e-4, .share_of_gap = 0.05});
    ASSERT_TRUE(other) << i;
    // Both are at most a twentieth of what the limit costs, or 0.01 %, below the best without it.
    EXPECT_NEAR(told, sign * other->value, 0.06 * std::max(0.0, value - best) + 1e-3 * std::abs(best)) << i;
  }
  EXPECT_GT(compared, test::expected(5));
}

TEST(LoadFloor, ALimitThatNoDesignKeepsLeavesNoBox) {
  const Spec spec = loaded(beside_a_fence(), 1e-5);
  const auto bound = proven_bound(spec, {.load_limit = true});
  ASSERT_TRUE(bound);
  EXPECT_TRUE(bound->no_design);
  const auto told = proven_bound(spec);
  ASSERT_TRUE(told);
  EXPECT_FALSE(told->no_design);
}

/// The pole may stand in the region, so that large boxes have designs without an opening or a distance in common.
TEST(LoadFloor, FewBoxesProveThatNoDesignIsStiffEnoughRoundAFreePole) {
  Spec spec;
  spec.copy = Copy::of(0.62, radians(-107));
  spec.region = Region{
      {{{{-95, -97}, {-95, -101}, {-98, -101}, {-98, -97}, {-99, -97}, {-99, -103}, {-94, -103}, {-94, -97}},
        {}}}};
  spec.links.style = {.width = 22, .pin_diameter = 12, .thickness = 3};
  spec.links.layers = 3;
  spec.links.shortest = 35;
  spec.links.longest = 600;
  spec.limits.transmission = radians(30);
  spec.limits.clearance = 0.2;
  const SearchOutcome free = synthesize(loaded(spec, 1e6), {});
  const auto* without = std::get_if<FoundDesign>(&free);
  ASSERT_NE(without, nullptr);
  const auto bound = proven_bound(loaded(spec, 0.8 * without->attained.load_error), {.load_limit = true});
  ASSERT_TRUE(bound);
  EXPECT_TRUE(bound->no_design);
  EXPECT_LT(bound->boxes, 20'000u);
}

}  // namespace
}  // namespace kempe
