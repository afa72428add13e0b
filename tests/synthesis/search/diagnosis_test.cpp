// Exit 3: what is in the way, and the least that would do.
#include "synthesis/search/diagnosis/diagnosis.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "specs/hardware.hpp"
#include "specs/materials.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"
#include "synthesis/search/pareto.hpp"
#include "synthesis/search/section_search.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "tests/synthesis/shipped_spec.hpp"

namespace kempe {
namespace {

Requirements with(Requirements limits, Goal goal, double value) {
  switch (goal) {
    case Goal::transmission: limits.transmission = value; break;
    case Goal::clearance: limits.clearance = value; break;
    case Goal::shortest: limits.shortest = value; break;
    case Goal::longest: limits.longest = value; break;
    case Goal::copy_gap: limits.copy_gap = value; break;
    case Goal::copy_error: limits.copy_error = value; break;
    case Goal::pole_margin: limits.pole_margin = value; break;
    case Goal::load_error: limits.load_error = value; break;
    default: ADD_FAILURE() << "not a limit";
  }
  return limits;
}

NoDesign nothing_for(const Spec& spec) {
  const SearchOutcome outcome = synthesize(spec, {});
  const auto* none = std::get_if<NoDesign>(&outcome);
  EXPECT_TRUE(none) << "there is a design";
  return none ? *none : NoDesign{};
}

/// The value that stands before "would do".
double enough(const std::string& sentence) {
  const std::string words = " would do";
  const std::size_t end = sentence.find(words), start = sentence.rfind(' ', end - 1);
  EXPECT_NE(end, std::string::npos) << sentence;
  return std::stod(sentence.substr(start));
}

/// The place in "the pole at (12.5, -3) mm would do".
Point place_in(const std::string& sentence) {
  Point place;
  const std::size_t at = sentence.find("the pole at (");
  EXPECT_NE(at, std::string::npos) << sentence;
  EXPECT_EQ(std::sscanf(sentence.c_str() + at, "the pole at (%lf, %lf)", &place.x(), &place.y()), 2);
  return place;
}

/// The area in which the pole may stand, grown by a square of twice the margin: it holds all that is so far outside.
Region grown_box(const Region& area, double margin) {
  const Box box = bounding_box(area);
  const Point more(margin, margin);
  return Region::rectangle(box.lower - more, box.upper - box.lower + 2 * more);
}

void leave_out_lock(Spec& spec, const std::string& key) {
  for (std::size_t i = 0; i < 8; ++i)
    if (key == "links." + std::string(LinkLengths::names[i]) + "_mm")
      spec.links.stock_lengths.locked[i] = std::nullopt;
}

/// What a person makes of a relaxation who reads nothing but its key and its sentence.
Spec as_told(Spec spec, const std::string& key, const std::string& sentence) {
  const bool left_out = sentence.find("left out") != std::string::npos;
  const auto value = [&] { return enough(sentence); };
  if (key == "limits.transmission_deg") spec.limits.transmission = radians(value());
  if (key == "limits.clearance_mm") spec.limits.clearance = value();
  if (key == "limits.sheets_gap_mm")
    spec.limits.copy_gap = left_out ? std::nullopt : std::optional<double>(value());
  if (key == "limits.copy_error_mm")
    spec.limits.copy_error = left_out ? std::nullopt : std::optional<double>(value());
  if (key == "limits.load_error_mm")
    spec.limits.load_error = left_out ? std::nullopt : std::optional<double>(value());
  if (key == "limits.sag_mm") spec.limits.sag = left_out ? std::nullopt : std::optional<double>(value());
  if (key == "links.longest_mm") spec.links.longest = value();
  if (key == "limits.longest_strip_mm") spec.limits.longest_strip = value();
  if (key == "links.hardware") {
    const std::size_t from = sentence.rfind('"', sentence.rfind('"') - 1) + 1;
    spec.links.hardware = sentence.substr(from, sentence.rfind('"') - from);
    spec.links.style.pin_diameter = hardware_named(spec.links.hardware.every)->pin;
  }
  if (key == "links.shortest_mm") spec.links.shortest = value();
  if (key == "links.wall_mm") spec.links.wall = value();
  if (key == "links.pin_diameter_mm") spec.links.style.pin_diameter = value();
  if (key == "links.width_mm") spec.links.style.width = value();
  if (key == "links.thickness_mm") spec.links.style.thickness = value();
  if (key == "links.sections_mm") {
    const std::size_t by = sentence.rfind(" x "), with = sentence.rfind("with ");
    spec = with_section(spec, {std::stod(sentence.substr(with + 5)), std::stod(sentence.substr(by + 3))});
  }
  if (key == "load.rests")
    spec.load->rests.push_back(sentence.ends_with("with \"pen\" added a design exists") ? Carrier::pen
                                                                                        : Carrier::tracer);
  if (key == "load.grip_mm") spec.load->grip = value();
  if (key == "tolerance.play_mm") spec.tolerance->play = value();
  if (key == "material.name" || key == "material") {
    const std::size_t from = sentence.rfind('"', sentence.rfind('"') - 1) + 1;
    spec.material = as_material(*material_named(sentence.substr(from, sentence.rfind('"') - from)));
  }
  if (key == "links.layers") spec.links.layers = static_cast<int>(value());
  if (key == "links.grid_mm") spec.links.stock_lengths.grid = std::nullopt;
  if (key == "links.stock_mm") spec.links.stock_lengths.stock.clear();
  if (key == "objective.groundings")
    spec.objective.groundings = {all_groundings.begin(), all_groundings.end()};
  leave_out_lock(spec, key);
  if (key == "pole.at_mm") spec.pole.place = place_in(sentence);
  if (key == "pole.within_mm" && sentence.find("the pole at") != std::string::npos)
    spec.pole.place = place_in(sentence);
  else if (key == "pole.within_mm")
    spec.pole.place = grown_box(std::get<Region>(spec.pole.place),
                                std::stod(sentence.substr(sentence.find("pole ", 8) + 5)));
  if (key == "obstacles" && sentence.starts_with("the obstacles"))
    spec.obstacles.clear();
  else if (key == "obstacles")
    std::erase_if(spec.obstacles,
                  [&](const Obstacle& one) { return sentence.starts_with(one.name + " is"); });
  return spec;
}

bool has_design(const Spec& spec) {
  return std::holds_alternative<FoundDesign>(synthesize(spec, {.diagnose = false}));
}

/// Each relaxation as told gives a design, its own design keeps all other limits, and a hundredth less of it leaves nothing.
void check(const Spec& spec, const NoDesign& none) {
  const SearchTask task = pose(spec, SearchControl({.diagnose = false}));
  for (const Relaxation& relaxation : none.relaxations) {
    SCOPED_TRACE(relaxation.sentence);
    EXPECT_TRUE(has_design(as_told(spec, relaxation.key, relaxation.sentence)));
    if (!relaxation.limit || !relaxation.possible) continue;
    if (relaxation.key == "links.pin_diameter_mm") continue;  // thinner pins move more than one limit
    const Requirements moved = with(requirements_of(spec), *relaxation.limit, *relaxation.possible);
    const DesignCheck design = check_design(spec, moved, relaxation.design.linkage, relaxation.design.layers);
    EXPECT_TRUE(design.feasible) << (design.broken ? name(*design.broken) : "");
    const double less = relaxation.demanded + 0.98 * (*relaxation.possible - relaxation.demanded);
    EXPECT_FALSE(
        best_design(task.with(with(requirements_of(spec), *relaxation.limit, less), Goal::size)).design)
        << "less would do: " << less;
  }
}

TEST(Diagnosis, OfTooLargeATransmissionAngle) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.limits.transmission = radians(75);
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_FALSE(none.requirement.empty());
  EXPECT_NE(none.sentence.find("would do"), std::string::npos);
  check(spec, none);
}

TEST(Diagnosis, OfLinksTooShortForTheRegion) {
  Spec spec = test::shipped_spec("nameplate");
  spec.links.longest = 60;
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.requirement, "links.longest_mm");
  check(spec, none);
}

