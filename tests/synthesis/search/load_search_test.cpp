// Load error and mass as limit and objective: designs are held against a plain grid of lengths, which shares nothing with the solvers, and
// sections against searches with each alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "specs/materials.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/search/diagnosis/diagnosis.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/section_search.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "tests/synthesis/shipped_spec.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

Spec plagiograph() {
  Spec spec;
  spec.copy = Copy::of(1.4, pi / 2);
  spec.region = Region::rectangle({62, -5}, {8, 10});
  spec.links.style = {.width = 6, .pin_diameter = 3, .thickness = 2};
  spec.limits.transmission = radians(25);
  spec.material = as_material(*material_named("steel"));
  spec.load = Load{10};
  return spec;
}

FoundDesign design_for(const Spec& spec) {
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* found = std::get_if<FoundDesign>(&outcome);
  EXPECT_NE(found, nullptr);
  return found != nullptr
             ? *found
             : FoundDesign{*CopyingLinkage::make(1.4, Grounding::pole, 1, 1, 0), LayerAssignment{}};
}

double load_error_of(const Spec& spec, const FoundDesign& design) {
  const auto openings = openings_over(design.linkage, spec.region);
  EXPECT_TRUE(openings);
  return load_error_profile(spec, design.linkage.k(), design.linkage.grounding())
      .worst_over({design.linkage.VA(), design.linkage.VB()}, *openings);
}

TEST(LoadSearch, KeepsALimitThatBinds) {
  Spec spec = plagiograph();
  const FoundDesign free = design_for(spec);
  spec.objective.objective = Objective::load_error;
  const FoundDesign stiffest = design_for(spec);
  ASSERT_LT(stiffest.value, load_error_of(spec, free));
  spec.objective.objective = Objective::size;
  double before = HUGE_VAL;
  for (const double share : {0.02, 0.3, 0.8}) {
    spec.limits.load_error = stiffest.value + share * (load_error_of(spec, free) - stiffest.value);
    const FoundDesign held = design_for(spec);
    EXPECT_LE(load_error_of(spec, held), *spec.limits.load_error * (1 + 1e-12));
    EXPECT_GE(load_error_of(spec, held), *spec.limits.load_error * (1 - 1e-4));  // it binds
    EXPECT_GE(held.value, free.value * (1 - 1e-9));
    EXPECT_LT(held.value, before);  // the looser, the smaller
    before = held.value;
    if (held.proven_bound) {
      EXPECT_LE(*held.proven_bound, held.value * (1 + 1e-9));
    }
  }
}

/// The least of a figure over a grid of lengths of all groundings and assembly modes; straight from the linkage, contact by the certified
/// openings.
template <class Figure>
double best_on_a_grid(const Spec& spec, const Figure& figure) {
  constexpr int steps = 40;
  double best = HUGE_VAL;
  for (const Grounding grounding : all_groundings)
    for (const AssemblyMode& mode : assembly_modes(shape_of(spec.copy.k(), grounding)))
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
          const double VA = 16 * std::pow(12.0, i / double(steps)),
                       VB = 16 * std::pow(12.0, j / double(steps));
          const auto linkage = CopyingLinkage::make(spec.copy.k(), grounding, VA, VB, mode.number);
          const auto lengths = linkage->lengths().values();
          if (*std::min_element(lengths.begin(), lengths.end()) < spec.links.shortest) continue;
          const auto openings = openings_over(*linkage, spec.region);
          if (!openings || !linkage->openings_with_transmission(spec.limits.transmission).contains(*openings))
            continue;
          const double value = figure(*linkage, *openings);
          if (value >= best) continue;
          for (const LayerAssignment& layers : layer_assignments(2))
            if (smallest_gap_over(*linkage, spec.links.style, layers, *openings).gap >= spec.limits.clearance)
              best = value;
        }
  return best;
}

