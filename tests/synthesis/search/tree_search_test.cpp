// The tree as a search among obstacles and under a limit on the load error, beside the search of every choice, which shares nothing with it but the local solver.
#include "synthesis/search/strategies/tree_search.hpp"

#include <gtest/gtest.h>

#include "specs/materials.hpp"
#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "tests/synthesis/shipped_spec.hpp"

namespace kempe {
namespace {

Spec spec_among_obstacles(test::SpecDice& dice, int i) {
  Spec spec = dice.spec();
  if (i % 3 != 0) spec.pole.place = Point::Zero();
  if (i % 4 == 0) spec.objective.objective = Objective::transmission;
  for (int n = 0; n < 1 + i % 3; ++n) spec.obstacles.push_back(dice.obstacle_beside(spec));
  return spec;
}

Spec spec_beside_bodies(test::SpecDice& dice, int i) {
  Spec spec = spec_among_obstacles(dice, i);
  if (i % 2 == 0) spec.obstacles.clear();
  spec.pole.place = Point::Zero();
  spec.bodies.push_back(dice.body_beside(spec));
  if (i % 5 == 4) spec.table = dice.table_about(spec);
  return spec;
}

void expect_sound(const SearchTask& task, const FoundDesign& design) {
  const DesignCheck check = check_design(task.spec(), task.limits, design.linkage, design.layers);
  EXPECT_TRUE(check.feasible);
  EXPECT_TRUE(
      check_obstacles(task.space().spec(), task.limits, design.linkage, design.layers, check.opening).clear);
}

/// How many of some random tasks the tree closes; none of them has a better design by the search of every choice.
template <typename MakeSpec>
int closed_without_a_better_one(test::SpecDice& dice, int specs, const MakeSpec& make_spec) {
  int exhausted = 0;
  for (int i = 0; i < specs; ++i) {
    const Spec spec = make_spec(dice, i);
    const SearchTask task = pose(spec, SearchControl({}));
    if (!suits_tree_search(task)) continue;
    const SearchResult by_tree = best_by_tree(task);
    if (by_tree.design) expect_sound(task, *by_tree.design);
    EXPECT_FALSE(by_tree.proven_none && best_by_choices(task).design) << "spec " << i;
    if (!by_tree.exhausted) continue;
    ++exhausted;
    const SearchResult by_choices = best_by_choices(task);
    if (!by_choices.design) continue;
    const double tree = by_tree.design->value, choices = by_choices.design->value;
    const double worse = task.limits.load_error ? 4e-4 : 1e-6;
    if (task.goal == Goal::size)
      EXPECT_LT(tree, choices * (1 + worse)) << "spec " << i;
    else
      EXPECT_GT(tree, choices * (1 - worse)) << "spec " << i;
  }
  return exhausted;
}

TEST(TreeSearch, LeavesNothingBetterToTheSearchOfEveryChoice) {
  test::SpecDice dice(2029);
  EXPECT_GT(closed_without_a_better_one(dice, test::samples(60), spec_among_obstacles), test::expected(15));
}

TEST(TreeSearch, LeavesNothingBetterBesideBodies) {
  test::SpecDice dice(2032);
  EXPECT_GT(closed_without_a_better_one(dice, test::samples(16), spec_beside_bodies), test::expected(3));
}

/// With steel, a load, and a limit that the design which is best without one breaks.
Spec spec_under_load(test::SpecDice& dice, int i) {
  Spec spec = i % 4 == 3 ? spec_among_obstacles(dice, i) : dice.spec();
  if (i % 2 == 0) spec.objective.objective = Objective::transmission;
  spec.material = as_material(*material_named("steel"));
  spec.load = Load{10};
  const SearchTask task = pose(spec, SearchControl({}));
  if (const auto free = best_by_choices(task).design)
    spec.limits.load_error = dice.uniform(0.6, 0.98) * free->attained.load_error;
  return spec;
}

TEST(TreeSearch, LeavesNothingBetterUnderALimitOnTheLoadError) {
  test::SpecDice dice(2034);
  EXPECT_GT(closed_without_a_better_one(dice, test::samples(60), spec_under_load), test::expected(20));
}

TEST(TreeSearch, TellsTheSameTwice) {
  test::SpecDice dice(2030);
  for (int i = 0; i < test::samples(10); ++i) {
    const Spec spec = spec_among_obstacles(dice, i);
    const SearchTask task = pose(spec, SearchControl({}));
    if (!suits_tree_search(task)) continue;
    const SearchResult one = best_by_tree(task), other = best_by_tree(task);
    EXPECT_EQ(one.exhausted, other.exhausted);
    ASSERT_EQ(one.design.has_value(), other.design.has_value());
    if (!one.design) continue;
    EXPECT_EQ(one.design->linkage, other.design->linkage);
    EXPECT_EQ(one.design->layers, other.design->layers);
  }
}

TEST(TreeSearch, EndsWithItsLastTrialWhereNoneLedToADesign) {
  const Spec spec = test::shipped_spec("clamped-plate");
  const BoundOptions options{.boxes = 60000};
  int trials = 0;
  const auto fails = [&](const RelaxedDesign&) { return ++trials, Trial{}; };
  const auto tree = searched_by_tree(spec, Objective::size, options, {.run = fails, .most = 5});
  ASSERT_TRUE(tree);
  constexpr int of_one_box = 16;  // four shapes of its lengths, each with at most four sizes
  EXPECT_GE(trials, 5);
  EXPECT_LT(trials, 5 + of_one_box);
  EXPECT_FALSE(tree->no_design);
  EXPECT_LT(tree->boxes, options.boxes / 10);
}

TEST(TreeSearch, IsForObstaclesLoadsAndGoalsThatTheTreeKnows) {
  test::SpecDice dice(2031);
  Spec spec = spec_among_obstacles(dice, 1);
  spec.obstacles.clear();
  EXPECT_FALSE(suits_tree_search(pose(spec, SearchControl({}))));
  Spec loaded = spec;
  loaded.material = as_material(*material_named("steel"));
  loaded.load = Load{10};
  loaded.limits.load_error = 0.1;
  EXPECT_TRUE(suits_tree_search(pose(loaded, SearchControl({}))));
  spec.bodies.push_back(dice.body_beside(spec));
  EXPECT_TRUE(suits_tree_search(pose(spec, SearchControl({}))));
  for (const Goal goal : {Goal::footprint, Goal::copy_error, Goal::clearance, Goal::copy_gap}) {
    const Spec crowded = spec_among_obstacles(dice, 1);
    EXPECT_FALSE(suits_tree_search(pose(crowded, SearchControl({})).with(goal)));
  }
}

}  // namespace
}  // namespace kempe
