// A spec in inches means what the same spec in millimetres means; short forms mean what the long ones mean.

#include "specs/spec_unit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "specs/spec_check.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

std::string read(const std::string& text) {
  const auto spec = read_spec(text, "spec.toml", ".");
  return spec ? spec_as_toml(*spec) : spec.error().messages();
}

/// The same lengths, whole numbers and tenths of inches, in either unit, to the last bit.
std::string random_spec(std::mt19937_64& random, SpecUnit unit) {
  const auto drawn = [&](int least, int most) {
    return least + static_cast<int>(random() % static_cast<std::uint64_t>(most - least + 1));
  };
  const auto written = [&](double inches) {
    return fmt::format("{}", unit == SpecUnit::inch ? inches : in_mm(SpecUnit::inch) * inches);
  };
  const auto tenths = [&](int least, int most) { return written(drawn(least, most) / 10.0); };
  const auto whole = [&](int least, int most) { return written(drawn(least, most)); };  // an integer of TOML
  std::string text = fmt::format(
      "[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\nrectangle_mm = {{at = [{}, {}], size = [{}, {}]}}\n"
      "margin_mm = {}\n[pole]\nat_mm = [{}, {}]\n[links]\nwidth_mm = {}\npin_diameter_mm = {}\nlayers = 4\n"
      "longest_mm = {}\nshortest_mm = {}\nstock_mm = [{}, {}]\n[limits]\nclearance_mm = {}\ntransmission_deg "
      "= 25\n"
      "[tolerance]\nlength_mm = {}\n[[obstacles]]\ncircle_mm = [{}, {}, {}]\nlayers = [1, 2]\n"
      "[[obstacles]]\npolygon_mm = [[{}, 0], [{}, 0], [{}, {}]]\n[cutting]\nsheet_mm = [{}, {}]\n",
      tenths(20, 40), whole(-3, 3), tenths(10, 30), whole(1, 3), tenths(0, 9), whole(-4, 4), tenths(-40, 40),
      tenths(5, 9), tenths(1, 4), whole(20, 30), tenths(5, 20), whole(3, 9), tenths(30, 90), tenths(0, 2),
      tenths(0, 1), whole(10, 20), tenths(-90, 90), tenths(3, 9), whole(10, 20), whole(21, 30), whole(10, 30),
      tenths(10, 90), whole(20, 40), tenths(100, 300));
  if (unit == SpecUnit::mm) return text;
  return "units = \"in\"\n" + std::regex_replace(text, std::regex("_mm"), "_in");
}

TEST(Inches, MeanTheSameAsTheirMillimetres) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    std::mt19937_64 one(seed), two(seed);
    const std::string in_inches = read(random_spec(one, SpecUnit::inch)),
                      in_millimetres = read(random_spec(two, SpecUnit::mm));
    ASSERT_EQ(in_inches, in_millimetres) << seed;
    ASSERT_NE(in_inches.find("[copy]"), std::string::npos) << in_inches;
  }
}

TEST(Inches, KeepTheLinesOfTheirFaults) {
  const auto spec = read_spec(
      "units = \"in\"\n[copy]\nscale = 2\n[region]\npolygon_in = [\n  [0, 0],\n  [2, 2],\n  [0, 2], [2, "
      "0]]\n[links]\n"
      "longest_in = 1\nshortest_in = 2\n[mechanism]\nvertex = \"pole\"\nVA_in = 3\n",
      "spec.toml", ".");
  ASSERT_FALSE(spec);
  std::vector<std::pair<int, std::string>> told{{spec.error().line, spec.error().key}};
  for (const InputError& other : spec.error().others) told.emplace_back(other.line, other.key);
  const std::vector<std::pair<int, std::string>> expected{
      {5, "region.polygon_in"}, {11, "links.shortest_in"}, {12, "mechanism.VB_in"}};
  EXPECT_EQ(told, expected) << spec.error().messages();
}

