// A local solution that is given up beside a design that is known, against the one that is not.
#include "synthesis/search/steps/local_search.hpp"

#include <gtest/gtest.h>

#include "synthesis/problem/choices.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

Spec loaded_spec(test::SpecDice& dice) {
  Spec spec = dice.spec();
  if (dice.one_in(2)) {
    spec.material = Material{"PLA", 3000, 1240, 26};
    spec.load = Load{dice.uniform(1, 10)};
    spec.limits.load_error = dice.log_uniform(0.05, 50);
  }
  if (dice.one_in(2)) spec.obstacles.push_back(dice.obstacle_beside(spec));
  return spec;
}

/// Ends of local solutions from random starts of one problem.
struct Ends {
  std::vector<DesignPoint> starts;
  std::vector<ChoiceResult> ends;
};

Ends ends_of(const DesignProblem& problem, test::SpecDice& dice, int count) {
  Ends all;
  for (int i = 0; i < count; ++i) {
    const std::array<double, 4> z{dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 1),
                                  dice.uniform(0, 1)};
    all.starts.push_back(
        problem.unit_point(std::span(z).first(static_cast<std::size_t>(problem.cube_dimensions()))));
    all.ends.push_back(refine(problem, all.starts.back(), LocalBudget{}, StopFlag{}));
  }
  return all;
}

TEST(LocalSearch, WhatIsGivenUpBesideAKnownDesignIsRarelyBetterThanThat) {
  test::SpecDice dice(4107);
  int better_ones = 0, missed = 0, given_up = 0;
  for (int i = 0; i < test::samples(1500); ++i) {
    const Spec spec = loaded_spec(dice);
    const SearchSpace space(spec);
    const auto choices = choices_of(spec);
    const ContactChoice& choice = choices[static_cast<std::size_t>(i) % choices.size()];
    const Requirements limits = requirements_of(spec);
    const Reach reach(spec.copy.k(), choice.choice.grounding, choice.choice.assembly_mode);
    const DesignProblem problem(space, choice.choice, limits, i % 2 == 0 ? Goal::size : Goal::transmission,
                                openings_with_transmission(reach, limits.transmission), choice.terms);
    if (!problem.possible()) continue;
    const Ends all = ends_of(problem, dice, 4);
    for (const ChoiceResult& known : all.ends) {
      if (!known.feasible) continue;
      for (std::size_t j = 0; j < all.ends.size(); ++j) {
        const ChoiceResult &end = all.ends[j],
                           with = refine(problem, all.starts[j], LocalBudget{}, StopFlag{}, &known);
        const double enough = known.cost - 2 * slack::at_bound * std::abs(known.cost);
        if (end.feasible && end.cost < enough) {
          ++better_ones;
          missed += !with.feasible || with.cost != end.cost;
        } else {
          given_up += with.evaluations < end.evaluations;
          if (!with.feasible || with.cost >= enough) continue;
          EXPECT_EQ(with.cost, judged(problem, all.starts[j], LocalBudget{}).cost)
              << "the start itself " << i;
        }
      }
    }
  }
  EXPECT_GT(better_ones, test::expected(100));
  EXPECT_LE(missed, better_ones / 50) << "of " << better_ones;
  EXPECT_GT(given_up, test::expected(100));
}

}  // namespace
}  // namespace kempe
