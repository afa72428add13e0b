// What a maker is told before the parts are cut: loads that break the links, bodies that stand on nothing.
#include "reports/drawings/making_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/drawings/mounting_words.hpp"
#include "reports/drawings/overload_words.hpp"
#include "specs/materials.hpp"
#include "synthesis/loads/strength.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

Design loaded(double force) {
  Design design = testing::plagiograph();
  design.material = as_material(*material_named("PLA"));
  design.load = Load{.pen_force = force};
  design.quality.loads = LoadFigures{.error_max = 0.01 * force, .stress_max = 0.5 * force};
  return design;
}

TEST(OverloadWords, TellWhatBreaksBucklesAndBendsTooFar) {
  EXPECT_THAT(overload_words(testing::plagiograph()), IsEmpty());
  const Design light = loaded(1);
  EXPECT_THAT(overload_words(light), IsEmpty());
  EXPECT_NEAR(largest_push_in_bars(loaded(10)), 10 * largest_push_in_bars(light), 1e-9);
  const double enough = 1.01 * buckling_load_of_bars(light) / largest_push_in_bars(light);
  EXPECT_THAT(overload_words(loaded(enough)), Contains(StartsWith("the bars buckle")));
  EXPECT_THAT(overload_words(loaded(0.98 * enough)), Not(Contains(StartsWith("the bars buckle"))));
  EXPECT_THAT(overload_words(loaded(53)),
              Contains("the links yield or break: they are stressed to 26.5 MPa, and PLA bears 26 MPa"));
  EXPECT_THAT(overload_words(loaded(51)), Not(Contains(StartsWith("the links yield or break"))));
  ASSERT_TRUE(large_bending_words(loaded(1000)));
  EXPECT_THAT(*large_bending_words(loaded(1000)),
              HasSubstr("bend by 10 mm, more than a tenth of their length"));
  EXPECT_FALSE(large_bending_words(light));
  Design played = light;
  played.quality.sag = 20;  // by the play of the pins: nothing bends
  EXPECT_FALSE(large_bending_words(played));
  Design hollow = light;
  hollow.quality.loads->stress_max = HUGE_VAL;
  EXPECT_THAT(overload_words(hollow), Contains("the links yield or break: a hole leaves nothing of a link"));
  EXPECT_THAT(making_notes(loaded(1000)).front(), StartsWith("the links yield or break"));  // before all else
}

TEST(MountingWords, TellOfBodiesAboveTheLinksThatCarryThem) {
  Design design = testing::sample_design(2.0, Grounding::tracer, 60, 50, 0);
  design.layers.of = {1, 2, 3, 4};
  const auto with_hand_from = [&](int layer) {
    design.bodies = {Body{.at = Carrier::tracer,
                          .shape = Disc{Point::Zero(), 8},
                          .lowest_layer = layer,
                          .highest_layer = 8,
                          .name = "hand"}};
    return mounting_words(design);
  };
  EXPECT_THAT(with_hand_from(1), IsEmpty());
  EXPECT_THAT(with_hand_from(3), IsEmpty());  // on VB, which has layer 2
  ASSERT_EQ(with_hand_from(4).size(), 1U);
  EXPECT_THAT(
      with_hand_from(4)[0],
      HasSubstr("carries hand is not in the proof of contact: it begins 4 mm above the links at tracer V"));
  EXPECT_THAT(with_hand_from(5)[0], HasSubstr("it begins 8 mm above the links at tracer V"));
}

}  // namespace
}  // namespace kempe