TEST(LoadSearch, FindsNothingWorseThanAGridOfLengths) {
  Spec spec = plagiograph();
  spec.objective.objective = Objective::load_error;
  const double stiffest =
      best_on_a_grid(spec, [&](const CopyingLinkage& linkage, const OpeningInterval& openings) {
        return load_error_profile(spec, linkage.k(), linkage.grounding())
            .worst_over({linkage.VA(), linkage.VB()}, openings);
      });
  const FoundDesign found = design_for(spec);
  EXPECT_LE(found.value, stiffest);
  EXPECT_GE(found.value, 0.8 * stiffest);  // the grid comes near it
  EXPECT_FALSE(found.proven_bound);
  spec.objective.objective = Objective::mass;
  spec.limits.load_error = 1.3 * found.value;
  const double lightest =
      best_on_a_grid(spec, [&](const CopyingLinkage& linkage, const OpeningInterval& openings) {
        const double error = load_error_profile(spec, linkage.k(), linkage.grounding())
                                 .worst_over({linkage.VA(), linkage.VB()}, openings);
        return error <= *spec.limits.load_error ? mass_of_links(linkage, spec) : HUGE_VAL;
      });
  const FoundDesign light = design_for(spec);
  EXPECT_LE(light.value, lightest);
  EXPECT_GE(light.value, 0.9 * lightest);
}

Spec in_steel(Spec spec) {
  spec.material = as_material(*material_named("steel"));
  spec.load = Load{10};
  return spec;
}

/// Under the limit few starts tell that a choice has no stiff design, and few bring what there is.
TEST(LoadSearch, FewStartsFindWhatManyDo) {
  SearchOptions few, many;
  few.diagnose = many.diagnose = false;
  ChoiceBudgets& choice = many.budgets.choice;
  for (ChoiceBudget* one :
       {&choice.relaxed_fixed_pole, &choice.relaxed_free_pole, &choice.fixed_pole, &choice.free_pole}) {
    one->lattice = 20;
    one->starts = one->starts_if_none = one->known_starts_if_none = 24;
  }
  choice.under_load = {.lattice = 20, .starts_if_none = 24, .fruitless = 24, .alone = 0};
  test::SpecDice dice(59);
  int compared = 0;
  for (int i = 0; i < test::samples(20); ++i) {
    Spec spec = in_steel(dice.spec());
    if (i % 3 == 0) spec.objective.objective = Objective::transmission;
    const SearchOutcome free = synthesize(spec, few);
    const auto* without = std::get_if<FoundDesign>(&free);
    if (!without || !(without->attained.load_error < HUGE_VAL)) continue;
    spec.limits.load_error = dice.uniform(0.7, 0.98) * without->attained.load_error;
    const SearchOutcome from_few = synthesize(spec, few), from_many = synthesize(spec, many);
    const auto *found = std::get_if<FoundDesign>(&from_few), *best = std::get_if<FoundDesign>(&from_many);
    ASSERT_EQ(found != nullptr, best != nullptr) << i;
    if (!found) continue;
    ++compared;
    EXPECT_LE(found->attained.load_error, *spec.limits.load_error * (1 + 1e-12)) << i;
    const double sign = is_maximized(spec.objective.objective) ? -1 : 1;
    EXPECT_LE(sign * found->value, sign * best->value + 1e-6 * std::abs(best->value)) << i;
  }
  EXPECT_GT(compared, test::expected(6));
}

/// Where no choice keeps the limit even without contact, the proof that none can comes before the search of the choices; and a search of
/// many starts that does without the proof finds none either.
TEST(LoadSearch, ProvesThatNoneIsStiffBeforeItSearches) {
  SearchOptions usual, thorough;
  usual.diagnose = thorough.diagnose = false;
  for (ChoiceBudget* one : {&thorough.budgets.choice.fixed_pole, &thorough.budgets.choice.free_pole})
    one->starts_if_none = 24;
  SearchOptions unproven = thorough;
  unproven.budgets.proof.boxes_under_load = 1;
  unproven.budgets.improve.searches = 0;
  test::SpecDice dice(61);
  int proven = 0, before_the_search = 0;
  for (int i = 0; i < test::samples(10); ++i) {
    Spec spec = in_steel(dice.spec());
    const SearchOutcome free = synthesize(spec, usual);
    const auto* without = std::get_if<FoundDesign>(&free);
    if (!without || !(without->attained.load_error < HUGE_VAL)) continue;
    spec.limits.load_error = dice.uniform(0.01, 0.9) * without->attained.load_error;
    const SearchOutcome outcome = synthesize(spec, usual), again = synthesize(spec, thorough);
    const auto *none = std::get_if<NoDesign>(&outcome), *none_again = std::get_if<NoDesign>(&again);
    ASSERT_EQ(none != nullptr, none_again != nullptr) << i;
    if (!none || !none->proven) continue;
    ++proven;
    EXPECT_FALSE(std::holds_alternative<FoundDesign>(synthesize(spec, unproven))) << i;
    before_the_search += none->evaluations == none_again->evaluations;
  }
  EXPECT_GT(proven, test::expected(2));
  EXPECT_GT(before_the_search, proven / 2);
}

