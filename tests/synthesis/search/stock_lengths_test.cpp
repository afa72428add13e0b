// Lengths from a grid, a stock list, or locked; and the advice about follower and cutter.
#include "synthesis/search/strategies/stock_lengths.hpp"

#include <gtest/gtest.h>

#include "synthesis/design/assemble.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/relax.hpp"
#include "synthesis/search/strategies/ratio_lengths.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

Spec quarter_turn() {
  Spec spec;
  spec.copy = Copy::of(1.4, pi / 2);
  spec.region = Region{{{{{-50, 80}, {50, 80}, {50, 140}, {-50, 140}}, {}}}};
  spec.links.longest = 600;
  return spec;
}

std::optional<FoundDesign> found_in_stock(const Spec& spec) {
  const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
  const auto* design = std::get_if<FoundDesign>(&outcome);
  return design ? std::optional(*design) : std::nullopt;
}

bool is_multiple(double length, double grid) {
  return std::abs(length / grid - std::round(length / grid)) < 1e-9;
}

TEST(StockLengthSearch, ARationalRatioKeepsItsExactCopyOnTheGrid) {
  const RatioLengths lengths =
      stock_lengths_for({.grid = 5.0, .stock = {}, .locked = {}}, Complex(7.0 / 5), 200);
  for (const double VA : lengths.VA) EXPECT_TRUE(is_multiple(VA, 25)) << VA;
  for (const double VB : lengths.VB) EXPECT_TRUE(is_multiple(VB, 35)) << VB;
  EXPECT_EQ(lengths.VA.size(), 5U);  // 25, 50, .. 125: 1.4 times 150 is longer than 200
  EXPECT_EQ(lengths.VB.size(), 5U);  // 35, .. 175
}

TEST(StockLengthSearch, TheGridsDesignIsTheSmallestOfAll) {
  Spec spec = quarter_turn();
  spec.links.stock_lengths.grid = 5;
  const auto found = found_in_stock(spec);
  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(found->linkage.k() - spec.copy.k()), 1e-12);
  for (const double length :
       {found->linkage.VA(), found->linkage.VB(), found->linkage.lengths().AX, found->linkage.lengths().BY})
    EXPECT_TRUE(is_multiple(length, 5)) << length;
  // Every pair on the grid, every grounding and assembly mode, by the check of finished designs.
  double best = 1e300;
  for (const Grounding grounding : all_groundings)
    for (int assembly_mode = 0;
         assembly_mode < static_cast<int>(assembly_modes(shape_of(spec.copy.k(), grounding)).size());
         ++assembly_mode)
      for (double VA = 15; VA <= 600; VA += 5)
        for (double VB = 15; VB <= 600; VB += 5) {
          const auto linkage =
              CopyingLinkage::make(spec.copy.k(), grounding, VA, VB, assembly_mode, Point::Zero());
          if (!linkage || linkage->size() >= best || !is_multiple(linkage->lengths().AX, 5) ||
              !is_multiple(linkage->lengths().BY, 5))
            continue;
          for (const LayerAssignment& layers : layer_assignments(spec.links.layers))
            if (check_design(spec, requirements_of(spec), *linkage, layers).feasible) best = linkage->size();
        }
  EXPECT_NEAR(found->value, best, 1e-9 * best);
}

TEST(StockLengthSearch, AnIrrationalRatioIsStatedWithItsError) {
  Spec spec = quarter_turn();
  spec.copy = Copy::of(std::sqrt(2.0), 0.6);
  spec.links.stock_lengths.grid = 5;
  spec.links.longest = 300;
  const auto found = found_in_stock(spec);
  ASSERT_TRUE(found);
  const LinkLengths lengths = found->linkage.lengths();
  for (const double length : {lengths.VA, lengths.VB, lengths.AX, lengths.BY})
    EXPECT_TRUE(is_multiple(length, 5)) << length;
  MapOptions map;
  map.largest_sheets = false;
  const Design design = assemble_design(spec, *found, map);
  ASSERT_TRUE(design.wanted);
  EXPECT_EQ(design.wanted->scale, spec.copy.scale());
  EXPECT_GT(design.wanted->error, 0);
  EXPECT_LT(design.wanted->error, 0.02);
  EXPECT_NEAR(design.wanted->error, std::abs(std::polar(design.scale, design.rotation) - spec.copy.k()),
              1e-12);
  EXPECT_FALSE(design.quality.proven_bound) << "the bound is one of the exact ratio";
}

