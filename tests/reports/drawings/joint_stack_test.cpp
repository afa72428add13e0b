#include "reports/drawings/joint_stack.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "reports/drawings/bom.hpp"
#include "reports/drawings/hardware_faults.hpp"
#include "reports/drawings/joint_distances.hpp"
#include "tests/reports/sample_designs.hpp"
#include "workspace/contact/gap.hpp"

namespace kempe {
namespace {

using testing::plagiograph;

/// Every assignment to up to five layers: the items fill what is gripped without gap or overlap, each link lies at the height
/// of its layer, and the bill's pins and posts are the stacks.
TEST(JointStack, IsFilledFromEndToEnd) {
  Design design = plagiograph();
  for (const LayerAssignment& layers : layer_assignments(5)) {
    design.layers = layers;
    const auto stacks = joint_stacks(design);
    ASSERT_EQ(stacks.size(), 6U);
    for (const JointStack& stack : stacks) {
      double height = stack.from, links = 0;
      for (const StackItem& item : stack.items) {
        EXPECT_DOUBLE_EQ(item.from, height);
        EXPECT_GT(item.to, item.from);
        height = item.to;
        if (item.kind == StackItem::Kind::link) ++links;
      }
      EXPECT_DOUBLE_EQ(height, stack.to);
      EXPECT_EQ(links, stack.links.size());
      EXPECT_EQ(stack.from, stack.is_post ? 0 : (stack.lowest - 1) * design.style.thickness);
      EXPECT_EQ(stack.to, stack.highest * design.style.thickness);
      EXPECT_GE(stack.grip(), links * design.style.thickness);
      for (const Link link : stack.links) EXPECT_TRUE(has_joint(link, stack.joint));
    }
    std::size_t billed = 0;
    for (const BomItem& item : bill_of_materials(design))
      if (item.item == "pin" || item.item == "post") {
        EXPECT_EQ(item.name, stacks[billed].name);
        EXPECT_EQ(item.length, stacks[billed++].grip());
      }
    EXPECT_EQ(billed, 6U);
  }
}

/// Every hardware in every assignment: what a pin is bought as grips the whole stack, what stands outside touches nothing
/// of it and does not overlap, and the shopping list has each piece of the stacks.
TEST(JointStack, IsGrippedWholeByWhatIsBought) {
  Design design = plagiograph();
  for (const Hardware& hardware : all_hardware()) {
    design.hardware = std::string(hardware.name);
    design.style = {
        .width = 60, .pin_diameter = hardware.pin, .thickness = std::max(4.0, hardware.seat_width)};
    for (const LayerAssignment& layers : layer_assignments(4)) {
      design.layers = layers;
      const auto stacks = joint_stacks(design);
      std::map<std::string, int> pieces;
      for (const JointStack& stack : stacks) {
        for (std::size_t i = 1; i < stack.items.size(); ++i)
          EXPECT_GE(stack.items[i].from, stack.items[i - 1].to - 1e-9) << hardware.name;
        double links = 0;
        for (const StackItem& item : stack.items)
          if (item.kind == StackItem::Kind::link || item.kind == StackItem::Kind::spacer)
            links += item.to - item.from;
        EXPECT_NEAR(links, stack.grip(), 1e-9);
        if (stack.is_post) {
          EXPECT_FALSE(stack.fastener);
          continue;
        }
        if (!stack.fastener) continue;
        EXPECT_LE(stack.fastener->from, stack.from + 1e-9);
        EXPECT_GE(stack.fastener->to, stack.to - 1e-9);
        EXPECT_NEAR(stack.fastener->to - stack.fastener->from, stack.fastener->length, 1e-9);
        EXPECT_GE(stack.fastener->play, -1e-9);
        ++pieces[stack.fastener->name];
        for (const StackItem& item : stack.items)
          if (item.kind != StackItem::Kind::link && item.kind != StackItem::Kind::spacer &&
              item.kind != StackItem::Kind::head)
            ++pieces[item.name];
        const bool screwed = !hardware.thread.empty() && hardware.kind != HardwareKind::shoulder_screw;
        if (screwed) {
          EXPECT_GE(stack.fastener->to, stack.items.back().to + thread_of(hardware)->pitch - 1e-9);
        }
      }
      std::map<std::string, int> billed;
      for (const BomItem& item : bill_of_materials(design))
        if (pieces.contains(item.name)) billed[item.name] += item.quantity;
      for (const auto& [piece, count] : pieces) EXPECT_EQ(billed[piece], count) << piece;
    }
  }
}

/// Joints of random hardware, some plain: each stack is what a linkage has at that joint whose joints are all made so, and the
/// bill counts what all six need.
TEST(JointStack, OfAJointDependsOnItsOwnHardware) {
  std::mt19937 dice(20);
  Design design = plagiograph();
  design.style = {.width = 60, .pin_diameter = 16, .thickness = 8};
  for (int round = 0; round < 40; ++round) {
    design.layers = layer_assignments(4)[dice() % layer_assignments(4).size()];
    design.hardware = {};
    for (std::string& name : design.hardware.at)
      if (const std::size_t i = dice() % (all_hardware().size() + 4); i < all_hardware().size())
        name = all_hardware()[i].name;
    std::map<std::string, int> pieces;
    for (const JointStack& stack : joint_stacks(design)) {
      Design alike = design;
      alike.hardware = design.hardware[stack.joint];
      const Hardware* hardware = hardware_named(alike.hardware.every);
      alike.style.pin_diameter = hardware != nullptr ? hardware->pin : 16;
      const auto same = joint_stacks(alike);
      const auto there = std::find_if(same.begin(), same.end(),
                                      [&](const JointStack& one) { return one.name == stack.name; });
      ASSERT_NE(there, same.end());
      EXPECT_EQ(stack.diameter, there->diameter);
      EXPECT_EQ(stack.items.size(), there->items.size());
      EXPECT_EQ(stack.fastener.has_value(), there->fastener.has_value());
      if (!stack.fastener) continue;
      EXPECT_EQ(stack.fastener->name, there->fastener->name);
      ++pieces[stack.fastener->name];
      for (const StackItem& item : stack.items)
        if (item.name.starts_with("washer") || item.name.starts_with("nut")) ++pieces[item.name];
    }
    std::map<std::string, int> billed;
    for (const BomItem& item : bill_of_materials(design)) billed[item.name] += item.quantity;
    for (const auto& [piece, count] : pieces) EXPECT_EQ(billed[piece], count) << piece;
  }
}

TEST(JointStack, OfTheShopHasM6ShoulderBoltsOf16) {
  Design design = plagiograph();
  design.style = {.width = 20, .pin_diameter = 8, .thickness = 5};
  design.hardware = "M6 shoulder bolt";
  const JointStack pin = joint_stacks(design)[0];
  ASSERT_TRUE(
      pin.fastener);  // two links of 5 mm: the shortest shoulder made is 16, three washers of 1.6 fill 4.8 of 6
  EXPECT_EQ(pin.fastener->name, "shoulder screw ISO 7379 8 x 16 M6");
  EXPECT_NEAR(pin.fastener->play, 1.2, 1e-9);
  EXPECT_EQ(std::count_if(pin.items.begin(), pin.items.end(),
                          [](const StackItem& item) { return item.kind == StackItem::Kind::shim; }),
            3);
  EXPECT_NEAR(raised_by(joint_stacks(design)), 5.5, 1e-9);
  for (const BomItem& item : bill_of_materials(design))
    for (const JointStack& stack : joint_stacks(design))
      if (stack.is_post && item.name == stack.name) {
        EXPECT_NEAR(item.length, stack.grip() + 5.5, 1e-9);
      }
}

/// Shoulders that are longer than their links are thick, of every size and many grips: no washer that fits them would go in any more.
TEST(JointStack, FillsUpEveryShoulder) {
  Design design = plagiograph();
  for (const auto& [name, shoulder, ring] : {std::tuple{"M6 shoulder bolt", 8.0, 1.6},
                                             {"M8 shoulder bolt", 10.0, 2.0},
                                             {"M12 shoulder bolt", 16.0, 3.0}})
    for (const double thickness : {4.0, 6.5, 8.0, 10.0, 14.0}) {
      design.style = {.width = 60, .pin_diameter = shoulder, .thickness = thickness};
      design.hardware = std::string(name);
      for (const JointStack& stack : joint_stacks(design)) {
        if (stack.is_post) continue;
        ASSERT_TRUE(stack.fastener);
        EXPECT_LT(stack.fastener->play, ring) << name << ' ' << thickness;
        double filled = stack.fastener->play;
        for (const StackItem& item : stack.items)
          if (item.kind == StackItem::Kind::shim) {
            EXPECT_EQ(item.name, fmt::format("washer ISO 7089 {}", shoulder));
            filled += item.to - item.from;
          }
        EXPECT_NEAR(filled, stack.fastener->length - stack.grip(), 1e-9);
      }
    }
}

/// A bearing of 7 mm in the middle of a link of 8: half a millimetre on each side, two rings each.
TEST(JointStack, BuysShimRingsForBearings) {
  Design design = plagiograph();
  design.style = {.width = 40, .pin_diameter = 8, .thickness = 8};
  design.hardware = "608 bearing";
  const auto rings = [&] {
    std::vector<BomItem> found;
    for (const BomItem& item : bill_of_materials(design))
      if (item.item == "shim ring") found.push_back(item);
    return found;
  };
  ASSERT_EQ(rings().size(), 1U);
  EXPECT_EQ(rings()[0].name, "shim ring 8 x 0.5");
  EXPECT_EQ(rings()[0].quantity, 20);  // two links at V, A, B and C, one at X and Y
  EXPECT_EQ(rings()[0].diameter, 8);
  EXPECT_EQ(rings()[0].length, 0.5);
  design.style.thickness = 7;
  EXPECT_TRUE(rings().empty());
}

/// The least distance of two joints against 2000 openings.
TEST(HardwareFaults, KnowHowNearJointsCome) {
  for (const Grounding grounding : all_groundings)
    for (const double turn : {0.0, 40.0, 110.0, -75.0})
      for (int mode = 0; mode < 2; ++mode) {
        const Design design = testing::sample_design(std::polar(1.6, radians(turn)), grounding, 90, 70, mode);
        for (const Joint one : all_joints)
          for (const Joint other : all_joints) {
            double least = HUGE_VAL;
            for (int i = 0; i <= 2000; ++i) {
              const double opening = design.opening.lower + design.opening.width() * i / 2000;
              const Pose pose = design.linkage.pose_at(opening, 0.4);
              least = std::min(least, (pose[one] - pose[other]).norm());
            }
            EXPECT_NEAR(least_distance(design, one, other, design.opening), least, 0.2);
            EXPECT_LE(least_distance(design, one, other, design.opening), least + 1e-9);
          }
      }
}

TEST(HardwareFaults, TellOfNutsThatMeetAndOfLengthsThatNobodyMakes) {
  Design design = plagiograph();  // A and C are 35 mm apart, B and C 50 mm
  design.style.width = 40;
  design.style.thickness = 8;
  design.hardware = "608 bearing";
  design.style.pin_diameter = 8;
  EXPECT_TRUE(hardware_faults(design).empty()) << hardware_faults(design).front();
  Design small = testing::sample_design(copy_ratio(1.4, radians(90)), Grounding::pole, 15, 10, 3);
  small.style = {.width = 25, .pin_diameter = 12, .thickness = 4};
  small.hardware = "M12 bolt";  // nuts 20 mm wide, A and C 10 mm apart
  EXPECT_FALSE(hardware_faults(small).empty());
  design.style.thickness = 90;
  ASSERT_FALSE(hardware_faults(design).empty());
  EXPECT_NE(hardware_faults(design).front().find("is made that grips 180 mm"), std::string::npos);
}

/// Nuts and heads beside links, in every assignment to four layers, against 400 openings: what comes too near is told, and nothing
/// that is clear.
TEST(HardwareFaults, KnowHowNearLinksComeToNuts) {
  int told = 0, clear = 0;
  for (const double turn : {0.0, 60.0, 150.0}) {
    Design design = testing::sample_design(std::polar(1.6, radians(turn)), Grounding::pole, 90, 70, 0);
    design.style = {.width = 20, .pin_diameter = 8, .thickness = 4};
    design.hardware = "M8 bolt";
    design.limits.clearance = 0.5;
    design.opening = shrink(design.linkage.assembly_mode().openings, radians(4));  // nearly folded flat
    LinkStyle as_nut = design.style;
    as_nut.pin_diameter = thread_of(*hardware_named("M8 bolt"))->nut_corners;
    for (const LayerAssignment& layers : layer_assignments(4)) {
      design.layers = layers;
      const auto faults = hardware_faults(design);
      for (const JointStack& stack : joint_stacks(design))
        for (const StackItem& item : stack.items)
          for (const Link link : all_links) {
            const double low = (layers[link] - 1) * design.style.thickness;
            if (item.kind != StackItem::Kind::nut || item.from >= low + design.style.thickness ||
                item.to <= low)
              continue;
            const ContactPair pair{Part{.kind = Part::Kind::pin, .joint = stack.joint}, Part{.link = link}};
            double least = HUGE_VAL;
            for (int i = 0; i <= 400; ++i) {
              const double opening = design.opening.lower + design.opening.width() * i / 400;
              least = std::min(
                  least, gap(pair, design.linkage.pose_at(opening, 0.4), design.linkage.shape(), as_nut));
            }
            const bool is_told = std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
              return fault.starts_with(stack.name + ": nut") &&
                     fault.find(" link " + std::string(name(link))) != std::string::npos;
            });
            if (least < 0.5) {
              EXPECT_TRUE(is_told) << stack.name << ' ' << name(link) << ' ' << least;
            }
            if (least > 1.0) {
              EXPECT_FALSE(is_told) << stack.name << ' ' << name(link) << ' ' << least;
            }
            ++(is_told ? told : clear);
          }
    }
  }
  EXPECT_GT(told, 10);
  EXPECT_GT(clear, 10);
}

