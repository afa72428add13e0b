// The measurements file: what is understood, and what is refused with which words.
#include "specs/measurements.hpp"

#include <gtest/gtest.h>

#include <string>

#include "specs/text/ratio.hpp"

namespace kempe {
namespace {

const std::string knight = R"([instrument]
arm_mm = 500
ratio = 0.5
[[reading]]
arm_angle_deg = 30
error_mm = [0.12, -0.40]
[[reading]]
arm_angle_deg = 60
error_mm = [0.30, -0.50]
)";

std::string refusal(const std::string& text) {
  const auto read = read_measurements(text, "m.toml");
  return read ? "understood" : read.error().message();
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_words(const std::string& message, std::initializer_list<std::string> words) {
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << message << "\nlacks " << word;
}

TEST(Measurements, ReadsKnightsTwoReadings) {
  const auto read = read_measurements(knight, "m.toml");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->instrument->arm, 500);
  ASSERT_EQ(read->readings.size(), 2u);
  EXPECT_DOUBLE_EQ(*read->readings[1].arm_angle, radians(60));
  EXPECT_EQ(read->readings[0].error, Point(0.12, -0.40));
  EXPECT_EQ(read->readings[0].round, 1);
  EXPECT_EQ(read->readings[0].line, 4);
}

TEST(Measurements, ReadsADesignWithPairsOfPlaces) {
  for (const std::string where : {"design = \"d.json\"\n", "[instrument]\ndesign = \"d.json\"\n"}) {
    const auto read = read_measurements(where + R"([[reading]]
tracer_mm = [1, 2]
pen_mm = [3, 4]
[lengths_mm]
CX = 300.1
uncertainty_mm = 0.05
[fit]
free = ["lengths", "frame"]
keep_outliers = true
)",
                                        "m.toml");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->design, "d.json");
    EXPECT_FALSE(read->instrument);
    EXPECT_EQ(read->readings[0].pen, Point(3, 4));
    ASSERT_EQ(read->lengths.size(), 1u);
    EXPECT_EQ(read->lengths[0].name, "CX");
    EXPECT_EQ(read->lengths[0].uncertainty, 0.05);
    EXPECT_EQ(read->fit.free, (std::vector<std::string>{"lengths", "frame"}));
    EXPECT_TRUE(read->fit.keep_outliers);
  }
}

TEST(Measurements, ReadsRatiosInEveryWayPeopleWriteThem) {
  EXPECT_DOUBLE_EQ(*parse_ratio("1:3"), 1.0 / 3);
  EXPECT_DOUBLE_EQ(*parse_ratio("2 / 5"), 0.4);
  EXPECT_DOUBLE_EQ(*parse_ratio("0.25"), 0.25);
  for (const char* text : {"", ":", "1:", "1:0", "-1:2", "1:2:3", "one", "nan", "inf", "1e999"})
    EXPECT_FALSE(parse_ratio(text)) << text;
}

TEST(Measurements, RefusesSwappedUnitsWithAGuess) {
  expect_words(refusal(with(knight, "= 500", "= 0.5")),
               {"m.toml:2", "instrument.arm_mm", "found 0.5", "not metres"});
  expect_words(refusal(with(knight, "= 30", "= 0.5236")),
               {"m.toml:5", "arm_angle_deg", "0.5236", "radians?"});
  expect_words(refusal(with(knight, "[0.12, -0.40]", "[120, -400]")),
               {"m.toml:6", "error_mm", "twentieth", "micrometres"});
}

TEST(Measurements, RefusesArmAnglesAtTheEndsAndSaysWhereToMeasure) {
  for (const char* angle : {"= 0", "= 90", "= 2", "= 88.5", "= -30", "= 120"})
    expect_words(refusal(with(knight, "= 30", angle)), {"m.toml:5", "reading.arm_angle_deg"});
  expect_words(refusal(with(knight, "= 60", "= 90")), {"m.toml:8", "lose rank", "30 and 60"});
}

TEST(Measurements, NamesTheNearestKey) {
  expect_words(refusal(with(knight, "error_mm", "eror_mm")),
               {"m.toml:6", "reading.eror_mm", "an unknown key", "error_mm"});
  expect_words(refusal(with(knight, "[instrument]", "[instrumnt]")), {"m.toml:1", "instrumnt", "instrument"});
  expect_words(refusal(knight + "[fit]\nfree = [\"scale\"]\n"), {"fit.free", "scales"});
  expect_words(refusal(knight + "[fit]\nmethod = \"knights\"\n"), {"fit.method", "least_squares"});
}

TEST(Measurements, RefusesWhatContradictsItself) {
  expect_words(refusal("design = \"d.json\"\n" + knight), {"both [instrument] and design"});
  expect_words(refusal("[[reading]]\ntracer_mm=[0,0]\npen_mm=[0,0]\n"), {"neither [instrument] nor design"});
  expect_words(refusal(with(knight, "error_mm = [0.12, -0.40]", "")),
               {"m.toml:4", "reading.error_mm", "no such key"});
  expect_words(refusal(with(knight, "arm_angle_deg = 30", "tracer_mm = [1, 2]")),
               {"an arm angle or departure and a place"});
  expect_words(refusal("design = \"d.json\"\n[[reading]]\narm_angle_deg = 30\nerror_mm = [0, 0]\n"),
               {"arm angles are for"});
  expect_words(refusal("design = \"d.json\"\n[fit]\nmethod = \"knight\"\n"), {"fit.method", "least_squares"});
  expect_words(refusal(with(knight, "arm_angle_deg = 30", "round = 3\narm_angle_deg = 30")),
               {"reading.round", "found 3"});
  expect_words(refusal(knight + "[use]\narm_angles_deg = [70, 20]\n"),
               {"use.arm_angles_deg", "lower, upper"});
}

TEST(Measurements, RefusesWrongKindsOfValues) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"= 500", "= \"500\""},
                                 {"= 500", "= nan"},
                                 {"= 500", "= inf"},
                                 {"= 500", "= -500"},
                                 {"= 0.5", "= 1"},
                                 {"= 0.5", "= true"},
                                 {"[0.12, -0.40]", "[0.12]"},
                                 {"[0.12, -0.40]", "[0.12, -0.40, 1]"},
                                 {"[0.12, -0.40]", "[0.12, nan]"},
                                 {"[0.12, -0.40]", "0.12"},
                                 {"[[reading]]", "[reading]"},
                                 {"[instrument]", "instrument = 3\n[other]"}})
    EXPECT_NE(refusal(with(knight, from, to)), "understood") << to;
  for (const char* more : {"[plan]\nreadings = 0\n", "[simulate]\ninstruments = 1.5\n",
                           "[simulate]\nerrors_mm = 3\n", "[simulate]\nerrors_mm = {XY = 1}\n",
                           "[use]\nratios = [\"a\"]\n", "[use]\nratios = 3\n", "[lengths_mm]\nVA = 3\n",
                           "[fit]\nfree = []\n", "[fit]\ntarget_mm = 0\n", "[fit]\nkeep_outliers = 1\n"})
    EXPECT_NE(refusal(knight + more), "understood") << more;
}

TEST(Measurements, EveryPrefixOfAFileIsReadOrRefusedWithWords) {
  const std::string whole =
      knight + "[use]\nratios = [\"1:2\"]\n[simulate]\nerrors_mm = {AC = 0.1}\n[plan]\nreadings = 4\n";
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto read = read_measurements(whole.substr(0, length), "m.toml");
    EXPECT_TRUE(read || !read.error().message().empty()) << length;
  }
}

}  // namespace
}  // namespace kempe
