#include "specs/hardware.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "specs/spec_check.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

const std::string circle_task = "[copy]\nscale = 2\n[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n";

TEST(Hardware, IsWhatTheSpecCanName) {
  const auto words = words_of(*find_spec_key("links", "hardware"));
  ASSERT_EQ(words.size(), all_hardware().size());
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(words[i], all_hardware()[i].name);
  EXPECT_EQ(hardware_named("M7 bolt"), nullptr);
  EXPECT_EQ(hardware_named(""), nullptr);
}

/// What every row must be, whatever its figures.
TEST(Hardware, HasSizesThatGoTogether) {
  std::set<std::string_view> names;
  for (const Hardware& each : all_hardware()) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
    EXPECT_GT(each.pin, 0);
    EXPECT_TRUE(each.seat == 0 || each.seat > each.pin) << each.name;
    EXPECT_EQ(each.seat > 0, each.kind == HardwareKind::bearing || each.kind == HardwareKind::bush);
    EXPECT_EQ(each.seat_width > 0, each.kind == HardwareKind::bearing);
    const ThreadSizes* thread = thread_of(each);
    EXPECT_EQ(thread == nullptr, each.kind == HardwareKind::dowel || each.kind == HardwareKind::bush)
        << each.name;
    if (thread == nullptr) continue;
    EXPECT_GT(thread->screw_head, thread->diameter);
    EXPECT_GT(thread->nut_corners, thread->diameter);
    EXPECT_GT(thread->washer_diameter, thread->screw_head);
    if (each.kind == HardwareKind::shoulder_screw) {
      EXPECT_GT(each.pin, thread->diameter);
      EXPECT_GT(each.head, each.pin);
      EXPECT_GE(each.thread_length, thread->washer_height + thread->nut_height + thread->pitch);
    } else {
      EXPECT_EQ(each.pin, thread->diameter);
    }
  }
}

/// Figures of the standards, as printed in them.
TEST(Hardware, IsAsTheStandardsSay) {
  EXPECT_EQ(hardware_named("M6 shoulder bolt")->pin, 8);  // ISO 7379: M6 has the shoulder 8
  EXPECT_EQ(hardware_named("M6 shoulder bolt")->head, 13);
  EXPECT_EQ(hardware_named("608 bearing")->seat, 22);  // 8 x 22 x 7
  EXPECT_EQ(hardware_named("608 bearing")->seat_width, 7);
  EXPECT_EQ(hardware_named("6 mm dowel and bush")->seat, 8);  // ISO 3547: 6 x 8
  const ThreadSizes& M8 = *thread_of(*hardware_named("M8 bolt"));
  EXPECT_EQ(M8.pitch, 1.25);
  EXPECT_EQ(M8.nut_height, 6.8);       // ISO 4032
  EXPECT_EQ(M8.washer_height, 1.6);    // ISO 7089
  EXPECT_EQ(M8.screw_head_height, 8);  // ISO 4762: k = d
}

TEST(Hardware, LengthsAreTheNextThatIsMade) {
  for (const Hardware& each : all_hardware())
    for (double needed = 0.5; needed < 130; needed += 0.7) {
      const ThreadSizes* thread = thread_of(each);
      const bool by_screw = thread != nullptr && each.kind != HardwareKind::shoulder_screw;
      const auto length = by_screw ? screw_length(*thread, needed) : shoulder_or_pin_length(each, needed);
      const double longest = by_screw ? thread->screw_longest : each.longest;
      EXPECT_EQ(length.has_value(), needed <= longest) << each.name << " " << needed;
      if (!length) continue;
      EXPECT_GE(*length, needed);
      EXPECT_LE(*length, longest);
      const auto same = by_screw ? screw_length(*thread, *length) : shoulder_or_pin_length(each, *length);
      EXPECT_EQ(same, length);
    }
}

TEST(Hardware, GivesThePinAndTheHoles) {
  const auto spec =
      read_spec(circle_task + "[links]\nwidth_mm = 30\nthickness_mm = 8\nhardware = \"608 bearing\"\n",
                "spec.toml", "");
  ASSERT_TRUE(spec) << spec.error().message();
  EXPECT_EQ(spec->links.style.pin_diameter, 8);
  EXPECT_EQ(hole_diameter(spec->links.style, spec->links.hardware, Joint::A, spec->cutting), 22);
  EXPECT_EQ(joint_width(*spec), 22);
  EXPECT_NEAR(hole_distance(*spec), 22 + 0.8, 1e-12);
  const auto again = check_spec(*spec);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->links.hardware, "608 bearing");
  const auto text = read_spec(spec_as_toml(*spec), "spec.toml", "");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->links.hardware, "608 bearing");
}

/// The joints' own names, the thickest pin for all, the widest hole between them; the same again through text and through a check.
TEST(Hardware, MayDifferFromJointToJoint) {
  const std::string links = "[links]\nwidth_mm = 30\nthickness_mm = 8\n";
  for (const std::string hardware :
       {"hardware = {default = \"M6 bolt\", V = \"608 bearing\", C = \"4 mm dowel\"}\n",
        "[links.hardware]\ndefault = \"M6 bolt\"\nV = \"608 bearing\"\nC = \"4 mm dowel\"\n"}) {
    const auto spec = read_spec(circle_task + links + hardware, "spec.toml", "");
    ASSERT_TRUE(spec) << spec.error().message();
    const auto again = check_spec(*spec);
    ASSERT_TRUE(again) << again.error().message();
    const auto text = read_spec(spec_as_toml(*spec), "spec.toml", "");
    ASSERT_TRUE(text) << spec_as_toml(*spec);
    for (const Spec& one : {*spec, *again, *text}) {
      const JointHardware& named = one.links.hardware;
      EXPECT_EQ(named, spec->links.hardware);
      EXPECT_EQ(named[Joint::V], "608 bearing");
      EXPECT_EQ(named[Joint::C], "4 mm dowel");
      EXPECT_EQ(named[Joint::X], "M6 bolt");
      EXPECT_EQ(one.links.style.pin_diameter, 8);
      EXPECT_EQ(pin_at(one.links.style, named, Joint::C), 4);
      const CuttingSpec fit{.hole_fit = 0.2};
      EXPECT_EQ(hole_diameter(one.links.style, named, Joint::V, fit), 22);
      EXPECT_DOUBLE_EQ(hole_diameter(one.links.style, named, Joint::A, fit), 6.2);
      EXPECT_DOUBLE_EQ(hole_diameter(one.links.style, named, Joint::C, fit), 4.2);
      EXPECT_EQ(joint_width(one), 22);
    }
  }
}