TEST(Diagnosis, OfAStripTooShortForTheRegion) {
  Spec spec = test::shipped_spec("nameplate");
  spec.limits.longest_strip = 60 + spec.links.style.width;
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.requirement, "limits.longest_strip_mm");
  for (const Relaxation& relaxation : none.relaxations) EXPECT_NE(relaxation.key, "links.longest_mm");
  check(spec, none);
}

/// A plagiograph with lengths up to 72 mm, which leave joints 41.8 mm apart at most.
Spec short_arms(double pin, std::optional<double> wall = std::nullopt) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.links.longest = 72;
  spec.links.shortest = 0.5;
  spec.links.style.width = 44.5;
  spec.links.style.pin_diameter = pin;
  spec.links.wall = wall;
  spec.limits.clearance = 0;
  spec.links.layers = 4;
  return spec;
}

Spec with_value(Spec spec, const std::string& key, double value) {
  if (key == "links.wall_mm")
    spec.links.wall = value;
  else
    spec.links.style.pin_diameter = value;
  return spec;
}

TEST(Diagnosis, OfHolesThatKeepJointsApartNamesWallOrPin) {
  const std::tuple<Spec, std::string, double> cases[] = {{short_arms(6, 40), "links.wall_mm", 40},
                                                         {short_arms(39), "links.wall_mm", 3.9},
                                                         {short_arms(44), "links.pin_diameter_mm", 44},
                                                         {short_arms(44, 0.3), "links.pin_diameter_mm", 44}};
  for (const auto& [spec, key, demanded] : cases) {
    const NoDesign none = nothing_for(spec);
    const auto by_holes = std::find_if(none.relaxations.begin(), none.relaxations.end(),
                                       [](const Relaxation& one) { return one.limit == Goal::shortest; });
    ASSERT_NE(by_holes, none.relaxations.end()) << none.sentence;
    SCOPED_TRACE(by_holes->sentence);
    EXPECT_EQ(by_holes->key, key);
    EXPECT_NE(by_holes->sentence.find("two holes of"), std::string::npos);
    const double value = enough(by_holes->sentence), less = demanded + 0.97 * (value - demanded);
    EXPECT_GT(value, 0);
    EXPECT_TRUE(
        std::holds_alternative<FoundDesign>(synthesize(with_value(spec, key, value), {.diagnose = false})));
    EXPECT_FALSE(
        std::holds_alternative<FoundDesign>(synthesize(with_value(spec, key, less), {.diagnose = false})));
    check(spec, none);
  }
}