TEST(LoadSearch, TakesTheLightestSectionThatKeepsTheError) {
  Spec spec = plagiograph();
  spec.objective.objective = Objective::mass;
  spec.limits.load_error = 0.1;
  const std::vector<LinkSection> sections{{6, 2}, {6, 3}, {8, 3}, {10, 4}};
  std::optional<double> best;
  LinkSection lightest;
  for (const LinkSection& section : sections) {
    use_section(spec.links.style, section);
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto* found = std::get_if<FoundDesign>(&outcome);
    if (found == nullptr || (best && found->value >= *best)) continue;
    best = found->value;
    lightest = section;
  }
  ASSERT_TRUE(best);
  use_section(spec.links.style, sections.front());
  spec.links.sections = sections;
  const FoundDesign chosen = design_for(spec);
  EXPECT_EQ(chosen.value, *best);
  EXPECT_EQ(chosen.section, lightest);
  EXPECT_NE(lightest, sections.front());  // 6 x 2 cannot
  EXPECT_FALSE(chosen.proven_bound);
}

TEST(LoadSearch, SaysWhatLimitWouldDo) {
  Spec spec = plagiograph();
  spec.limits.load_error = 0.01;
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* none = std::get_if<NoDesign>(&outcome);
  ASSERT_NE(none, nullptr);
  EXPECT_TRUE(none->proven);  // by boxes whose designs all give way by more
  const auto relaxed =
      std::find_if(none->relaxations.begin(), none->relaxations.end(),
                   [](const Relaxation& each) { return each.key == "limits.load_error_mm"; });
  ASSERT_NE(relaxed, none->relaxations.end());
  ASSERT_TRUE(relaxed->possible);
  EXPECT_LE(load_error_of(spec, relaxed->design), *relaxed->possible);
}

/// Over a grid: the best of a figure among linkages that keep all else, and their limit on the load error in all in some layers.
template <class Figure>
double best_in_all_on_a_grid(const Spec& spec, const Figure& figure) {
  double best = HUGE_VAL;
  best_on_a_grid(spec, [&](const CopyingLinkage& linkage, const OpeningInterval& openings) {
    const double value = figure(linkage);
    if (value >= best) return HUGE_VAL;
    for (const LayerAssignment& layers : layer_assignments(2))
      if (smallest_gap_over(linkage, spec.links.style, layers, openings).gap >= spec.limits.clearance &&
          give_in_all(spec, linkage, layers, openings) <= *spec.limits.load_error)
        best = value;
    return HUGE_VAL;  // it is kept here
  });
  return best;
}

/// Wide links of plastic: pins and layers are much of what they give.
Spec layered_plagiograph() {
  Spec spec = plagiograph();
  spec.links.style = {.width = 14, .pin_diameter = 4, .thickness = 6};
  spec.material = as_material(*material_named("PLA"));
  return spec;
}

TEST(LoadSearch, KeepsALimitInAll) {
  for (const auto& one : {std::pair{0.0, Objective::size}, std::pair{radians(60), Objective::mass}}) {
    const Objective objective = one.second;
    Spec spec = layered_plagiograph();
    spec.load->tilt = one.first;
    spec.objective.objective = objective;
    const FoundDesign free = design_for(spec);
    const double all =
        give_in_all(spec, free.linkage, free.layers, *openings_over(free.linkage, spec.region));
    EXPECT_GT(all, 1.4 * load_error_of(spec, free));
    for (const double share : {0.95, 0.85}) {
      spec.limits.load_error = share * all;
      spec.limits.load_error_in_all = true;
      const FoundDesign held = design_for(spec);
      const auto openings = openings_over(held.linkage, spec.region);
      ASSERT_TRUE(openings);
      const double attained = give_in_all(spec, held.linkage, held.layers, *openings);
      EXPECT_LE(attained, *spec.limits.load_error * (1 + 1e-9));
      EXPECT_EQ(attained, held.attained.load_error);
      const bool by_size = objective == Objective::size;
      const double on_a_grid = best_in_all_on_a_grid(spec, [&](const CopyingLinkage& linkage) {
        return by_size ? linkage.size() : mass_of_links(linkage, spec);
      });
      EXPECT_LE(held.value, 1.002 * on_a_grid);
      EXPECT_GE(held.value, 0.9 * on_a_grid);
      spec.limits.load_error_in_all = false;
      EXPECT_LT(design_for(spec).value, held.value);  // the links alone keep it with less
    }
  }
}