/// Plain pins beside bought ones are as thick as the thickest of these, or thicker.
TEST(Hardware, LeavesOtherJointsPlain) {
  const auto pins = [](const std::string& links) {
    const auto spec = read_spec(circle_task + "[links]\n" + links, "spec.toml", "");
    EXPECT_TRUE(spec) << spec.error().message();
    const LinkSpec& of = spec->links;
    return std::pair(pin_at(of.style, of.hardware, Joint::A), pin_at(of.style, of.hardware, Joint::B));
  };
  EXPECT_EQ(pins("hardware = {A = \"M4 bolt\"}\n"), std::pair(4.0, 6.0));
  EXPECT_EQ(pins("hardware = {A = \"M8 bolt\"}\n"), std::pair(8.0, 8.0));
  EXPECT_EQ(pins("hardware = {A = \"M8 bolt\"}\npin_diameter_mm = 9\n"), std::pair(8.0, 9.0));
}

TEST(Hardware, ASpecInAProgramTakesThePin) {
  Spec spec = *read_spec(circle_task, "spec.toml", "");
  spec.links.hardware = "M6 shoulder bolt";
  const auto checked = check_spec(spec);
  ASSERT_TRUE(checked) << checked.error().message();
  EXPECT_EQ(checked->links.style.pin_diameter, 8);
}

TEST(Hardware, ThatDoesNotGoWithTheLinksIsRefused) {
  const auto refused = [](const std::string& links, const std::string& key) {
    const auto spec = read_spec(circle_task + "[links]\n" + links, "spec.toml", "");
    ASSERT_FALSE(spec) << links;
    EXPECT_EQ(spec.error().key, key);
    EXPECT_GT(spec.error().line, 5);
  };
  refused("hardware = \"M7 bolt\"\n", "links.hardware");
  refused("hardware = 6\n", "links.hardware");
  refused("hardware = \"608 bearing\"\nthickness_mm = 8\n", "links.hardware");                 // 22 mm in 12
  refused("hardware = \"608 bearing\"\nwidth_mm = 30\nthickness_mm = 6\n", "links.hardware");  // 7 mm in 6
  refused("hardware = \"M6 shoulder bolt\"\npin_diameter_mm = 6\n", "links.pin_diameter_mm");
  refused("hardware = {}\n", "links.hardware");
  refused("hardware = {Z = \"M6 bolt\"}\n", "links.hardware.Z");
  refused("hardware = {A = \"M7 bolt\"}\n", "links.hardware.A");
  refused("hardware = {default = \"M6 bolt\", A = 6}\n", "links.hardware.A");
  refused("hardware = {default = \"M6 bolt\", V = \"608 bearing\"}\nthickness_mm = 8\n", "links.hardware");
  refused("hardware = {A = \"M8 bolt\"}\npin_diameter_mm = 6\n", "links.pin_diameter_mm");
  refused("hardware = {default = \"M6 bolt\", A = \"M8 bolt\"}\npin_diameter_mm = 9\n",
          "links.pin_diameter_mm");
}

TEST(Process, GivesItsUsualFitUnlessAnotherIsGiven) {
  const auto fit = [](const std::string& cutting) {
    return read_spec(circle_task + "[cutting]\n" + cutting, "", "")->cutting.hole_fit;
  };
  EXPECT_EQ(fit("kerf_mm = 0.1\n"), 0);
  EXPECT_EQ(fit("process = \"laser\"\n"), 0.1);
  EXPECT_EQ(fit("process = \"mill\"\n"), 0.05);
  EXPECT_EQ(fit("process = \"print\"\n"), 0.3);
  EXPECT_EQ(fit("process = \"drill\"\n"), 0.1);
  EXPECT_EQ(fit("process = \"print\"\nhole_fit_mm = 0\n"), 0);
  EXPECT_FALSE(read_spec(circle_task + "[cutting]\nprocess = \"saw\"\n", "", ""));
}

TEST(LongestStrip, LeavesJointsTheStripLessTheWidth) {
  const auto spec = [](const std::string& more) { return read_spec(circle_task + more, "spec.toml", ""); };
  EXPECT_EQ(largest_joint_distance(*spec("")), 400);
  EXPECT_EQ(largest_joint_distance(*spec("[limits]\nlongest_strip_mm = 300\n")), 288);
  EXPECT_EQ(largest_joint_distance(*spec("[limits]\nlongest_strip_mm = 500\n")), 400);
  EXPECT_FALSE(strip_is_shorter(*spec("[limits]\nlongest_strip_mm = 412\n")));
  const auto none = spec("[limits]\nlongest_strip_mm = 26\n");  // 15 mm between joints and 12 mm of width
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().key, "limits.longest_strip_mm");
  EXPECT_EQ(none.error().line, 6);
}

}  // namespace
}  // namespace kempe
