// Fronts: ends that equal the single searches, no point beaten, every point a design that keeps the limits.
#include "synthesis/search/pareto.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "specs/spec.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "tests/synthesis/shipped_spec.hpp"

namespace kempe {
namespace {

Spec tolerant_example(const std::string& name) {
  Spec spec = test::shipped_spec(name);
  if (!spec.tolerance) spec.tolerance = Tolerance{0.05, 0.02};
  return spec;
}

bool is_no_worse(Objective objective, double a, double b) {
  return is_maximized(objective) ? a >= b : a <= b;
}

void check_front(const Spec& spec, Objective a, Objective b, int points) {
  const auto front = pareto_front(spec, a, b, points, {});
  ASSERT_TRUE(front);
  EXPECT_GE(front->size(), 3U);
  EXPECT_LE(front->size(), static_cast<std::size_t>(points));
  for (const ParetoPoint& one : *front) {
    EXPECT_TRUE(check_design(spec, requirements_of(spec), one.design.linkage, one.design.layers).feasible);
    for (const ParetoPoint& other : *front)
      if (&one != &other) {
        EXPECT_FALSE(is_no_worse(a, other.a, one.a) && is_no_worse(b, other.b, one.b));
      }
  }
  for (std::size_t i = 1; i < front->size(); ++i) EXPECT_LT((*front)[i - 1].a, (*front)[i].a);
  // The ends are the best of each alone.
  for (const Objective objective : {a, b}) {
    Spec alone = spec;
    alone.objective.objective = objective;
    const SearchOutcome outcome = synthesize(alone, {});
    const auto* best = std::get_if<FoundDesign>(&outcome);
    ASSERT_TRUE(best);
    double met = objective == a ? front->front().a : front->front().b;
    for (const ParetoPoint& one : *front) {
      const double value = objective == a ? one.a : one.b;
      if (is_no_worse(objective, value, met)) met = value;
    }
    EXPECT_NEAR(met, best->value, 2e-3 * std::abs(best->value)) << name(objective);
  }
}

TEST(Pareto, BetweenSizeAndTransmission) {
  check_front(tolerant_example("nameplate"), Objective::size, Objective::transmission, 9);
}

TEST(Pareto, BetweenSizeAndCopyError) {
  check_front(tolerant_example("plagiograph"), Objective::size, Objective::copy_error, 9);
}

TEST(Pareto, BetweenTransmissionAndCopyErrorWithAFreePole) {
  check_front(tolerant_example("sixty"), Objective::transmission, Objective::copy_error, 6);
}

/// The front of several sections holds what no section's own front beats.
TEST(Pareto, OfSeveralSectionsIsOfThemAll) {
  Spec spec = tolerant_example("plagiograph");
  spec.material = Material{"steel", 200e3, 7850, 235};
  spec.load = Load{10};
  const auto front_with = [&](const std::vector<LinkSection>& sections) {
    Spec one = spec;
    one.links.sections = sections;
    if (sections.size() == 1) use_section(one.links.style, sections.front());
    const auto front = pareto_front(one, Objective::mass, Objective::load_error, 3, {});
    EXPECT_TRUE(front);
    return front ? *front : std::vector<ParetoPoint>();
  };
  const std::vector<LinkSection> sections{{6, 2}, {8, 3}};
  const auto both = front_with(sections);
  ASSERT_FALSE(both.empty());
  for (const LinkSection& section : sections) {
    for (const ParetoPoint& alone : front_with({section}))
      EXPECT_TRUE(std::any_of(both.begin(), both.end(), [&](const ParetoPoint& point) {
        return point.a <= alone.a * (1 + 1e-9) && point.b <= alone.b * (1 + 1e-9);
      }));
    EXPECT_TRUE(std::any_of(both.begin(), both.end(),
                            [&](const ParetoPoint& point) { return point.design.section == section; }));
  }
}

TEST(Pareto, OfASpecWithoutDesignsSaysWhy) {
  Spec spec = tolerant_example("plagiograph");
  spec.limits.transmission = radians(80);
  const auto front = pareto_front(spec, Objective::size, Objective::transmission, 5, {});
  ASSERT_FALSE(front);
  EXPECT_FALSE(front.error().sentence.empty());
}

}  // namespace
}  // namespace kempe