TEST(Diagnosis, AStockLengthNearerThanItsHolesIsNamedWithoutASearch) {
  const Spec base = test::shipped_spec("plagiograph");
  const double pin = base.links.style.pin_diameter;
  std::vector<Spec> specs(4, base);
  specs[0].links.stock_lengths.locked[4] = 1.05 * pin;
  specs[1].links.stock_lengths.stock = {0.5 * pin, pin, 1.09 * pin};
  specs[2].links.stock_lengths.grid = 1.09 * pin;
  specs[2].links.longest = 2 * pin;
  specs[3].links.longest = 1.09 * pin;
  for (Spec& spec : specs) {
    spec.links.shortest = 0.1 * pin;
    const NoDesign none = nothing_for(spec);
    EXPECT_EQ(none.requirement, "links.pin_diameter_mm");
    EXPECT_TRUE(none.proven);
    EXPECT_EQ(none.evaluations, 0U);
    const double fits = std::stod(none.sentence.substr(none.sentence.rfind("; ") + 2));
    EXPECT_LT(fits, pin);
    EXPECT_GT(fits, 0.9 * pin);
    const auto front = pareto_front(spec, Objective::size, Objective::transmission, 3, {});
    ASSERT_FALSE(front);
    EXPECT_EQ(front.error().requirement, none.requirement);
    spec.links.style.pin_diameter = fits;
    EXPECT_FALSE(plainly_impossible(spec));
  }
}