TEST(HardwareFaults, TellOfHeadsThatHangBesideALowObstacle) {
  Design design = testing::sample_design(1.6, Grounding::pole, 90, 70, 0);
  design.style = {.width = 20, .pin_diameter = 8, .thickness = 4};
  design.hardware = "M8 bolt";
  design.layers.of = {2, 3, 3, 2};
  const Point at =
      design.linkage.pose_at(design.opening.middle(), 0.3).B;  // the tracer in the middle of the region
  const auto clamp = [&](const Point& middle, int highest) {
    design.obstacles = {
        {{{middle + Point(-3, -3), middle + Point(3, -3), middle + Point(3, 3), middle + Point(-3, 3)}, {}},
         1,
         highest,
         "clamp"}};
    return hardware_faults(design);
  };
  const auto under = clamp(at, 1);
  ASSERT_FALSE(under.empty());
  EXPECT_EQ(under.front(), "pin B: head of 13 mm hits clamp; clearance is " +
                               fmt::format("{}", design.limits.clearance) + " mm");
  EXPECT_TRUE(clamp(at, 3).empty());  // in the layers of the links, whose contact is certified
  EXPECT_TRUE(clamp(at + Point(0, 300), 1).empty());
  design.obstacles[0].lowest_layer = 3;
  design.obstacles[0].highest_layer = 4;
  ASSERT_EQ(hardware_faults(design).size(), 1U);
  EXPECT_NE(hardware_faults(design)[0].find("clamp must stand so much higher too"), std::string::npos);
}

TEST(HardwareFaults, TellOfNutsThatABodyMayMeet) {
  Design design = testing::sample_design(1.6, Grounding::pole, 90, 70, 0);
  design.style = {.width = 20, .pin_diameter = 8, .thickness = 4};
  design.hardware = "M8 bolt";
  EXPECT_TRUE(hardware_faults(design).empty()) << hardware_faults(design).front();
  design.bodies = {
      Body{.shape = Disc{Point::Zero(), 10}, .lowest_layer = 2, .highest_layer = 8, .name = "router"}};
  EXPECT_TRUE(hardware_faults(design).empty()) << hardware_faults(design).front();
  std::get<Disc>(design.bodies[0].shape).radius = 400;
  ASSERT_FALSE(hardware_faults(design).empty());
  EXPECT_NE(
      hardware_faults(design).front().find("may come too near to router, which reaches 400.00 mm from Y"),
      std::string::npos)
      << hardware_faults(design).front();
}

}  // namespace
}  // namespace kempe
