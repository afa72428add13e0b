#include "synthesis/problem/requirements.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace kempe {
namespace {

constexpr std::array<Goal, 9> all_goals{Goal::size,      Goal::transmission, Goal::copy_error,
                                        Goal::footprint, Goal::clearance,    Goal::shortest,
                                        Goal::longest,   Goal::copy_gap,     Goal::pole_margin};

/// A limit on each goal, all different.
Requirements numbered_limits() {
  Requirements limits{{.clearance = 5, .transmission = 2, .copy_gap = 8, .copy_error = 3}};
  limits.shortest = 6;
  limits.longest = 7;
  limits.pole_margin = 9;
  limits.size = 1;
  limits.footprint = 4;
  return limits;
}

TEST(Goals, EachHasALimitAndAFigureOfItsOwn) {
  const Attained attained{.size = 1,
                          .transmission = 2,
                          .clearance = 5,
                          .shortest = 6,
                          .longest = 7,
                          .copy_gap = 8,
                          .pole_margin = 9,
                          .copy_error = 3,
                          .footprint = 4};
  std::set<std::string_view> names;
  double number = 0;
  for (const Goal goal : all_goals) {
    EXPECT_EQ(attained.of(goal), ++number) << name(goal);
    EXPECT_EQ(limit_on(numbered_limits(), goal), number) << name(goal);
    EXPECT_TRUE(names.insert(name(goal)).second) << name(goal);
  }
}

TEST(Goals, ALimitIsExchangedAlone) {
  for (const Goal goal : all_goals) {
    const Requirements other = with_limit(numbered_limits(), goal, 42);
    for (const Goal each : all_goals)
      EXPECT_EQ(limit_on(other, each), each == goal ? 42 : limit_on(numbered_limits(), each)) << name(each);
  }
}

TEST(Goals, ObjectivesAreGoalsOfTheSameNameAndDirection) {
  for (const Objective objective :
       {Objective::size, Objective::transmission, Objective::copy_error, Objective::footprint}) {
    const Goal goal = goal_of(objective);
    EXPECT_EQ(name(goal), name(objective));
    EXPECT_EQ(is_maximized(goal), is_maximized(objective));
    EXPECT_EQ(objective_of(goal), objective);
  }
}

TEST(Requirements, ComeBackFromASpecThatTheyWerePutInto) {
  Requirements limits = numbered_limits();
  const Requirements back = requirements_of(with_limits(Spec{}, limits));
  for (const Goal goal :
       {Goal::transmission, Goal::clearance, Goal::longest, Goal::copy_gap, Goal::copy_error})
    EXPECT_EQ(limit_on(back, goal), limit_on(limits, goal)) << name(goal);
}

}  // namespace
}  // namespace kempe