/// On an upright table, whatever the links are: by the play of the post's bearing alone.
TEST(Diagnosis, OfAPostThatTiltsTooFar) {
  Spec spec = test::shipped_spec("pantorouter-upright");
  ASSERT_FALSE(plainly_impossible(spec));
  spec.limits.sag = 0.3;
  const auto plain = plainly_impossible(spec);
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->requirement, "limits.sag_mm");
  const NoDesign none = nothing_for(spec);
  EXPECT_TRUE(none.proven);
  ASSERT_FALSE(none.relaxations.empty());
  for (const Relaxation& relaxation : none.relaxations)
    EXPECT_TRUE(has_design(as_told(spec, relaxation.key, relaxation.sentence))) << relaxation.sentence;
  // No less than the post's own part is enough, and with that it is no plain reason any more.
  const double alone = std::hypot(450, 70) * spec.tolerance->play / *spec.load->grip;
  spec.limits.sag = 0.999 * alone;
  EXPECT_TRUE(plainly_impossible(spec));
  spec.limits.sag = 1.001 * alone;
  EXPECT_FALSE(plainly_impossible(spec));
  Spec enlarging =
      spec;  // there the pen is farther away; how far is not known where stock lengths may ask for another ratio
  enlarging.copy = Copy::of(2, 0);
  EXPECT_TRUE(plainly_impossible(enlarging));
  enlarging.links.stock_lengths.grid = 5;
  EXPECT_FALSE(plainly_impossible(enlarging));
  spec.limits.sag = 0.3;
  spec.load->tilt = 0;  // what weights do is not known before there are links
  EXPECT_FALSE(plainly_impossible(spec));
}

TEST(Diagnosis, OfATightCopyError) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.tolerance = Tolerance{0.1, 0.05};
  spec.limits.copy_error = 0.01;
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.relaxations.front().limit, Goal::copy_error);
  check(spec, none);
}

TEST(Diagnosis, OfRandomSpecs) {
  test::SpecDice dice(61);
  int seen = 0;
  for (int i = 0; i < 40 && seen < test::samples(6); ++i) {
    Spec spec = dice.spec();
    spec.limits.transmission = radians(dice.uniform(30, 60));
    spec.links.longest = dice.uniform(100, 400);
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    if (!std::holds_alternative<NoDesign>(outcome)) continue;
    ++seen;
    check(spec, nothing_for(spec));
  }
  EXPECT_GE(seen, test::samples(4));
}

TEST(Diagnosis, AnObstacleInTheWayIsNamed) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.obstacles.push_back(
      {{{{-200, -200}, {-190, -200}, {-190, -190}, {-200, -190}}, {}}, 1, 8, "harmless block"});
  const Point corner = spec.region.polygons[0].outer[0];
  const double x = corner.x(), y = corner.y();
  spec.obstacles.push_back(
      {{{{x - 3, y - 3}, {x + 3, y - 3}, {x + 3, y + 3}, {x - 3, y + 3}}, {}}, 1, 8, "clamp"});
  const NoDesign none = nothing_for(spec);
  EXPECT_EQ(none.requirement, "obstacles");
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_NE(none.sentence.find("clamp is in the way"), std::string::npos) << none.sentence;
}

TEST(Diagnosis, AnObstacleOverThePoleIsNamedWithoutASearch) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.obstacles.push_back({{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {}}, 1, 1, "vice"});
  const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
  ASSERT_TRUE(std::holds_alternative<NoDesign>(outcome));
  EXPECT_EQ(std::get<NoDesign>(outcome).requirement, "obstacles");
  EXPECT_EQ(std::get<NoDesign>(outcome).evaluations, 0U);
  const NoDesign none = nothing_for(spec);
  EXPECT_TRUE(none.proven);
  EXPECT_EQ(none.relaxations.size(), 2U);  // the obstacle away, or the pole elsewhere
  check(spec, none);
}

TEST(Diagnosis, APoleInTheRegionIsToldWithItsPlaceAndWhereItCouldStand) {
  for (const Point& off : {Point(0, 0), Point(7000, -3000)}) {
    Spec spec = test::shipped_spec("plagiograph");
    spec.region = Region::rectangle(off - Point(10, 10), {20, 20});
    spec.pole.place = Point(off + Point(2, 3));
    const NoDesign none = nothing_for(spec);
    EXPECT_EQ(none.requirement, "pole.at_mm");
    EXPECT_TRUE(none.proven);
    EXPECT_NE(none.sentence.find(off.x() == 0 ? "(2, 3) mm" : "(7002, -2997) mm"), std::string::npos)
        << none.sentence;
    ASSERT_EQ(none.relaxations.size(), 1U);
    EXPECT_FALSE(contains(spec.region, place_in(none.relaxations[0].sentence)));
    check(spec, none);
  }
}