/// Where pins and layers are most of what the pen gives, the first designs lie far inside the limit of the links.
TEST(LoadSearch, ALooserLimitInAllIsNoWorse) {
  for (const char* name : {"half-turn", "shop-reducer", "matlab-circle"}) {
    SCOPED_TRACE(name);
    Spec spec = in_steel(test::shipped_spec(name));
    const FoundDesign free = design_for(spec);
    const double all =
        give_in_all(spec, free.linkage, free.layers, *openings_over(free.linkage, spec.region));
    spec.limits.load_error_in_all = true;
    double before = free.value;
    for (const double share : {0.999, 0.98, 0.9}) {
      spec.limits.load_error = share * all;
      const FoundDesign held = design_for(spec);
      EXPECT_LE(held.attained.load_error, *spec.limits.load_error * (1 + 1e-9));
      EXPECT_GE(held.value, before * (1 - 1e-4)) << share;
      EXPECT_LE(held.value, before * 1.05) << share;
      before = held.value;
    }
  }
}

/// What is said to do does, counted in all.
TEST(LoadSearch, SaysWhatLimitInAllWouldDo) {
  Spec spec = layered_plagiograph();
  spec.limits.load_error = 0.02;
  spec.limits.load_error_in_all = true;
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* none = std::get_if<NoDesign>(&outcome);
  ASSERT_NE(none, nullptr);
  const auto relaxed =
      std::find_if(none->relaxations.begin(), none->relaxations.end(),
                   [](const Relaxation& each) { return each.key == "limits.load_error_mm"; });
  ASSERT_NE(relaxed, none->relaxations.end());
  ASSERT_TRUE(relaxed->possible);
  for (const Relaxation& one : none->relaxations)
    EXPECT_LE(one.design.attained.load_error,
              (1 + 1e-9) * (one.key == "limits.load_error_mm" ? *one.possible : *spec.limits.load_error))
        << one.sentence;
  spec.limits.load_error = *relaxed->possible;
  EXPECT_LE(design_for(spec).attained.load_error, *spec.limits.load_error * (1 + 1e-9));
}

/// The engraver's pantograph of the examples in one grounding, with a limit on the sag that its smallest instrument does not keep.
Spec engraver_with_a_limit_on_sag() {
  Spec spec;
  spec.copy = Copy::of(0.4, 0);
  spec.region = Region::rectangle({-131.25, 0}, {262.5, 185});
  spec.pole.place = Point(0, 330);
  spec.links.style = {.width = 15, .pin_diameter = 8, .thickness = 5};
  spec.links.shortest = 30;
  spec.links.longest = 400;
  spec.limits.clearance = 1;
  spec.limits.transmission = radians(30);
  spec.limits.copy_gap = 5;
  spec.limits.sag = 3.5;
  spec.tolerance = Tolerance{0.05, 0.02};
  spec.material = as_material(*material_named("steel"));
  spec.load = Load{10};
  spec.objective.groundings = {Grounding::pen};
  return spec;
}

TEST(SagSearch, FindsADesignThatALocalSolutionLeaves) {
  const Spec spec = engraver_with_a_limit_on_sag();
  const FoundDesign found = design_for(spec);
  EXPECT_TRUE(check_design(spec, requirements_of(spec), found.linkage, found.layers).feasible);
  EXPECT_LE(found.value, 551.5);  // what a search with a stricter limit on the longest link finds
}

TEST(SagSearch, DifferentSeedsComeToTheSameDesign) {
  const Spec spec = engraver_with_a_limit_on_sag();
  std::vector<double> values;
  for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
    SearchOptions options;
    options.seed = seed;
    options.diagnose = false;
    const SearchOutcome outcome = synthesize(spec, options);
    const auto* found = std::get_if<FoundDesign>(&outcome);
    ASSERT_NE(found, nullptr);
    EXPECT_GE(found->attained.sag, *spec.limits.sag * (1 - 1e-4));  // it binds
    values.push_back(found->value);
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  EXPECT_LT(*most, *least * (1 + 1e-5));
}

