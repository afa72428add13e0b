// Exit 3: what is in the way, and the least that would do.
#include "synthesis/diagnosis.hpp"

#include <gtest/gtest.h>

#include "specs/spec_reader.hpp"
#include "synthesis/design_check.hpp"
#include "synthesis/obstacle_check.hpp"
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
  const SearchRun run(spec, {.diagnose = false});
  for (const Relaxation& relaxation : none.relaxations) {
    SCOPED_TRACE(relaxation.sentence);
    ASSERT_TRUE(relaxation.limit);
    const Requirements moved = with(requirements_of(spec), *relaxation.limit, relaxation.possible);
    const DesignCheck design = check_design(spec, moved, relaxation.design.linkage, relaxation.design.layers);
    EXPECT_TRUE(design.feasible) << (design.broken ? name(*design.broken) : "");
    const double less = relaxation.demanded + 0.98 * (relaxation.possible - relaxation.demanded);
    EXPECT_FALSE(run.best(with(requirements_of(spec), *relaxation.limit, less), Goal::size).design)
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