/// The copy of x 100..300 at scale 1/2 lies at 50..150: half of it on the original, wherever links can stand.
Spec copy_on_its_original(double gap) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.copy = Copy::of(0.5, 0);
  spec.region = Region::rectangle({100, -60}, {200, 120});
  spec.pole.place = Point(0, 0);
  spec.links = LinkSpec{};
  spec.limits = Limits{};
  spec.limits.copy_gap = gap;
  return spec;
}

TEST(Diagnosis, ACopyOnItsOriginalNeedsAnotherPoleOrNoGap) {
  for (const double gap : {5.0, 0.001, 0.0}) {
    const Spec spec = copy_on_its_original(gap);
    const NoDesign none = nothing_for(spec);
    EXPECT_TRUE(none.proven);
    EXPECT_EQ(none.requirement, "limits.sheets_gap_mm");
    EXPECT_NE(none.sentence.find("overlaps the original, whatever the links are"), std::string::npos);
    ASSERT_EQ(none.relaxations.size(), 2U);
    EXPECT_EQ(none.relaxations[0].key, "limits.sheets_gap_mm");
    EXPECT_EQ(none.relaxations[1].key, "pole.at_mm");
    check(spec, none);
  }
}

TEST(Diagnosis, ACopyTooNearItsOriginalIsToldHowNearItLies) {
  Spec spec = copy_on_its_original(40);
  spec.region = Region::rectangle({100, -10}, {60, 20});  // its copy ends at 80
  const NoDesign none = nothing_for(spec);
  EXPECT_NE(none.sentence.find("lies 20 mm from the original"), std::string::npos) << none.sentence;
  ASSERT_EQ(none.relaxations.size(), 2U);
  EXPECT_NEAR(*none.relaxations[0].possible, 20, 0.1);
  check(spec, none);
}

TEST(Diagnosis, APoleThatMayStandNowhereWithoutOverlapLosesTheGap) {
  Spec spec = copy_on_its_original(5);
  spec.pole.place = Region::rectangle({-5, -5}, {10, 10});
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.relaxations.front().key, "limits.sheets_gap_mm");
  EXPECT_FALSE(none.relaxations.front().possible);
  check(spec, none);
}

NoDesign nothing_within(const Spec& spec, std::uint64_t evaluations) {
  SearchOptions options;
  options.budgets.diagnosis.evaluations = evaluations;
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* none = std::get_if<NoDesign>(&outcome);
  EXPECT_TRUE(none) << "there is a design";
  return none ? *none : NoDesign{};
}

std::uint64_t evaluations_undiagnosed(const Spec& spec) {
  const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
  const auto* none = std::get_if<NoDesign>(&outcome);
  EXPECT_TRUE(none) << "there is a design";
  return none ? none->evaluations : 0;
}

bool says_it_may_be_smaller(const std::string& sentence) {
  return sentence.find("a smaller change may do") != std::string::npos;
}

/// Too short links, and too large an angle of transmission.
std::vector<Spec> specs_without_designs() {
  Spec short_links = test::shipped_spec("nameplate");
  short_links.links.longest = 60;
  Spec large_angle = test::shipped_spec("plagiograph");
  large_angle.limits.transmission = radians(75);
  return {short_links, large_angle};
}

TEST(Diagnosis, EndsWithItsBudgetAndSaysWhatNeedNotBeTheLeast) {
  int not_least = 0;
  for (const Spec& spec : specs_without_designs()) {
    const std::uint64_t before = evaluations_undiagnosed(spec);
    const NoDesign whole = nothing_for(spec);
    EXPECT_TRUE(whole.diagnosed);
    for (const Relaxation& one : whole.relaxations) EXPECT_TRUE(one.is_least) << one.sentence;
    std::uint64_t last = before;
    // Each search counts as 20 000 evaluations at least: so many searches may begin.
    for (const std::uint64_t searches : {0U, 1U, 3U, 5U, 7U}) {
      SCOPED_TRACE(searches);
      const NoDesign none = nothing_within(spec, searches * DiagnosisBudget{}.least_of_search);
      EXPECT_FALSE(none.diagnosed);
      EXPECT_GE(none.evaluations, last) << "more budget, more work";
      EXPECT_LE(none.evaluations, whole.evaluations);
      EXPECT_TRUE(searches > 0 || none.evaluations == before) << "no budget, no search";
      last = none.evaluations;
      for (const Relaxation& one : none.relaxations) {
        EXPECT_EQ(one.is_least, !says_it_may_be_smaller(one.sentence)) << one.sentence;
        EXPECT_TRUE(has_design(as_told(spec, one.key, one.sentence))) << one.sentence;
        not_least += !one.is_least;
      }
      const NoDesign again = nothing_within(spec, searches * DiagnosisBudget{}.least_of_search);
      EXPECT_EQ(again.sentence, none.sentence);
      EXPECT_EQ(again.evaluations, none.evaluations);
    }
  }
  EXPECT_GT(not_least, 0);
}