TEST(SagSearch, SaysOfNoLimitThatIsKeptThatItIsInTheWay) {
  Spec spec = engraver_with_a_limit_on_sag();
  spec.limits.sag = 1;
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* none = std::get_if<NoDesign>(&outcome);
  ASSERT_NE(none, nullptr);
  EXPECT_FALSE(none->proven);
  for (const Relaxation& each : none->relaxations) {
    EXPECT_FALSE(check_design(spec, requirements_of(spec), each.design.linkage, each.design.layers).feasible)
        << each.sentence;
    if (each.limit && each.possible) {
      EXPECT_EQ(is_maximized(*each.limit), *each.possible < each.demanded) << each.sentence;
    }
  }
}

double sag_of(const Spec& spec, const FoundDesign& design) {
  const auto openings = openings_over(design.linkage, spec.region);
  EXPECT_TRUE(openings);
  return largest_sag(design.linkage, sag_conditions(spec, design.layers), *openings).sag.most();
}

TEST(SagSearch, NamesLessThanTheSagOfTheDesignWithoutTheLimit) {
  Spec spec = engraver_with_a_limit_on_sag();
  spec.objective.groundings = {Grounding::pole, Grounding::pen};
  spec.limits.sag = std::nullopt;
  const double free = sag_of(spec, design_for(spec));
  spec.limits.sag = 1;
  SearchOptions options;
  options.budgets.diagnosis.evaluations = 200'000;  // the sag comes first
  options.budgets.diagnosis.one_limit = 1;
  const SearchTask task = pose(spec, SearchControl(options));
  const Diagnosis diagnosis = diagnose(task, {}, {0, 0});
  const auto& all = diagnosis.none.relaxations;
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Relaxation& one) { return one.key == "limits.sag_mm"; });
  ASSERT_NE(found, all.end());
  EXPECT_LE(sag_of(spec, found->design), *found->possible);
  EXPECT_GT(*found->possible, found->demanded);
  EXPECT_LT(*found->possible, 0.9 * free);
  spec.limits.sag = found->possible;
  EXPECT_LE(sag_of(spec, design_for(spec)), *found->possible);  // a search with it finds a design
}

TEST(SagSearch, ThinnerPartsAreTriedFromThickToThin) {
  Spec spec = plagiograph();
  spec.load->pen_mass = 1;
  const FoundDesign free = design_for(spec);
  spec.limits.sag = 1.1 * sag_of(spec, free);
  SearchOptions options;
  options.budgets.diagnosis.halvings = 1;
  const SearchTask task = pose(spec, SearchControl(options));
  Questions questions(task, {0, 0}, false);
  const auto thinner = thinned(questions, &LinkStyle::pin_diameter, 0.3);  // a pin of 0.3 mm bends too much
  ASSERT_TRUE(thinner);
  EXPECT_GT(thinner->value, 0.3);
  EXPECT_FALSE(thinner->is_least);
}

TEST(SectionSearch, AsksWhyThereIsNoDesignOnlyWhereThereIsNone) {
  Spec spec = plagiograph();
  spec.links.sections = {{6, 2}, {6, 3}, {8, 3}};
  const FoundDesign one{*CopyingLinkage::make(1.4, Grounding::pole, 1, 1, 0), LayerAssignment{}};
  for (const bool first_has_one : {true, false}) {
    std::vector<bool> asked;
    const auto search = [&](const Spec&, const SearchOptions& options) -> SearchOutcome {
      asked.push_back(options.diagnose);
      if (first_has_one && asked.size() == 1) return one;
      return NoDesign{};
    };
    best_of_sections(spec, {}, search);
    EXPECT_EQ(asked, (std::vector<bool>{false, false, !first_has_one}));
  }
}

TEST(LoadCheck, InfiniteFiguresKeepNoLimit) {
  Spec spec = plagiograph();
  const FoundDesign found = design_for(spec);
  spec.limits.load_error = 0.5;
  spec.links.style.width = spec.links.style.thickness = 1e-100;
  const DesignCheck check = check_design(spec, requirements_of(spec), found.linkage, found.layers);
  EXPECT_EQ(check.attained.load_error, HUGE_VAL);
  EXPECT_EQ(check.broken, Goal::load_error);
}

TEST(LoadCheck, ASagThatIsNoNumberKeepsNoLimit) {
  Spec spec = plagiograph();
  const FoundDesign found = design_for(spec);
  spec.limits.sag = 1000;
  spec.links.style.thickness = 1e-110;
  const DesignCheck check = check_design(spec, requirements_of(spec), found.linkage, found.layers);
  EXPECT_EQ(check.attained.sag, HUGE_VAL);
  EXPECT_EQ(check.broken, Goal::sag);
}

}  // namespace
}  // namespace kempe
