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

TEST(Studio, HoldsTheSpec) {
  const std::string page = R"(<p></p><script type="application/json" id="studio-spec">null</script>)";
  const std::string spec = "[copy]\nscale = 2\n[region]\ncircle_mm = [80, 0, 20]\n";
  const auto filled = studio_page(page, spec, "plate");
  ASSERT_TRUE(std::holds_alternative<std::string>(filled)) << std::get<InputError>(filled).messages();
  EXPECT_NE(std::get<std::string>(filled).find("circle_mm"), std::string::npos);
  EXPECT_EQ(std::get<InputError>(studio_page(page, "[copy]\nscale = 0\n", "plate")).key, "copy.scale");
  EXPECT_EQ(std::get<InputError>(studio_page("another page", spec)).key, "page");

  const Folder folder;
  const Outcome outcome = mapped();
  const Written written = write(*outcome, folder.path(), {.paper = Paper::A3, .studio = page});
  ASSERT_TRUE(written) << written.reason;
  EXPECT_EQ(std::count(written.files.begin(), written.files.end(), "studio.html"), 1);
  EXPECT_NE(text_of(folder.path() / "report.html").find("<a href=\"studio.html\">"), std::string::npos);
  EXPECT_FALSE(write(*outcome, folder.path() / "no", {.studio = "another page"}));
  EXPECT_FALSE(fs::exists(folder.path() / "no"));
}

TEST(Templates, AreSpecs) {
  EXPECT_EQ(spec_templates().size(), 10);
  for (const SpecTemplate& one : spec_templates()) {
    EXPECT_TRUE(std::holds_alternative<Spec>(parse(one.spec, std::string(one.name)))) << one.name;
    EXPECT_TRUE(one.spec.starts_with("# " + std::string(one.purpose) + "\n")) << one.name;
  }
}

TEST(ProofOfNone, IsThereWhereItIsProven) {
  const auto spec = [](const std::string& longest) {
    return std::get<Spec>(
        parse("[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\nrectangle_mm = [62, -5, 8, 10]\n"
              "[links]\nwidth_mm = 6\nlongest_mm = " +
              longest + "\n"));
  };
  const auto log = proof_of_none(spec("20"));
  ASSERT_TRUE(std::holds_alternative<std::string>(log));
  EXPECT_EQ(std::get<std::string>(log).find("{"), 0);
  EXPECT_TRUE(std::holds_alternative<NoProof>(proof_of_none(spec("200"))));
  EXPECT_TRUE(std::holds_alternative<NoProof>(proof_of_none(spec("20"), [] { return true; })));
  EXPECT_TRUE(std::holds_alternative<InputError>(proof_of_none(Spec{})));
}

TEST(Calibrate, WritesEquationsAndFiles) {
  const fs::path file = KEMPE_SOURCE_DIR "/specs/examples/calibration/knight.toml";
  CalibrationOptions options;
  options.equations = true;
  const auto found = calibrate_file_with(options, file);
  ASSERT_TRUE(std::holds_alternative<CalibratedInstrument>(found)) << std::get<InputError>(found).messages();
  const auto& instrument = std::get<CalibratedInstrument>(found);
  EXPECT_NE(instrument.json.find("\"equations\""), std::string::npos);
  const Folder folder;
  EXPECT_EQ(write(instrument, folder.path()).files,
            (std::vector<std::string>{"calibration.json", "report.html"}));
  EXPECT_EQ(text_of(folder.path() / "calibration.json"), instrument.json);
  options.method = "least_squares";
  EXPECT_EQ(std::get<InputError>(calibrate_file_with(options, file)).key, "equations");
}

TEST(Front, IsWrittenPointByPoint) {
  const Folder folder;
  EXPECT_FALSE(write(Front{}, folder.path() / "none"));
  const Outcome outcome = mapped();
  const Front front{{{1, 2, *outcome}, {2, 3, *outcome}}, true, Objective::size, Objective::footprint};
  const Written written = write(front, folder.path());
  ASSERT_TRUE(written) << written.reason;
  for (const std::string& name : written.files) EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
  EXPECT_TRUE(text_of(folder.path() / "front.csv").starts_with("point,size_mm,footprint_mm2,"));
  EXPECT_TRUE(fs::exists(folder.path() / "02" / "design.json"));
}

TEST(Restore, StopsWithACoarserMap) {
  const auto found = restore(verified_json(*mapped()), "", ClaimedBound::prove, [] { return true; });
  ASSERT_TRUE(std::holds_alternative<FinishedDesign>(found)) << std::get<InputError>(found).messages();
  EXPECT_FALSE(std::get<FinishedDesign>(found).map().complete());
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