TEST(Diagnosis, AnEvaluationAmongObstaclesCountsAsSeveral) {
  Spec spec = test::shipped_spec("clamped-plate");
  spec.limits.transmission = radians(75);
  const auto counted_as = [&](std::uint64_t several) {
    SearchOptions options;
    options.budgets.diagnosis.among_obstacles = several;
    const SearchOutcome outcome = synthesize(spec, options);
    const auto* none = std::get_if<NoDesign>(&outcome);
    EXPECT_TRUE(none) << "there is a design";
    return none ? *none : NoDesign{};
  };
  const NoDesign whole = counted_as(DiagnosisBudget{}.among_obstacles), cut = counted_as(1'000'000);
  EXPECT_TRUE(whole.diagnosed);
  EXPECT_FALSE(cut.diagnosed);
  EXPECT_LE(cut.evaluations, whole.evaluations);
}

/// Links so thin that no value which may be stated is enough.
TEST(Diagnosis, ALimitOnTheLoadErrorThatNoStatedValueHelpsIsLeftOut) {
  Spec spec;
  spec.copy = Copy::of(0.5, 0);
  spec.region = Region::rectangle(Point(100, -20), Point(40, 40));
  spec.pole.place = Point(0, 0);
  spec.links.style = {.width = 3, .pin_diameter = 1.5, .thickness = 0.2};
  spec.links.layers = 3;
  spec.material = Material{"acrylic", 3000, 1190, 70};
  spec.load = Load{.pen_force = 400};
  spec.limits.load_error = 500;
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.relaxations.front().sentence,
            "limits.load_error_mm = 500 is in the way; left out, a design exists");
  EXPECT_FALSE(none.relaxations.front().possible);
  check(spec, none);
}

const Relaxation* of_key(const NoDesign& none, const std::string& key) {
  const auto found = std::find_if(none.relaxations.begin(), none.relaxations.end(),
                                  [&](const Relaxation& one) { return one.key == key; });
  return found == none.relaxations.end() ? nullptr : &*found;
}

/// The nameplate in PLA of one section, with a limit on the load error of a share of what its best design has.
Spec soft_nameplate(double share) {
  Spec spec = test::shipped_spec("nameplate-pla");
  spec.links.sections.clear();
  use_section(spec.links.style, {15, 5});
  spec.limits.load_error.reset();
  const auto outcome = synthesize(spec, {.diagnose = false});
  spec.limits.load_error = share * std::get<FoundDesign>(outcome).attained.load_error;
  return spec;
}

TEST(Diagnosis, LargerSectionsAndAStifferMaterialAreNamedWhereLinksAreTooSoft) {
  const Spec spec = soft_nameplate(0.4);
  const NoDesign none = nothing_for(spec);
  for (const char* key : {"limits.load_error_mm", "links.width_mm", "links.thickness_mm", "material.name"})
    EXPECT_NE(of_key(none, key), nullptr) << key;
  check(spec, none);
  for (const auto& [key, step] : {std::pair{"links.width_mm", 1.0}, std::pair{"links.thickness_mm", 0.5}}) {
    const Relaxation* one = of_key(none, key);
    ASSERT_NE(one, nullptr);
    EXPECT_TRUE(one->is_least);
    const double size = enough(one->sentence);
    EXPECT_EQ(std::fmod(size, step), 0) << one->sentence;
    EXPECT_FALSE(has_design(as_told(spec, key, fmt::format("in the way; {} would do", size - step))))
        << one->sentence;
  }
}

