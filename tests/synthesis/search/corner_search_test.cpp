// The limit on the copy error, kept by the instruments at the corners of their tolerances and not by the first order alone.
#include <gtest/gtest.h>

#include "synthesis/search/search.hpp"
#include "synthesis/tolerance/corner_error.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

std::optional<FoundDesign> found_for(const Spec& spec, int rounds) {
  SearchOptions options;
  options.threads = 1;
  options.diagnose = false;
  options.budgets.corner.rounds = rounds;
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* design = std::get_if<FoundDesign>(&outcome);
  return design ? std::optional(*design) : std::nullopt;
}

/// The worst instrument's copy error, where the first order does not tell it; else that of the first order. mm.
double copy_error_told(const Spec& spec, const FoundDesign& design) {
  const double first_order = design.attained.copy_error;
  const auto corner =
      corner_error_over(design.linkage, CopyTolerance::uniform(*spec.tolerance), RegionReach(spec.region));
  return corner && first_order_understates(first_order, corner->worst) ? corner->worst : first_order;
}

TEST(CornerSearch, TheLimitOnTheCopyErrorIsKeptBeyondTheFirstOrder) {
  test::SpecDice dice(77);
  int broken = 0, mended = 0;
  for (int i = 0; i < test::samples(16); ++i) {
    Spec spec = dice.spec();
    spec.tolerance = Tolerance{.length = dice.uniform(0.2, 0.6), .play = dice.uniform(0, 0.3)};
    const auto free = found_for(spec, 0);
    if (!free) continue;
    spec.limits.copy_error = dice.uniform(0.7, 1) * free->attained.copy_error;
    const auto nominal = found_for(spec, 0);
    if (!nominal) continue;
    const double limit = *spec.limits.copy_error;
    const auto design = found_for(spec, SearchBudgets{}.corner.rounds);
    ASSERT_TRUE(design) << i;
    if (copy_error_told(spec, *nominal) <= limit) {
      EXPECT_EQ(design->value, nominal->value) << i;
      continue;
    }
    ++broken;
    const bool kept = copy_error_told(spec, *design) <= limit;
    mended += kept;
    if (!kept) {
      EXPECT_EQ(design->value, nominal->value) << i;
    }
    EXPECT_LE(design->attained.copy_error, limit) << i;
    ASSERT_EQ(design->proven_bound, nominal->proven_bound) << i;
    EXPECT_LE(design->proven_bound.value_or(0), design->value * (1 + 1e-9)) << i;
  }
  RecordProperty("broken", broken);
  RecordProperty("mended", mended);
  EXPECT_GE(mended, test::expected(3));
}

}  // namespace
}  // namespace kempe
