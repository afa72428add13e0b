// How the bound of a proof log gives way. That the logs are proofs is shown by the checker: tests/proof.

#include "synthesis/certificate/proof_tree.hpp"

#include <gtest/gtest.h>

#include "tests/synthesis/shipped_spec.hpp"

namespace kempe::certificate {
namespace {

TEST(ProofTree, ABoundThatIsFalseGivesWayUntilItHasALog) {
  const Spec spec = test::shipped_spec("plagiograph");
  const auto size = prove(spec, Objective::size, 1e6, {.lines = 20});
  ASSERT_TRUE(size);
  EXPECT_LT(*size->bound, 1e6);
  const auto angle = prove(spec, Objective::transmission, radians(1), {.lines = 500});
  ASSERT_TRUE(angle);
  EXPECT_GT(*angle->bound, radians(1));
  EXPECT_LE(*angle->bound, pi / 2);
}

TEST(ProofTree, AVerdictThatIsFalseHasNone) {
  const auto log = prove(test::shipped_spec("plagiograph"), Objective::size, std::nullopt, {.lines = 100});
  EXPECT_FALSE(log);
}

TEST(ProofTree, APostInTheOriginalIsAFewLines) {
  Spec spec = test::shipped_spec("nameplate");
  Obstacle post{.shape = Region::circle({54, 135}, 15).polygons.front()};
  post.highest_layer = 8;  // all of them
  spec.obstacles.push_back(post);
  const auto log = prove(spec, Objective::size, std::nullopt, {.lines = 10});
  ASSERT_TRUE(log);
  EXPECT_FALSE(log->bound);
}

/// Wherever the pole may stand, the copy is nowhere on the table: poles alone are cut, which takes few lines.
TEST(ProofTree, ACopyOffTheTableIsProvenByAreasOfPoles) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.copy = Copy::of(3);
  spec.region = Region{{{{{-40, 60}, {40, 60}, {40, 140}, {-40, 140}}, {}}}};
  spec.pole.place = Region{{{{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}}, {}}}};
  spec.table = Polygon{{{-300, -300}, {300, -300}, {300, 300}, {-300, 300}}, {}};
  spec.links.style.width = 25;
  spec.objective.groundings = {Grounding::pole};
  const auto log = prove(spec, Objective::size, std::nullopt, {.lines = 10'000});
  ASSERT_TRUE(log);
  EXPECT_FALSE(log->bound);
}

}  // namespace
}  // namespace kempe::certificate