/// Figures of its own have to go with its name.
TEST(Diagnosis, InsteadOfAMaterialOfTheSpecsOwnAKnownOneIsNamed) {
  Spec spec = soft_nameplate(0.4);
  spec.material->E *= 0.9;
  const NoDesign none = nothing_for(spec);
  ASSERT_NE(of_key(none, "material"), nullptr) << none.sentence;
  EXPECT_EQ(of_key(none, "material")->sentence,
            "the material \"PLA\", with figures of its own, is in the way; \"birch plywood\" without them "
            "would do");
  EXPECT_EQ(of_key(none, "material.name"), nullptr);
  check(spec, none);
}

TEST(Diagnosis, WhereAllSectionsAreTooSoftAnotherIsNamed) {
  Spec spec = soft_nameplate(0.1);
  spec.links.sections = {{10, 5}, {15, 5}};
  const NoDesign none = nothing_for(spec);
  EXPECT_NE(of_key(none, "links.sections_mm"), nullptr) << none.sentence;
  EXPECT_EQ(of_key(none, "links.width_mm"), nullptr);
  check(spec, none);
}

TEST(Diagnosis, ALimitInNanometresGivesWayByAShareOfItself) {
  Spec spec = test::shipped_spec("micro-manipulator");
  spec.limits.load_error = 3e-6;
  const NoDesign none = nothing_for(spec);
  const Relaxation* limit = of_key(none, "limits.load_error_mm");
  ASSERT_NE(limit, nullptr) << none.sentence;
  EXPECT_LT(*limit->possible, 1.002 * limit->design.attained.load_error);
  check(spec, none);
}

TEST(Diagnosis, StifferLinksAreNotAskedForWhereAnotherLimitIsInTheWay) {
  Spec spec = soft_nameplate(2);
  spec.limits.transmission = radians(85);
  const NoDesign none = nothing_for(spec);
  for (const char* key : {"links.thickness_mm", "material.name"})
    EXPECT_EQ(of_key(none, key), nullptr) << key;
}

/// The nameplate in steel of one section and grounding, with a limit on the sag, most of which is by pins that tilt within their play.
Spec sagging_nameplate(double limit) {
  Spec spec = test::shipped_spec("nameplate-steel");
  spec.objective.groundings = {Grounding::pole};
  spec.links.layers = 2;
  spec.links.sections.clear();
  use_section(spec.links.style, {20, 5});
  spec.limits.load_error.reset();
  spec.limits.sag = limit;
  return spec;
}

TEST(Diagnosis, RestsALongerGripAndLessPlayAreNamedWherePinsTiltTooFar) {
  const Spec spec = sagging_nameplate(2);
  const NoDesign none = nothing_for(spec);
  for (const char* key : {"limits.sag_mm", "load.rests", "load.grip_mm", "tolerance.play_mm"})
    EXPECT_NE(of_key(none, key), nullptr) << key;
  check(spec, none);
  const auto is_least = [&](const char* key, double less) {
    const Relaxation* one = of_key(none, key);
    ASSERT_NE(one, nullptr);
    EXPECT_TRUE(one->is_least);
    const double size = enough(one->sentence);
    EXPECT_FALSE(has_design(as_told(spec, key, fmt::format("in the way; {} would do", size + less))))
        << one->sentence;
  };
  is_least("load.grip_mm", -0.5);
  is_least("tolerance.play_mm", 0.001);
  EXPECT_TRUE(
      of_key(none, "load.grip_mm")
          ->sentence.starts_with("load.grip_mm, left out, is the links' thickness, 5, which is in the way"));
}

/// A grip that the spec states is told as any value is; on a tilted table nothing rests.
TEST(Diagnosis, OnATiltedTableNothingIsToldToRest) {
  Spec spec = sagging_nameplate(2);
  spec.load->grip = 5;
  spec.load->tilt = radians(5);
  const NoDesign none = nothing_for(spec);
  EXPECT_EQ(of_key(none, "load.rests"), nullptr);
  const Relaxation* grip = of_key(none, "load.grip_mm");
  ASSERT_NE(grip, nullptr) << none.sentence;
  EXPECT_TRUE(grip->sentence.starts_with("load.grip_mm = 5 is in the way; ")) << grip->sentence;
  check(spec, none);
}

