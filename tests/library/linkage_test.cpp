// kempe/linkage.hpp and kempe/generators.hpp.

#include "kempe/linkage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kempe/generators.hpp"

namespace kempe {
namespace {

constexpr const char* watt = KEMPE_SOURCE_DIR "/specs/examples/linkages/watt-six-bar.toml";

Linkage linkage_of(const std::string& text) {
  auto found = Linkage::parse(text, "some.toml");
  if (const auto* fault = std::get_if<InputError>(&found)) ADD_FAILURE() << fault->messages();
  return std::get<Linkage>(found);
}

const MovedPoint& point_of(const DrivenMotion& motion, const std::string& name) {
  for (const MovedPoint& point : motion.points)
    if (point.name == name) return point;
  throw std::out_of_range(name);
}

TEST(Linkage, SaysTheSameOfAFileAndOfItsText) {
  const auto read = Linkage::read(watt);
  ASSERT_TRUE(std::holds_alternative<Linkage>(read)) << std::get<InputError>(read).messages();
  const Linkage& linkage = std::get<Linkage>(read);
  const Linkage again = linkage_of(linkage.text());
  EXPECT_EQ(linkage.name(), "Watt six-bar");
  EXPECT_EQ(linkage.points(), again.points());
  EXPECT_EQ(linkage.links(), (std::vector<std::string>{"crank", "coupler", "rocker", "EG", "FG"}));
  EXPECT_TRUE(linkage.notes().empty());
  EXPECT_EQ(std::get<std::string>(linkage.mobility()), std::get<std::string>(again.mobility()));
  EXPECT_EQ(std::get<std::string>(linkage.equations(2)), std::get<std::string>(again.equations(2)));
  EXPECT_EQ(std::get<std::string>(linkage.centres(2)), std::get<std::string>(again.centres(2)));
  EXPECT_EQ(std::get<InputError>(Linkage::parse("[links]\n", "some.toml")).file, "some.toml");
  EXPECT_FALSE(std::get<InputError>(Linkage::read("no such file.toml")).found.empty());
}

TEST(Linkage, KeepsItsLengthsAndItsDriversPace) {
  const auto moved = std::get<Linkage>(Linkage::read(watt)).solve(12);
  const auto& motion = std::get<DrivenMotion>(moved);
  ASSERT_EQ(motion.steps.size(), 13U);
  EXPECT_FALSE(motion.end);
  const auto &a = point_of(motion, "A"), &b = point_of(motion, "B"), &d = point_of(motion, "D");
  for (std::size_t i = 0; i < motion.steps.size(); ++i) {
    const double angle = 2 * pi * motion.steps[i] / 12;
    EXPECT_NEAR((a.places[i] - 25 * Point(std::cos(angle), std::sin(angle))).norm(), 0, 1e-9);
    EXPECT_NEAR((a.places[i] - b.places[i]).norm(), 75, 1e-9);
    EXPECT_NEAR((d.places[i] - b.places[i]).norm(), 60, 1e-9);
    EXPECT_NEAR((a.places[i] - b.places[i]).dot(*a.velocities[i] - *b.velocities[i]), 0, 1e-6);
  }
}

TEST(Linkage, SaysWhyThereIsNoMotion) {
  const std::string bars =
      "[ground]\nO = [0, 0]\nD = [80, 0]\n[links]\n"
      "crank = { joints = [\"O\", \"A\"], O-A = 10 }\n"
      "rod = { joints = [\"A\", \"B\"], A-B = 30 }\n"
      "rocker = { joints = [\"D\", \"B\"], D-B = 15 }\n"
      "[[drivers]]\nangle = \"crank\"\nfrom_deg = 0\nto_deg = 360\n";
  const auto none = linkage_of(bars).solve();
  ASSERT_TRUE(std::holds_alternative<NoMotion>(none));
  EXPECT_NE(std::get<NoMotion>(none).sentence.find("does not assemble"), std::string::npos);
  EXPECT_FALSE(std::get<NoMotion>(none).stopped);
  const Linkage linkage = std::get<Linkage>(Linkage::read(watt));
  EXPECT_EQ(std::get<InputError>(linkage.solve(0)).key, "steps");
  EXPECT_EQ(std::get<InputError>(linkage.solve(4, {.number = 99})).key, "assembly");
  const auto stopped = linkage.solve(4, {.stop = [] { return true; }});
  ASSERT_TRUE(std::holds_alternative<NoMotion>(stopped));
  EXPECT_TRUE(std::get<NoMotion>(stopped).stopped);
}

TEST(Linkage, HasNoRatesWhereItsMotionStopped) {
  const auto moved = linkage_of(
                         "[ground]\nO = [0, 0]\nD = [40, 0]\n[links]\n"
                         "crank = { joints = [\"O\", \"A\"], O-A = 10 }\n"
                         "rod = { joints = [\"A\", \"B\"], A-B = 25 }\n"
                         "rocker = { joints = [\"D\", \"B\"], D-B = 15 }\n"
                         "[[drivers]]\nangle = \"crank\"\nfrom_deg = 0\nto_deg = 360\n"
                         "[[forces]]\nat = \"B\"\nnewton = [1, 2]\n")
                         .solve(36);
  const auto& motion = std::get<DrivenMotion>(moved);
  ASSERT_TRUE(motion.end);
  const std::size_t last = motion.steps.size() - 1;
  const MovedPoint& a = point_of(motion, "A");
  EXPECT_TRUE(a.velocities.front() && a.accelerations.front());
  EXPECT_FALSE(a.velocities[last] || a.accelerations[last]);
  EXPECT_TRUE(a.places[last].allFinite());
  const MovedLink& rod = motion.links[1];
  EXPECT_TRUE(rod.rates.front() && rod.accelerations.front());
  EXPECT_FALSE(rod.rates[last] || rod.accelerations[last]);
  EXPECT_FALSE(motion.reactions.empty());
  for (const JointReaction& reaction : motion.reactions) {
    EXPECT_TRUE(reaction.forces.front()) << reaction.name;
    EXPECT_FALSE(reaction.forces[last]) << reaction.name;
  }
  for (const MotionColumn& column : motion.table) {
    EXPECT_TRUE(column.values.front()) << column.name;
    EXPECT_FALSE(column.is_force && column.values[last]) << column.name;
  }
}

TEST(Chains, AreThoseOfSixLinks) {
  EXPECT_NE(std::get<std::string>(chains(6)).find("\"joints\": 7"), std::string::npos);
  EXPECT_EQ(std::get<InputError>(chains(1)).key, "links");
  EXPECT_EQ(std::get<InputError>(chains(6, 41)).key, "freedoms");
}

TEST(Generators, GiveLinkagesThatMove) {
  const auto lens = generate_inversor(KEMPE_SOURCE_DIR "/specs/examples/generators/enlarger.toml");
  const auto& inversors = std::get<Generated>(lens).linkages;
  ASSERT_EQ(inversors.size(), 2U);
  EXPECT_EQ(inversors[0].kind, "right_angle");
  const auto moved = linkage_of(inversors[0].text).solve(6);
  const auto& motion = std::get<DrivenMotion>(moved);
  for (std::size_t i = 0; i < motion.steps.size(); ++i)
    EXPECT_NEAR(std::abs(point_of(motion, "P").places[i].x() * point_of(motion, "Q").places[i].x()), 22500,
                1e-6);
  const auto dial = generate_function(KEMPE_SOURCE_DIR "/specs/examples/generators/table.toml");
  EXPECT_EQ(std::get<Generated>(dial).linkages.at(0).kind, "four_bar");
  EXPECT_NE(std::get<Generated>(dial).plot.find("<svg"), std::string::npos);
  EXPECT_EQ(std::get<InputError>(generate_function_text("", "dial.toml")).file, "dial.toml");
  Options at_once;
  at_once.time_limit = 0;
  EXPECT_TRUE(std::get<NothingGenerated>(
                  generate_function(KEMPE_SOURCE_DIR "/specs/examples/generators/table.toml", at_once))
                  .stopped);
  EXPECT_EQ(std::get<InputError>(generate_inversor_text("", "lens.toml")).file, "lens.toml");
}

TEST(Generators, PathGeneratorsComeWithTheirCognates) {
  const auto found = generate_path(KEMPE_SOURCE_DIR "/specs/examples/generators/five-poses.toml");
  const auto& linkages = std::get<Generated>(found).linkages;
  ASSERT_GE(linkages.size(), 3U);
  EXPECT_EQ(linkages[0].kind, "answer_1");
  EXPECT_EQ(linkages[2].kind, "answer_1_cognate_2");
  const auto moved = linkage_of(linkages[0].text).solve(6);
  EXPECT_EQ(std::get<DrivenMotion>(moved).steps.size(), 7U);
  EXPECT_EQ(std::get<InputError>(generate_path_text("", "path.toml")).file, "path.toml");
  // Five poses, told with what the coupler reaches; of a cognate the points alone.
  ASSERT_EQ(linkages.front().wanted.size(), 5);
  for (const PlaceAskedFor& place : linkages.front().wanted) {
    EXPECT_LT((place.at - place.reached).norm(), 1e-6);
    ASSERT_TRUE(place.angle && place.reached_angle);
  }
  EXPECT_EQ(linkages[1].kind, "answer_1_cognate_1");
  EXPECT_FALSE(linkages[1].wanted.front().angle);
  const auto linkage = std::get<Linkage>(Linkage::parse(linkages.front().text));
  const auto page = linkage.animation(Linkage::AnimationFile::page, {}, {}, linkages.front().wanted);
  ASSERT_TRUE(std::holds_alternative<std::string>(page));
  EXPECT_NE(std::get<std::string>(page).find("id=\"wanted\""), std::string::npos);
  EXPECT_EQ(std::get<std::string>(linkage.animation(Linkage::AnimationFile::page)).find("id=\"wanted\""),
            std::string::npos);
}

}  // namespace
}  // namespace kempe