/// "found; allowed" of the faults of a spec in inches, a line each.
std::string told_of(const std::string& tables) {
  const auto spec = read_spec("units = \"in\"\n" + tables, "spec.toml", ".");
  if (spec) return "nothing";
  std::string text = spec.error().found + "; " + spec.error().allowed + "\n";
  for (const InputError& other : spec.error().others) text += other.found + "; " + other.allowed + "\n";
  return text;
}

TEST(Inches, StandInEveryFaultWithTheKeysOfTheFile) {
  const std::string copy = "[copy]\nscale = 2\n", region = "[region]\nrectangle_in = [8, 0, 4, 6]\n";
  const auto links = [&](const std::string& keys) { return told_of(copy + region + "[links]\n" + keys); };
  const std::string range = "2.3 to 10 in (shortest_in, longest_in)",
                    joints = "shortest_in = 2.3\nlongest_in = 10\n";
  EXPECT_EQ(links(joints + "VA_in = 30\n"), "30; " + range + "\n");
  EXPECT_EQ(links(joints + "grid_in = 12.7\n"),
            "12.7, of which no multiple is a length allowed; lengths from " + range + "\n");
  EXPECT_EQ(links(joints + "grid_in = 4e-5\n"),
            "4e-05 beside longest_in = 10; at least longest_in / 100000\n");
  EXPECT_EQ(links(joints + "stock_in = [0.1, 11]\n"),
            "no length that is allowed; at least one length from " + range + "\n");
  EXPECT_EQ(links(joints + "stock_in = [4]\ngrid_in = 1\n"),
            "it beside grid_in; one of grid_in and stock_in\n");
  EXPECT_EQ(links(joints + "VA_in = 4\nCY_in = 3\n"), "nothing") << "no parallelogram's sides";
  EXPECT_EQ(links(joints + "VA_in = 4\nBC_in = 4.7\n"),
            "4.7 beside VA_in = 4; BC = VA: opposite sides of the parallelogram\n");
  EXPECT_EQ(links("shortest_in = 2.3\nlongest_in = 1.1\n"),
            "shortest_in 2.3 above longest_in 1.1; shortest_in <= longest_in\n");
  EXPECT_EQ(links("width_in = 0.7\npin_diameter_in = 0.9\n"),
            "a pin of 0.9 in in a link 0.7 in wide; pin_diameter_in <= width_in\n");
  EXPECT_EQ(links("width_in = 0.7\nsections_in = [[0.7, 0.2]]\n"), "it beside sections_in; one of the two\n");
  EXPECT_EQ(links("width_in = 0.2\nhardware = \"608 bearing\"\n"),
            "a pin of 0.31496062992125984 in in a link 0.2 in wide; pin_diameter_in <= width_in\n"
            "\"608 bearing\" in links 0.2 in wide; links.width_in above 0.8661417322834646\n"
            "\"608 bearing\" in links 0.15748031496062992 in thick; links.thickness_in of at least "
            "0.2755905511811024\n");
  EXPECT_EQ(told_of(copy + region +
                    "[links]\nshortest_in = 2\nwidth_in = 0.75\n[limits]\nlongest_strip_in = 2.5\n"),
            "2.5; at least 2.75 in: links.shortest_in and links.width_in\n");
  EXPECT_EQ(
      told_of(copy + region + "[limits]\ncopy_error_in = 0.1\n"),
      "the copy error asked for without [tolerance]; it with a table [tolerance]: length_in, play_in\n");
  EXPECT_EQ(told_of(copy + region + "[tolerance]\nlength_in = 0\nrobust = true\n"),
            "true with all tolerances 0; length_in or play_in above 0 beside it\n");
  EXPECT_EQ(told_of(copy + region + "[pole]\nat_in = [1, 2]\nwithin_in = [[0, 0], [1, 0], [0, 1]]\n"),
            "at_in and within_in; exactly one of at_in, within_in\n");
  EXPECT_EQ(told_of("[copy]\n" + region), "nothing; scale and rotation_deg, or pairs_in\n");
  EXPECT_EQ(told_of(copy),
            "nothing; a table [region] with exactly one of polygon_in, rectangle_in, circle_in, file\n");
}