/// Every single key that restricts designs, left out or at the loosest value that a spec may state.
std::vector<std::pair<std::string, Spec>> each_left_out(const Spec& spec) {
  std::vector<std::pair<std::string, Spec>> specs;
  const auto add = [&](const char* key) -> Spec& { return specs.emplace_back(key, spec).second; };
  add("transmission").limits.transmission = 0;
  add("clearance").limits.clearance = 0;
  add("sheets gap").limits.copy_gap = std::nullopt;
  add("copy error").limits.copy_error = std::nullopt;
  add("longest").links.longest = 1e6;
  add("shortest").links.shortest = 1e-3;
  add("wall").links.wall = 1e-6;
  add("pin").links.style.pin_diameter *= 1e-3;
  add("width").links.style.width = spec.links.style.pin_diameter;
  add("layers").links.layers = 4;
  add("groundings").objective.groundings = {all_groundings.begin(), all_groundings.end()};
  add("obstacles").obstacles.clear();
  add("grid").links.stock_lengths.grid = std::nullopt;
  add("locks").links.stock_lengths.locked[0] = std::nullopt;
  const Box box = bounding_box(spec.region);
  const Point far(600, 600);
  add("pole").pole.place = Region::rectangle(box.lower - far, box.upper - box.lower + 2 * far);
  return specs;
}

/// Specs that ask for too much of one or of two things.
Spec greedy_spec(test::SpecDice& dice) {
  Spec spec = dice.spec();
  for (int n = 0; n < 2; ++n) {
    const double kind = dice.uniform(0, 9);
    if (kind < 1)
      spec.limits.copy_gap = dice.uniform(0, 150);
    else if (kind < 2)
      spec.limits.copy_gap = 0;
    else if (kind < 3)
      spec.limits.transmission = radians(dice.uniform(40, 85));
    else if (kind < 4)
      spec.links.longest = dice.uniform(30, 200);
    else if (kind < 5)
      spec.links.shortest = dice.uniform(0.5, 1) * spec.links.longest;
    else if (kind < 6)
      spec.links.style.width = 2 * (spec.links.style.pin_diameter = dice.uniform(15, 80));
    else if (kind < 7)
      spec.links.stock_lengths.locked[0] = dice.uniform(20, 600);
    else if (kind < 8)
      spec.limits.clearance = dice.uniform(5, 80);
    else
      spec.objective.groundings = {all_groundings[static_cast<std::size_t>(dice.uniform(0, 3))]};
  }
  if (spec.links.stock_lengths.locked[0])
    spec.links.stock_lengths.locked[0] =
        std::clamp(*spec.links.stock_lengths.locked[0], spec.links.shortest, spec.links.longest);
  return spec;
}

/// KEMPE_GREEDY_SPECS: so many others instead, and how many of them had no relaxation.
TEST(Diagnosis, EveryRelaxationIsTrueAndSoIsTheirAbsence) {
  const char* count = std::getenv("KEMPE_GREEDY_SPECS");
  const int enough_seen = count ? std::atoi(count) : test::samples(12);
  test::SpecDice dice(count ? 1907 : 71);
  int seen = 0, without_any = 0;
  for (int i = 0; i < 40 * enough_seen && seen < enough_seen; ++i) {
    const Spec spec = greedy_spec(dice);
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    if (!std::holds_alternative<NoDesign>(outcome)) continue;
    SCOPED_TRACE(i);
    ++seen;
    const NoDesign none = nothing_for(spec);
    SCOPED_TRACE(none.sentence);
    for (const Relaxation& one : none.relaxations)
      EXPECT_TRUE(has_design(as_told(spec, one.key, one.sentence))) << one.sentence;
    if (!none.relaxations.empty() || none.sentence.find("would fit") != std::string::npos) continue;
    ++without_any;
    for (const auto& [key, other] : each_left_out(spec)) EXPECT_FALSE(has_design(other)) << key;
  }
  EXPECT_GE(seen, test::samples(10));
  if (count) std::printf("%d specs without a design, %d without a relaxation\n", seen, without_any);
}

}  // namespace
}  // namespace kempe
