#include "synthesis/design/error_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "synthesis/design/assemble.hpp"
#include "tests/synthesis/shipped_spec.hpp"

namespace kempe {
namespace {

Design designed(const Spec& spec) {
  return assemble_design(spec, std::get<FoundDesign>(synthesize(spec, {.diagnose = false})), {},
                         Detail::figures);
}

/// The design with a change that its words name: a section, thicker pins, a longer grip or a point that rests.
std::optional<Design> changed(Design design, const std::string& words) {
  double width = 0, thickness = 0, length = 0;
  if (words == "the tracer resting on the table")
    design.load->rests.push_back(Carrier::tracer);
  else if (words == "the pen resting on the table")
    design.load->rests.push_back(Carrier::pen);
  else if (std::sscanf(words.c_str(), "%lf x %lf mm instead of", &width, &thickness) == 2)
    design.style.width = width, design.style.thickness = thickness;
  else if (std::sscanf(words.c_str(), "pins gripped over %lf mm", &length) == 1)
    design.load->grip = length;
  else if (std::sscanf(words.c_str(), "pins of %lf mm", &length) == 1)
    design.style.pin_diameter = length, design.hardware = {};
  else
    return std::nullopt;
  return design;
}

double error_of(const ErrorBudget& budget, ErrorSource source) {
  for (const BudgetEntry& entry : budget.entries)
    if (entry.source == source) return entry.error;
  return 0;
}

/// Found once for all tests.
const std::vector<Design>& loaded_designs() {
  static const std::vector<Design> designs = [] {
    std::vector<Design> found;
    for (const char* name : {"nameplate-steel", "nameplate-pla", "pantorouter-upright", "micro-manipulator"})
      found.push_back(designed(test::shipped_spec(name)));
    Spec crowded =
        test::shipped_spec("nameplate-pla");  // printed, in four layers: layers are most of what it gives
    crowded.copy = Copy::of(0.5);
    crowded.region = Region::rectangle({120, -30}, {60, 60});
    crowded.pole.place = Point(0, 0);
    crowded.links.sections.clear();
    use_section(crowded.links.style, {30, 12});
    crowded.links.style.pin_diameter = 6;
    crowded.links.layers = 4;
    crowded.limits.load_error.reset();
    crowded.limits.copy_gap.reset();
    crowded.objective.objective = Objective::size;
    found.push_back(designed(crowded));
    return found;
  }();
  return designs;
}

/// A change told of a row leaves what the budget of the changed design has there.
TEST(ErrorBudget, AChangeLeavesWhatTheChangedDesignHas) {
  int looked_at = 0;
  for (const Design& design : loaded_designs()) {
    const auto budget = error_budget(design);
    ASSERT_TRUE(budget);
    for (const BudgetEntry& entry : budget->entries) {
      EXPECT_LE(entry.changes.size(), 3u);
      for (const BudgetChange& change : entry.changes) {
        EXPECT_LT(change.after, 0.95 * entry.error) << change.words;
        const auto other = changed(design, change.words);
        if (!other) continue;
        const auto then = error_budget(*other);
        ASSERT_TRUE(then);
        EXPECT_NEAR(error_of(*then, entry.source), change.after, 1e-3 * entry.error)
            << name(entry.source) << ": " << change.words;
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 40);
}

/// Told of a sum: no row's change leaves less of it, of those that these lengths allow.
TEST(ErrorBudget, TheBestChangeIsTheBestOfTheSum) {
  for (const Design& design : loaded_designs()) {
    const auto budget = error_budget(design);
    ASSERT_TRUE(budget);
    const auto check = [&](const std::optional<BestChange>& best, const auto& is_counted, const auto& sum) {
      ASSERT_TRUE(best);
      EXPECT_NEAR(best->before, sum(*budget), 1e-12 * sum(*budget));
      if (const auto other = changed(design, best->change.words)) {
        EXPECT_NEAR(best->change.after, sum(*error_budget(*other)), 1e-3 * best->before)
            << best->change.words;
      }
      for (const BudgetEntry& entry : budget->entries)
        for (const BudgetChange& change : entry.changes)
          if (const auto other = changed(design, change.words);
              other && is_counted(entry.source) && !change.needs_other_lengths) {
            EXPECT_LE(best->change.after, (1 + 1e-3) * sum(*error_budget(*other))) << change.words;
          }
    };
    check(budget->best_in_plane, is_in_plane, [](const ErrorBudget& of) { return of.sum(true); });
    check(budget->best_against_give, is_give, [](const ErrorBudget& of) { return of.give; });
    check(
        budget->best_down, [](ErrorSource source) { return !is_in_plane(source); },
        [](const ErrorBudget& of) { return of.sum(false); });
  }
}

/// By the map, which shares no code with the closed forms that say it.
TEST(ErrorBudget, AChangeNeedsOtherLengthsWhereTheMapIsNotCoveredWithIt) {
  int need = 0, do_not = 0;
  for (const Design& design : loaded_designs()) {
    const auto budget = error_budget(design);
    ASSERT_TRUE(budget);
    for (const BudgetEntry& entry : budget->entries)
      for (const BudgetChange& change : entry.changes) {
        const auto other = changed(design, change.words);
        if (!other || change.words.find("gripped") != std::string::npos ||
            change.words.find("resting") != std::string::npos)
          continue;
        const WorkspaceMap map = map_workspace(map_task(*other), {.largest_sheets = false});
        EXPECT_EQ(!map.coverage.covered, change.needs_other_lengths) << change.words;
        ++(change.needs_other_lengths ? need : do_not);
      }
  }
  EXPECT_GT(need, 0);
  EXPECT_GT(do_not, 0);
}

/// The design's own figures give the same, and the entries of what gives way no less.
TEST(ErrorBudget, GiveIsThatOfTheFigures) {
  for (const Design& design : loaded_designs()) {
    const auto budget = error_budget(design);
    const auto give = give_in_all(design.quality);
    ASSERT_TRUE(budget && give);
    double entries = 0;
    for (const BudgetEntry& entry : budget->entries)
      if (is_give(entry.source)) entries += entry.error;
    EXPECT_NEAR(*give, budget->give, 1e-8 * *give);  // figures have nine digits
    EXPECT_LE(budget->give, (1 + 1e-9) * entries);
  }
}

/// What a row is told would help leaves less of the whole, too; and the map of a given mechanism says which lengths allow it.
TEST(ErrorBudget, NoChangeOfARowAddsToTheWhole) {
  for (const Design& design : loaded_designs()) {
    const auto budget = error_budget(design);
    ASSERT_TRUE(budget);
    for (const BudgetEntry& entry : budget->entries)
      for (const BudgetChange& change : entry.changes) {
        const auto other = changed(design, change.words);
        if (!other) continue;
        const auto then = error_budget(*other);
        const bool in_plane = is_in_plane(entry.source);
        EXPECT_LT(then->sum(in_plane), budget->sum(in_plane)) << change.words;
        if (is_give(entry.source)) {
          EXPECT_LE(then->give, (1 + 1e-9) * budget->give) << change.words;
        }
      }
  }
}

/// The same mechanism, found and given, has the same changes.
TEST(ErrorBudget, OfAGivenMechanismHasTheChangesOfTheSameDesign) {
  int need = 0;
  for (Design design : loaded_designs()) {
    const auto found = error_budget(design);
    design.allowed.reset();
    design.search.reset();
    const auto given = error_budget(design);
    ASSERT_TRUE(found && given);
    ASSERT_EQ(found->entries.size(), given->entries.size());
    for (std::size_t i = 0; i < found->entries.size(); ++i) {
      const auto &a = found->entries[i].changes, &b = given->entries[i].changes;
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t j = 0; j < a.size(); ++j) {
        EXPECT_EQ(a[j].words, b[j].words);
        EXPECT_EQ(a[j].needs_other_lengths, b[j].needs_other_lengths) << a[j].words;
        need += a[j].needs_other_lengths;
      }
    }
  }
  EXPECT_GT(need, 0);
}

}  // namespace
}  // namespace kempe