TEST(StockLengthSearch, AFineGridCostsNothing) {
  Spec spec = quarter_turn();
  spec.objective.groundings = {Grounding::pole};  // |s| = 1.4; that of the others is irrational
  const auto free = found_in_stock(spec);
  ASSERT_TRUE(free);
  for (const double grid : {1.0, 0.1, 0.01}) {
    spec.links.stock_lengths.grid = grid;
    const auto found = found_in_stock(spec);
    ASSERT_TRUE(found) << grid;
    EXPECT_GE(found->value, free->value * (1 - 1e-9));
    EXPECT_LT(found->value, free->value + 40 * grid) << grid;
    EXPECT_LT(std::abs(found->linkage.k() - spec.copy.k()), 1e-12);
  }
}

TEST(StockLengthSearch, AnInexactRatioIsTakenOnlyAsNearAsTheInstrumentStaysSmall) {
  test::SpecDice dice(77);
  int compared = 0, small = 0;
  const int wanted = test::samples(20);
  for (int i = 0; i < 4 * wanted && compared < wanted; ++i) {
    Spec spec = dice.spec();
    spec.pole = {};
    const auto free = found_in_stock(spec);
    if (!free) continue;
    const auto lengths = free->linkage.lengths().values();
    spec.links.stock_lengths.grid = *std::max_element(lengths.begin(), lengths.end()) / 40;
    const auto found = found_in_stock(spec);
    if (!found) continue;
    ++compared;
    small += found->value <= 1.25 * free->value;
    EXPECT_GT(std::abs(found->linkage.k() - spec.copy.k()), 0) << "spec " << i;
    EXPECT_NEAR(std::arg(shape_of(found->linkage.k(), found->linkage.grounding())),
                std::arg(shape_of(spec.copy.k(), found->linkage.grounding())), 1e-9)
        << "the plates keep their angle";
  }
  EXPECT_EQ(compared, wanted);
  EXPECT_GE(small, wanted < 20 ? 0 : wanted * 3 / 4);  // a share, which two cases do not tell
}

TEST(StockLengthSearch, StockLengthsAreTheOnlyOnesUsed) {
  Spec spec = quarter_turn();
  spec.copy = Copy::of(2, pi);
  spec.links.stock_lengths.stock = {60, 80, 100, 120, 160, 200, 240, 300};
  const auto found = found_in_stock(spec);
  ASSERT_TRUE(found);
  const LinkLengths lengths = found->linkage.lengths();
  for (const double length : {lengths.VA, lengths.VB, lengths.AX, lengths.BY}) {
    const auto& stock = spec.links.stock_lengths.stock;
    EXPECT_TRUE(std::any_of(stock.begin(), stock.end(), [&](double one) {
      return std::abs(one - length) < 1e-9;
    })) << length;
  }
}

/// Only the pole is left to be found, often in a small part of its area and with an obstacle beside it. The best design is
/// one of slightly stricter limits: else its pole would be the only one, to the last digit.
TEST(StockLengthSearch, AStockThatHoldsTheBestDesignsLengthsGivesThatDesign) {
  test::SpecDice dice(31);
  int compared = 0;
  const int wanted = test::samples(20);
  for (int i = 0; i < 4 * wanted && compared < wanted; ++i) {
    Spec spec = dice.spec();
    if (dice.one_in(2)) spec.obstacles = {dice.obstacle_beside(spec)};
    if (dice.one_in(2)) spec.objective.objective = Objective::transmission;
    Spec strict = spec;
    strict.limits.transmission += radians(0.2);
    strict.limits.clearance += 0.1;
    const auto best = found_in_stock(strict);
    if (!best) continue;
    const LinkLengths lengths = best->linkage.lengths();
    spec.links.stock_lengths.stock = {lengths.VA, lengths.VB, lengths.AX, lengths.BY};
    std::sort(spec.links.stock_lengths.stock.begin(), spec.links.stock_lengths.stock.end());
    const auto again = found_in_stock(spec);
    ASSERT_TRUE(again) << "spec " << i;
    const double worse = is_maximized(best->goal) ? best->value / again->value : again->value / best->value;
    EXPECT_LT(worse, 1.0005) << "spec " << i;
    ++compared;
  }
  EXPECT_EQ(compared, wanted);
}

