#include "reports/drawings/spacers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/bom.hpp"
#include "reports/drawings/joint_distances.hpp"
#include "reports/drawings/making_notes.hpp"
#include "tests/reports/sample_designs.hpp"
#include "workspace/contact/gap.hpp"

namespace kempe {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::plagiograph;

std::vector<Spacer> all_spacers(const Design& design) {
  std::vector<Spacer> all;
  for (const auto& of_stack : spacers_of(design, joint_stacks(design)))
    all.insert(all.end(), of_stack.begin(), of_stack.end());
  return all;
}

/// The room that a ring on a joint has between these heights, mm, at some hundred openings: twice the distance from links and from pins,
/// posts, heads and nuts.
double sampled_room(const Design& design, const Spacer& spacer) {
  const auto stacks = joint_stacks(design);
  double room = HUGE_VAL;
  const OpeningInterval openings = openings_over_region(design);
  for (int i = 0; i <= 200; ++i) {
    const Pose pose = design.linkage.pose_at(openings.lower + openings.width() * i / 200, 0.4);
    LinkStyle thin = design.style;
    thin.pin_diameter = 0;
    for (const Link link : all_links) {
      if (has_joint(link, spacer.joint) ||
          !overlap({spacer.from, spacer.to}, heights_of(design.layers[link], design.style.thickness)))
        continue;
      const ContactPair pair{Part{.kind = Part::Kind::pin, .joint = spacer.joint}, Part{.link = link}};
      room = std::min(room, 2 * gap(pair, pose, design.linkage.shape(), thin));
    }
    for (const JointStack& stack : stacks) {
      if (stack.joint == spacer.joint) continue;
      const double apart = (pose[stack.joint] - pose[spacer.joint]).norm();
      const double foot = stack.is_post ? -raised_by(stacks) : stack.from;
      if (overlap({spacer.from, spacer.to}, {foot, stack.to}))
        room = std::min(room, 2 * apart - stack.diameter);
      for (const StackItem& item : standing_out(stack))
        if (overlap({spacer.from, spacer.to}, {item.from, item.to}))
          room = std::min(room, 2 * apart - item.diameter);
    }
  }
  return room - 2 * design.limits.clearance;
}

/// Every assignment to five layers: all spacers keep the clearance, and only those are narrower than a link that would not.
TEST(Spacers, AreAsWideAsTheyMayBe) {
  int full = 0, turned_down = 0, without_room = 0;
  for (const char* hardware : {"", "M6 shoulder bolt"})
    for (const double turn : {0.0, 60.0, 150.0}) {
      Design design = testing::sample_design(std::polar(1.6, radians(turn)), Grounding::pole, 90, 70, 0);
      design.style = {.width = 36, .pin_diameter = 8, .thickness = 4};
      design.hardware = std::string(hardware);
      design.limits.clearance = 0.5;
      if (turn == 60) design.region = {};  // all that is certified
      for (const LayerAssignment& layers : layer_assignments(5)) {
        design.layers = layers;
        const auto spacers = all_spacers(design);
        for (const Spacer& one : spacers) {
          const double room = sampled_room(design, one);
          EXPECT_LE(one.diameter, std::max(0.0, room) + 1e-9) << one.name;
          bool beside_another = false;
          for (const Spacer& other : spacers) {
            if (other.joint == one.joint || !overlap({one.from, one.to}, {other.from, other.to})) continue;
            const double apart = least_distance(design, one.joint, other.joint, openings_over_region(design));
            if (one.diameter > 0 && other.diameter > 0) {
              EXPECT_LE(0.5 * (one.diameter + other.diameter) + 0.5, apart + 1e-9);
            }
            beside_another = beside_another || 0.5 * (36 + 36) + 0.5 > apart;
          }
          if (one.passing.empty()) {
            EXPECT_EQ(one.diameter, 36);
            ++full;
          } else {
            if (!beside_another) {
              EXPECT_GE(one.diameter * 1.01, std::min(36.0, room) - 0.5) << one.name << ' ' << one.passing;
            }
            ++(one.has_room() ? turned_down : without_room);
          }
        }
      }
    }
  EXPECT_GT(full, 50);
  EXPECT_GT(turned_down, 50);
  EXPECT_GT(without_room, 10);
}

/// A spacer that something meets is told with its own width; others are told nothing.
TEST(Spacers, AreToldInBillAndNotesWhereSomethingPasses) {
  Design design = plagiograph();
  design.layers.of = {2, 3, 3, 2};
  for (const double width : {12.0, 60.0}) {
    design.style.width = width;
    std::size_t told = 0;
    for (const Spacer& spacer : all_spacers(design)) {
      const std::string words = words_on(spacer);
      EXPECT_EQ(words.empty(), spacer.passing.empty());
      if (words.empty()) continue;
      ++told;
      EXPECT_THAT(words, HasSubstr(spacer.passing + " passes"));
      EXPECT_THAT(bom_csv(design), HasSubstr("; " + words + "\""));
      EXPECT_THAT(making_notes(design), ::testing::Contains(spacer.name + ": " + words));
    }
    EXPECT_EQ(told > 0, width > 30);
    if (told == 0) {
      EXPECT_THAT(bom_csv(design), Not(HasSubstr("turn it down")));
    }
  }
}

/// The openings of the region: the tracer at its corners and on its edges stands at one of them.
TEST(Spacers, ServeAllOfTheRegion) {
  const Design design = testing::sample_design(std::polar(1.6, 0.4), Grounding::tracer, 90, 70, 1);
  const OpeningInterval openings = openings_over_region(design);
  EXPECT_LT(openings.width(), design.opening.width());
  const Ring& ring = design.region.polygons[0].outer;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (const double share : {0.0, 0.3, 0.5}) {
      const Point at = ring[i] + share * (ring[(i + 1) % ring.size()] - ring[i]) - design.linkage.pole();
      const auto opening = design.linkage.opening_at(at.norm());
      ASSERT_TRUE(opening);
      EXPECT_GE(*opening, openings.lower - 1e-9);
      EXPECT_LE(*opening, openings.upper + 1e-9);
    }
}

TEST(Spacers, AreARingOnlyWithAWall) {
  Spacer spacer{.name = "spacer C",
                .joint = Joint::C,
                .on = "pin C",
                .from = 0,
                .to = 4,
                .bore = 16,
                .diameter = 28.3,
                .passing = "link VB"};
  EXPECT_EQ(words_on(spacer), "turn it down to 28.3 mm, link VB passes");
  spacer.diameter = 17;
  EXPECT_EQ(words_on(spacer),
            "no room for a ring, link VB passes too near: make pin C of one piece with a collar of 17 mm");
  spacer.diameter = 12;
  EXPECT_EQ(words_on(spacer),
            "no room for a ring, link VB passes too near: fix the links at their heights on pin C");
  spacer.passing = "";
  EXPECT_THAT(words_on(spacer), IsEmpty());
}

/// A low clamp that stands in no layer of the links passes beside what stands in its own.
TEST(Spacers, KeepClearOfObstaclesThatNoLinkAnswersFor) {
  Design design = testing::sample_design(1.6, Grounding::pole, 90, 70, 0);
  design.layers.of = {2, 3, 3, 2};
  const Joint tracer = design.linkage.tracer_joint();
  const auto spacer_there = [&] {
    const auto spacers = all_spacers(design);
    return *std::find_if(spacers.begin(), spacers.end(),
                         [&](const Spacer& one) { return one.joint == tracer; });
  };
  EXPECT_THAT(spacer_there().passing, IsEmpty());
  const Box region = bounding_box(design.region);
  const Point corner = region.upper + Point(4.5, -100);  // 4.5 mm beside where the tracer comes
  design.obstacles = {
      {Polygon{{corner, corner + Point(9, 0), corner + Point(9, 200), corner + Point(0, 200)}, {}}, 1, 1,
       "clamp"}};
  const Spacer beside = spacer_there();
  EXPECT_EQ(beside.passing, "clamp");
  EXPECT_NEAR(beside.diameter, 2 * (4.5 - design.limits.clearance), 0.1);
  EXPECT_LE(beside.diameter, 2 * (4.5 - design.limits.clearance));
  design.obstacles[0].lowest_layer = design.obstacles[0].highest_layer = 3;  // certified for links
  EXPECT_THAT(spacer_there().passing, IsEmpty());
}

}  // namespace
}  // namespace kempe
