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

std::vector<Spec> loaded_specs() {
  std::vector<Spec> specs{test::shipped_spec("nameplate-steel"), test::shipped_spec("nameplate-pla"),
                          test::shipped_spec("pantorouter-upright"), test::shipped_spec("micro-manipulator")};
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
  specs.push_back(crowded);
  return specs;
}

/// A change told of a row leaves what the budget of the changed design has there.
TEST(ErrorBudget, AChangeLeavesWhatTheChangedDesignHas) {
  int looked_at = 0;
  for (const Spec& spec : loaded_specs()) {
    const Design design = designed(spec);
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
  for (const Spec& spec : loaded_specs()) {
    const Design design = designed(spec);
    const auto budget = error_budget(design);
    ASSERT_TRUE(budget);
    const auto check = [&](const std::optional<BestChange>& best, const auto& is_counted) {
      const auto sum = [&](const ErrorBudget& of) {
        double all = 0;
        for (const BudgetEntry& entry : of.entries)
          if (is_counted(entry.source)) all += entry.error;
        return all;
      };
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
    check(budget->best_in_plane, is_in_plane);
    check(budget->best_against_give, is_give);
    check(budget->best_down, [](ErrorSource source) { return !is_in_plane(source); });
  }
}

/// By the map, which shares no code with the closed forms that say it.
TEST(ErrorBudget, AChangeNeedsOtherLengthsWhereTheMapIsNotCoveredWithIt) {
  int need = 0, do_not = 0;
  for (const Spec& spec : loaded_specs()) {
    const Design design = designed(spec);
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

/// The figures of the design alone give the same as the entries, where layers add anything.
TEST(ErrorBudget, GiveInAllIsTheSumOfItsEntries) {
  for (const Spec& spec : loaded_specs()) {
    const Design design = designed(spec);
    const auto budget = error_budget(design);
    const auto give = give_in_all(design.quality);
    ASSERT_TRUE(budget && give);
    EXPECT_LE(*give, (1 + 1e-8) * budget->give());  // figures have nine digits
    if (error_of(*budget, ErrorSource::layers) > 0) {
      EXPECT_NEAR(*give, budget->give(), 1e-6 * *give);
    }
  }
}

}  // namespace
}  // namespace kempe