/// What the search with any lengths knows of the choices spares work, in whatever order it comes, and leads to the same design.
TEST(StockLengthSearch, ChoicesThatAreRelaxedAlreadyLeadToTheSameDesign) {
  test::SpecDice dice(59);
  int compared = 0;
  for (int i = 0; i < test::samples(24); ++i) {
    Spec spec = dice.spec();
    if (i % 2 == 0) spec.objective.objective = Objective::transmission;
    if (dice.one_in(2)) {
      spec.material = Material{"steel", 200000, 7850, 235};
      spec.load = Load{10};
    }
    const auto free = found_in_stock(spec);
    if (!free) continue;
    if (spec.load) spec.limits.load_error = 1.2 * free->attained.load_error;
    spec.links.stock_lengths.grid = 1;
    const SearchTask task = pose(spec, SearchControl({}));
    const SearchResult any{.design = free};
    std::vector<Prospect> relaxed = relax_without_load(task, {});
    std::reverse(relaxed.begin(), relaxed.end());
    const SearchResult afresh = best_with_stock_lengths(task, any, {}),
                       known = best_with_stock_lengths(task, any, std::move(relaxed));
    ASSERT_EQ(afresh.design.has_value(), known.design.has_value()) << i;
    if (!afresh.design) continue;
    ++compared;
    EXPECT_EQ(afresh.design->value, known.design->value) << i;
    EXPECT_EQ(afresh.design->layers, known.design->layers) << i;
  }
  EXPECT_GT(compared, test::expected(8));
}

TEST(StockLengthSearch, WhereThePoleStandsFastNoneIsSaidAfterOneSearch) {
  for (const bool is_fixed : {true, false}) {
    Spec spec = quarter_turn();
    if (!is_fixed) spec.pole.place = Region{{{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {}}}};
    spec.links.stock_lengths.stock = {60, 61.7};  // too short
    const SearchTask task = pose(spec, SearchControl({}));
    const SearchResult once = best_design(task);
    EXPECT_FALSE(once.design);
    EXPECT_TRUE(once.none_in_stock);
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto* none = std::get_if<NoDesign>(&outcome);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->evaluations == once.evaluations, is_fixed);
  }
}

TEST(StockLengthSearch, ALockedLengthIsKeptAndTheRestSolved) {
  Spec spec = quarter_turn();
  spec.limits.transmission = radians(25);
  const auto free = found_in_stock(spec);
  ASSERT_TRUE(free);
  for (const double VA : {125.0, 135.0, 150.0}) {
    spec.links.stock_lengths.locked[0] = VA;
    const auto found = found_in_stock(spec);
    ASSERT_TRUE(found) << VA;
    EXPECT_NEAR(found->linkage.VA(), VA, 1e-9);
    EXPECT_GE(found->value, free->value * (1 - 1e-9));
  }
}

TEST(StockLengthSearch, AGridOrAStockKeepsEveryLockedLength) {
  test::SpecDice dice(41);
  int found_again = 0, others = 0;
  for (int i = 0; i < test::samples(24); ++i) {
    Spec spec = dice.spec();
    spec.pole = {};
    const auto any = found_in_stock(spec);
    if (!any) continue;
    const double step = std::max(1e-3, any->linkage.VA() / 40);
    StockLengths& stock_lengths = spec.links.stock_lengths;
    if (dice.one_in(3))
      for (int j = 1; j <= 400; ++j) stock_lengths.stock.push_back(j * step);
    else
      stock_lengths.grid = step;
    const auto unlocked = found_in_stock(spec);
    if (!unlocked) continue;
    const std::size_t length = std::array<std::size_t, 4>{0, 1, 4, 6}[static_cast<std::size_t>(i % 4)];
    const double was = std::round(unlocked->linkage.lengths().values()[length] / step) * step;
    for (const double locked : {was, was + step, was + 3 * step}) {
      stock_lengths.locked[length] = locked;
      const auto found = found_in_stock(spec);
      if (locked == was) {
        EXPECT_TRUE(found) << "spec " << i;
        found_again += found.has_value();
      }
      if (!found) continue;
      others += locked != was;
      const LinkLengths lengths = found->linkage.lengths();
      EXPECT_NEAR(lengths.values()[length], locked, 1e-8 * locked)
          << "spec " << i << ", " << LinkLengths::names[length];
      for (const double one : {lengths.VA, lengths.VB, lengths.AX, lengths.BY})
        EXPECT_NEAR(one / step, std::round(one / step), 1e-6) << "spec " << i;
    }
  }
  EXPECT_GT(found_again, test::samples(24) / 3);
  EXPECT_GT(others, test::samples(24) / 3);
}

