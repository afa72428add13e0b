// Exit 3: what is in the way, and the least that would do.
#include "synthesis/search/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "specs/spec_reader.hpp"
#include "synthesis/search/best_design.hpp"
#include "synthesis/search/pareto.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

Spec example(const std::string& name) {
  return *read_spec_file(std::string(KEMPE_SOURCE_DIR) + "/specs/examples/" + name + ".toml");
}

Requirements with(Requirements limits, Goal goal, double value) {
  switch (goal) {
    case Goal::transmission: limits.transmission = value; break;
    case Goal::clearance: limits.clearance = value; break;
    case Goal::shortest: limits.shortest = value; break;
    case Goal::longest: limits.longest = value; break;
    case Goal::sheets_gap: limits.sheets_gap = value; break;
    case Goal::copy_error: limits.copy_error = value; break;
    case Goal::pole_margin: limits.pole_margin = value; break;
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

/// Each relaxation's design keeps all other limits, and a hundredth less of it leaves nothing.
void check(const Spec& spec, const NoDesign& none) {
  const SearchTask task = pose(spec, SearchControl({.diagnose = false}));
  for (const Relaxation& relaxation : none.relaxations) {
    SCOPED_TRACE(relaxation.sentence);
    ASSERT_TRUE(relaxation.limit);
    if (relaxation.key == "links.pin_diameter_mm") continue;  // thinner pins move more than one limit
    const Requirements moved = with(requirements_of(spec), *relaxation.limit, relaxation.possible);
    const DesignCheck design = check_design(spec, moved, relaxation.design.linkage, relaxation.design.layers);
    EXPECT_TRUE(design.feasible) << (design.broken ? name(*design.broken) : "");
    const double less = relaxation.demanded + 0.98 * (relaxation.possible - relaxation.demanded);
    EXPECT_FALSE(
        best_design(task.with(with(requirements_of(spec), *relaxation.limit, less), Goal::size)).design)
        << "less would do: " << less;
  }
}

TEST(Diagnosis, OfTooLargeATransmissionAngle) {
  Spec spec = example("plagiograph");
  spec.limits.transmission = radians(75);
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_FALSE(none.requirement.empty());
  EXPECT_NE(none.sentence.find("would do"), std::string::npos);
  check(spec, none);
}

TEST(Diagnosis, OfLinksTooShortForTheRegion) {
  Spec spec = example("nameplate");
  spec.links.longest = 60;
  const NoDesign none = nothing_for(spec);
  ASSERT_FALSE(none.relaxations.empty());
  EXPECT_EQ(none.requirement, "links.longest_mm");
  check(spec, none);
}

/// The value that stands before "would do".
double enough(const std::string& sentence) {
  const std::string words = " would do";
  const std::size_t end = sentence.find(words), start = sentence.rfind(' ', end - 1);
  EXPECT_NE(end, std::string::npos) << sentence;
  return std::stod(sentence.substr(start));
}

/// A plagiograph with lengths up to 72 mm, which leave joints 41.8 mm apart at most.
Spec short_arms(double pin, std::optional<double> wall = std::nullopt) {
  Spec spec = example("plagiograph");
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

TEST(Diagnosis, ALengthOfTheWorkshopNearerThanItsHolesIsNamedWithoutASearch) {
  const Spec base = example("plagiograph");
  const double pin = base.links.style.pin_diameter;
  std::vector<Spec> specs(4, base);
  specs[0].links.workshop.locked[4] = 1.05 * pin;
  specs[1].links.workshop.stock = {0.5 * pin, pin, 1.09 * pin};
  specs[2].links.workshop.grid = 1.09 * pin;
  specs[2].links.longest = 2 * pin;
  specs[3].links.longest = 1.09 * pin;
  for (Spec& spec : specs) {
    spec.links.shortest = 0.1 * pin;
    const NoDesign none = nothing_for(spec);
    EXPECT_EQ(none.requirement, "links.pin_diameter_mm");
    EXPECT_TRUE(none.proven);
    EXPECT_EQ(none.evaluations, 0U);
    EXPECT_LT(enough(none.sentence), pin);
    EXPECT_GT(enough(none.sentence), 0.9 * pin);
    const auto front = pareto_front(spec, Objective::size, Objective::transmission, 3, {});
    ASSERT_FALSE(front);
    EXPECT_EQ(front.error().requirement, none.requirement);
    spec.links.style.pin_diameter = enough(none.sentence);
    EXPECT_FALSE(plainly_impossible(spec));
  }
}

TEST(Diagnosis, OfATightCopyError) {
  Spec spec = example("plagiograph");
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
  Spec spec = example("plagiograph");
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
  Spec spec = example("plagiograph");
  spec.obstacles.push_back({{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {}}, 1, 1, "vice"});
  const NoDesign none = nothing_for(spec);
  EXPECT_EQ(none.requirement, "obstacles");
  EXPECT_TRUE(none.proven);
  EXPECT_EQ(none.evaluations, 0U);
}

TEST(Diagnosis, APoleInTheRegionIsNamed) {
  Spec spec = example("plagiograph");
  spec.region = Region{{{{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}, {}}}};
  spec.pole.place = Point(Point::Zero());
  const NoDesign none = nothing_for(spec);
  EXPECT_EQ(none.requirement, "pole.at_mm");
  EXPECT_TRUE(none.proven);
}

}  // namespace
}  // namespace kempe