TEST(Inches, NameTheKeysOfASentenceAndNothingElse) {
  const std::string sentence =
      "hole_fit_mm of 2 mm (links.pin_diameter_mm), VA_mm; not area_mm2, my_mm or 3 mm.";
  EXPECT_EQ(keys_in(SpecUnit::mm, sentence), sentence);
  EXPECT_EQ(keys_in(SpecUnit::inch, sentence),
            "hole_fit_in of 2 mm (links.pin_diameter_in), VA_in; not area_mm2, my_mm or 3 mm.");
}

TEST(ShortForms, MeanTheSameAsTheLongOnes) {
  const std::string head = "[copy]\nrotation_deg = 90\n",
                    region = "[region]\ncircle_mm = {centre = [60, -3.5], radius = 4}\n";
  const auto with = [&](const std::string& scale) { return read(head + "scale = " + scale + "\n" + region); };
  EXPECT_EQ(with("\"7:5\""), with("1.4"));
  EXPECT_EQ(with("\"1 : 4\""), with("0.25"));
  EXPECT_EQ(with("\"1/4\""), with("0.25"));
  const auto over = [&](const std::string& shape) {
    return read(head + "scale = 1.4\n[region]\n" + shape + "\n");
  };
  EXPECT_EQ(over("circle_mm = [60, -3.5, 4]"), over("circle_mm = {centre = [60, -3.5], radius = 4}"));
  EXPECT_EQ(over("rectangle_mm = [60, -3.5, 4, 7]"), over("rectangle_mm = {at = [60, -3.5], size = [4, 7]}"));
}

TEST(ShortForms, AreRefusedInOtherLengths) {
  for (const char* shape :
       {"circle_mm = [60, -3.5]", "circle_mm = []", "rectangle_mm = [1, 2, 3, 4, 5]",
        "rectangle_mm = [[1, 2], [3, 4]]", "circle_mm = [60, 0, -1]", "rectangle_mm = [1, 2, 3, nan]"}) {
    const auto spec = read_spec(std::string("[copy]\nscale = 2\n[region]\n") + shape, "spec.toml", ".");
    ASSERT_FALSE(spec) << shape;
    EXPECT_EQ(spec.error().line, 4) << spec.error().messages();
  }
}

TEST(Mirrors, GetOneAnswerInWhateverWordsTheyAreAskedFor) {
  const std::string region = "[region]\ncircle_mm = [60, 0, 4]\n";
  for (const std::string text :
       {"[copy]\nscale = 2\nmirror = true\n", "[copy]\nscale = 2\nmirrored = false\n",
        "[copy]\nscale = 2\nflip_x = 1\n", "[copy]\nscale = -2\n", "[copy]\nscale = [2, -2]\n",
        "[copy]\nscale = \"-2\"\n", "[copy]\nscale = \"-1:3\"\n", "[copy]\nscale = \"mirror\"\n",
        "[copy]\nscale = 2\nreflection = \"y\"\n", "mirror = true\n[copy]\nscale = 2\n",
        "[copy]\nscale = 2\n[mirror]\naxis = \"x\"\n", "[copy]\nscale = 2\nhandedness = \"left\"\n",
        "[copy]\npairs_mm = [[[0, 0], [0, 0]], [[1, 0], [2, 0]], [[0, 1], [0, -2]]]\n"}) {
    const auto spec = read_spec(text + region, "spec.toml", ".");
    ASSERT_FALSE(spec) << text;
    EXPECT_NE(spec.error().allowed.find("cannot mirror, since pole, tracer and pen"), std::string::npos)
        << spec.error().messages();
  }
}

}  // namespace
}  // namespace kempe
