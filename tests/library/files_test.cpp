// Designs as files, by the library.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "kempe/kempe.hpp"

namespace kempe {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("kempe-library-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Outcome mapped() {
  Spec spec;
  spec.copy = Copy::of(1.4, 90 * degree);
  spec.region = Region::rectangle({62, -5}, {8, 10});
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;
  spec.mechanism = MechanismSpec{.grounding = Grounding::pole, .VA = 50, .VB = 35, .assembly_mode = 3};
  spec.limits.transmission = 15 * degree;
  return map(spec);
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Write, WritesWhatTheAuditCertifies) {
  const Folder folder;
  const Outcome outcome = mapped();
  ASSERT_TRUE(outcome) << outcome.reason();
  const Written written = write(*outcome, folder.path() / "design");
  ASSERT_TRUE(written) << written.reason;
  for (const std::string& file : written.files)
    EXPECT_TRUE(fs::exists(folder.path() / "design" / file)) << file;
  EXPECT_NE(std::find(written.files.begin(), written.files.end(), "report.html"), written.files.end());
  const auto audit = verify(folder.path() / "design" / "design.json");
  ASSERT_TRUE(std::holds_alternative<Audit>(audit)) << std::get<InputError>(audit).message();
  EXPECT_TRUE(std::get<Audit>(audit).holds);
}

TEST(Write, SaysWhyNothingIsWritten) {
  const Folder folder;
  std::ofstream(folder.path() / "file") << "in the way";
  const Outcome outcome = mapped();
  ASSERT_TRUE(outcome);
  const Written written = write(*outcome, folder.path() / "file");
  EXPECT_FALSE(written);
  EXPECT_TRUE(written.files.empty());
  EXPECT_NE(written.reason, "");
  EXPECT_EQ(text_of(folder.path() / "file"), "in the way");
}

TEST(VerifyFile, FindsWhatWasChanged) {
  const Folder folder;
  const Outcome outcome = mapped();
  ASSERT_TRUE(outcome && write(*outcome, folder.path()));
  std::string text = text_of(folder.path() / "design.json");
  const std::size_t at = text.find("\"VA\"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t digit = text.find("50", at);
  ASSERT_NE(digit, std::string::npos);
  text.replace(digit, 2, "51");
  std::ofstream(folder.path() / "design.json") << text;
  const auto audit = verify(folder.path() / "design.json");
  EXPECT_FALSE(std::holds_alternative<Audit>(audit) && std::get<Audit>(audit).holds);
}

TEST(VerifyFile, SaysWhyAFileCannotBeRead) {
  EXPECT_TRUE(std::holds_alternative<InputError>(verify(fs::path("/nowhere/design.json"))));
}

TEST(Calibrate, SaysTheSameOfAFileAndOfItsText) {
  const fs::path file = KEMPE_SOURCE_DIR "/specs/examples/calibration/knight.toml";
  const auto found = calibrate(file), again = calibrate_text(text_of(file), "", file.parent_path());
  ASSERT_TRUE(std::holds_alternative<std::string>(found)) << std::get<InputError>(found).messages();
  EXPECT_EQ(found.index(), again.index());
  EXPECT_EQ(std::get<std::string>(found), std::get<std::string>(again));
  EXPECT_NE(std::get<std::string>(found).find("\"corrections_mm\""), std::string::npos);
  EXPECT_EQ(std::get<InputError>(calibrate_text("[instrument]\narm_mm = -1\n", "bench.toml")).file,
            "bench.toml");
}

TEST(Texts, AreThoseOfTheFiles) {
  const Folder folder;
  const Outcome outcome = mapped();
  ASSERT_TRUE(write(*outcome, folder.path() / "texts", {.title = "a title"}));
  EXPECT_EQ(text_of(folder.path() / "texts" / "report.html"), report(*outcome, "a title"));
  EXPECT_EQ(text_of(folder.path() / "texts" / "drawing.svg"), drawing(*outcome));
  EXPECT_EQ(text_of(folder.path() / "texts" / "design.json"), verified_json(*outcome));
}

TEST(Restore, GivesTheSameDesignFromItsText) {
  const std::string text = verified_json(*mapped());
  const auto again = restore(text);
  ASSERT_TRUE(std::holds_alternative<FinishedDesign>(again)) << std::get<InputError>(again).messages();
  EXPECT_EQ(verified_json(std::get<FinishedDesign>(again)), text);
}

TEST(Restore, BelievesNoBound) {
  const Outcome outcome =
      design(std::get<Spec>(parse("[copy]\nscale = 1.4\nrotation_deg = 90\n"
                                  "[region]\nrectangle_mm = [62, -5, 8, 10]\n")));
  ASSERT_TRUE(outcome) << outcome.reason();
  const std::string text = verified_json(*outcome);
  const auto kept = restore(text, "", ClaimedBound::keep), proven = restore(text);
  ASSERT_TRUE(std::holds_alternative<FinishedDesign>(kept));
  ASSERT_TRUE(std::holds_alternative<FinishedDesign>(proven));
  EXPECT_EQ(std::get<FinishedDesign>(kept).proven_bound(), outcome->proven_bound());
  const auto bound = std::get<FinishedDesign>(proven).proven_bound();
  EXPECT_LE(bound.value_or(0), *outcome->proven_bound());
}

TEST(Restore, SaysWhatDoesNotHold) {
  std::string text = verified_json(*mapped());
  text.replace(text.find("\"reachable_mm2\": ") + 17, 1, "9");
  const auto found = restore(text, "forged.json");
  ASSERT_TRUE(std::holds_alternative<InputError>(found));
  EXPECT_EQ(std::get<InputError>(found).file, "forged.json");
  EXPECT_EQ(std::get<InputError>(found).key, "workspace.reachable_mm2");
  EXPECT_TRUE(std::holds_alternative<InputError>(restore("{")));
}

}  // namespace
}  // namespace kempe