TEST(StockLengthSearch, ADesignWithOtherLengthsIsNotHandedOut) {
  Spec spec = quarter_turn();
  const auto any = found_in_stock(spec);
  ASSERT_TRUE(any);
  MapOptions map;
  map.largest_sheets = false;
  EXPECT_TRUE(certified_design(spec, *any, map));
  const auto refused = [&](const StockLengths& stock_lengths) {
    spec.links.stock_lengths = stock_lengths;
    EXPECT_FALSE(keeps_stock_lengths(any->linkage, stock_lengths));
    return !certified_design(spec, *any, map);
  };
  const LinkLengths lengths = any->linkage.lengths();
  EXPECT_TRUE(refused({.grid = 0.97 * lengths.VA, .stock = {}, .locked = {}}));
  EXPECT_TRUE(refused({.grid = {}, .stock = {lengths.VA, lengths.VB, lengths.AX}, .locked = {}}));
  for (std::size_t i = 0; i < 8; ++i) {
    StockLengths one;
    one.locked[i] = lengths.values()[i];
    EXPECT_TRUE(keeps_stock_lengths(any->linkage, one));
    one.locked[i] = 1.0001 * lengths.values()[i];
    EXPECT_TRUE(refused(one)) << LinkLengths::names[i];
  }
}

TEST(StockLengthSearch, ALockedLengthMayLieOnTheLimit) {
  Spec spec = quarter_turn();
  const auto free = found_in_stock(spec);
  ASSERT_TRUE(free);
  spec.links.stock_lengths.locked[0] = free->linkage.VA();
  spec.links.stock_lengths.locked[1] = free->linkage.VB();
  const auto lengths = free->linkage.lengths().values();
  const double least = *std::min_element(lengths.begin(), lengths.end());
  const double most = *std::max_element(lengths.begin(), lengths.end());
  spec.links.shortest = least;
  spec.links.longest = most;
  EXPECT_TRUE(found_in_stock(spec));
  spec.links.shortest = least * (1 + 1e-9);
  EXPECT_FALSE(found_in_stock(spec));
  spec.links.shortest = least;
  spec.links.longest = most * (1 - 1e-9);
  EXPECT_FALSE(found_in_stock(spec));
}

TEST(StockLengthSearch, AGridThatNoLengthFitsHasNoDesign) {
  Spec spec = quarter_turn();
  spec.links.stock_lengths.grid = 350;
  EXPECT_FALSE(found_in_stock(spec));
}

/// A round template and its cut, walked: the follower's centre, the pen's, the cutter's edge.
TEST(ToolAdvice, TheCutIsTheCopyOfTheCorrectedTemplate) {
  test::SpecDice dice(3);
  for (int i = 0; i < 200; ++i) {
    const double scale = dice.log_uniform(0.1, 10), radius = dice.uniform(50, 100);
    const double follower = dice.uniform(0, 5), cutter = dice.uniform(0, 5);
    const auto advice = tool_advice({follower, cutter}, scale);
    ASSERT_TRUE(advice);
    const auto cut = [&](double template_radius, double follower_radius) {
      return (template_radius + follower_radius) * scale - cutter;
    };
    EXPECT_NEAR(cut(radius, *advice->exact_follower_radius), scale * radius, 1e-9);
    EXPECT_NEAR(cut(radius + *advice->template_offset, follower), scale * radius, 1e-9);
    EXPECT_NEAR(cut(radius, follower) - scale * radius, *advice->cut_outside, 1e-9);
  }
  EXPECT_FALSE(tool_advice({}, 2));
}

}  // namespace
}  // namespace kempe
