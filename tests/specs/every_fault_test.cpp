// A spec with several faults is refused with every one of them, in the order of the file.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "specs/spec_reader.hpp"
#include "specs/text/complaints.hpp"

namespace kempe {
namespace {

/// A table as it should stand, and a line in it as it should not: what the reader finds there is said by no other table.
struct Slip {
  std::string head, sound, faulty, key;
};

const std::vector<Slip> slips{
    {"[copy]\nrotation_deg = 90\n", "scale = 1.4\n", "scale = 0\n", "copy.scale"},
    {"[region]\n", "circle_mm = {centre = [66, 0], radius = 4}\n",
     "polygon_mm = [[0, 0], [2, 2], [0, 2], [2, 0]]\n", "region.polygon_mm"},
    {"[pole]\n", "at_mm = [0, 0]\n", "at_mm = [0, nan]\n", "pole.at_mm"},
    {"[links]\nwidth_mm = 6\n", "pin_diameter_mm = 3\n", "pin_diameter_mm = 7\n", "links.pin_diameter_mm"},
    {"[limits]\n", "clearance_mm = 1\n", "clearence_mm = 1\n", "limits.clearence_mm"},
    {"[tolerance]\nlength_mm = 0.1\n", "play_mm = 0.1\n", "play_mm = \"0.1\"\n", "tolerance.play_mm"},
    {"[objective]\n", "minimize = \"size\"\n", "minimize = \"cost\"\n", "objective.minimize"},
    {"[[obstacles]]\nlayers = [1, 2]\n", "rectangle_mm = {at = [300, 0], size = [9, 9]}\n",
     "rectangle_mm = {at = [300, 0]}\n", "obstacles.rectangle_mm.size"},
    {"[cutting]\n", "gap_mm = 4\n", "gap_mm = -4\n", "cutting.gap_mm"},
    {"[material]\nname = \"steel\"\n", "E_GPa = 210\n", "E_MPa = 210000\n", "material.E_MPa"},
    {"[tool]\n", "cutter_radius_mm = 2\n", "cutter_radius_cm = 2\n", "tool.cutter_radius_cm"}};

std::vector<InputError> faults_of(const std::string& text) {
  const auto spec = read_spec(text, "spec.toml", ".");
  if (spec) return {};
  std::vector<InputError> faults{spec.error()};
  faults.insert(faults.end(), spec.error().others.begin(), spec.error().others.end());
  return faults;
}

int lines_in(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

TEST(EveryFault, OfRandomSlipsIsToldWithItsLineAndInTheOrderOfTheFile) {
  std::mt19937_64 random(20);
  for (int i = 0; i < 300; ++i) {
    std::vector<Slip> tables = slips;
    for (std::size_t k = tables.size(); k > 1; --k) std::swap(tables[k - 1], tables[random() % k]);
    std::string text;
    std::vector<std::pair<int, std::string>> expected;
    for (const Slip& slip : tables) {
      const bool is_faulty = random() % 2 == 0;
      text += slip.head + (is_faulty ? slip.faulty : slip.sound);
      if (is_faulty) expected.emplace_back(lines_in(text), slip.key);
    }
    std::vector<std::pair<int, std::string>> told;
    for (const InputError& fault : faults_of(text)) {
      told.emplace_back(fault.line, fault.key);
      EXPECT_EQ(fault.file, "spec.toml");
    }
    EXPECT_EQ(told, expected) << text;
  }
}

TEST(EveryFault, MeansOneMistakeOnce) {
  for (const auto& [wrong, key] : std::vector<std::pair<std::string, std::string>>{
           {"[cpoy]\nscale = 2\n[region]\ncircle_mm = {centre = [9, 9], radius = 1}\n", "cpoy"},
           {"scale = 2\n[region]\ncircle_mm = {centre = [9, 9], radius = 1}\n", "scale"},
           {"[copy]\nscale = 2\n[region]\ncircle_mm = {centre = [9, 9], raduis = 1}\n",
            "region.circle_mm.raduis"},
           {"[copy]\nscale = 2\n[mechanism]\nvertex = \"pole\"\nVA = 50\nVB_mm = 35\n", "mechanism.VA"}}) {
    const auto faults = faults_of(wrong);
    ASSERT_EQ(faults.size(), 1u) << wrong << faults.front().messages();
    EXPECT_EQ(faults.front().key, key);
  }
}

TEST(EveryFault, HasALineOfItsOwnInTheMessages) {
  const auto spec = read_spec("[copy]\nscale = 0\n[region]\nmargin = 1\n", "spec.toml", ".");
  ASSERT_FALSE(spec);
  EXPECT_EQ(
      spec.error().messages(),
      "spec.toml:2: copy.scale: found 0; allowed: a number > 0 and <= 10000, or two as text: \"1:3\"; scale "
      "-c is "
      "scale c with 180 degrees more rotation\n"
      "spec.toml:4: region.margin: found an unknown key; allowed: margin_mm: lengths are in millimetres");
}

TEST(Complaints, StandInTheOrderOfTheFileAndAreNotMoreThanAPersonReads) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    Complaints complaints("a.toml");
    std::vector<int> lines;
    for (std::uint64_t count = 1 + random() % 150; count > 0; --count) {
      lines.push_back(static_cast<int>(random() % 300));  // 0: no line
      complaints.add(lines.back(), "key", "found", "allowed");
    }
    std::stable_sort(lines.begin(), lines.end(), [](int a, int b) { return a != 0 && (b == 0 || a < b); });
    lines.resize(std::min(lines.size(), Complaints::most));
    const InputError first = complaints.all();
    ASSERT_EQ(1 + first.others.size(), lines.size());
    EXPECT_EQ(first.line, lines.front());
    for (std::size_t k = 1; k < lines.size(); ++k) EXPECT_EQ(first.others[k - 1].line, lines[k]);
  }
}

TEST(Complaints, AreAboutATableOrItsKeysOnly) {
  Complaints complaints("a.toml");
  complaints.add(1, "links.width_mm", "found", "allowed");
  complaints.add(2, "copy", "found", "allowed");
  EXPECT_FALSE(complaints.none_about("links"));
  EXPECT_FALSE(complaints.none_about("links.width_mm"));
  EXPECT_FALSE(complaints.none_about("copy"));
  EXPECT_TRUE(complaints.none_about("link"));
  EXPECT_TRUE(complaints.none_about("links.width"));
  EXPECT_TRUE(complaints.none_about("region"));
}

}  // namespace
}  // namespace kempe
