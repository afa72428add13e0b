// Every file of tests/corpus/specs is a spec with one fault, but one has three; its first line says what the reader must
// answer first.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

using std::filesystem::path;

const path corpus = path(KEMPE_SOURCE_DIR) / "tests/corpus/specs";

std::vector<path> corpus_files() {
  std::vector<path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What follows "# expect: " in the first line.
std::string expectation(const path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::string mark = "# expect: ";
  return line.starts_with(mark) ? line.substr(mark.size()) : "";
}

class SpecCorpus : public testing::TestWithParam<path> {};

TEST_P(SpecCorpus, IsRefusedWithFileLineKeyAndWhatIsAllowed) {
  const std::string expected = expectation(GetParam());
  ASSERT_FALSE(expected.empty());
  const auto spec = read_spec_file(GetParam());
  ASSERT_FALSE(spec);
  // A leading colon stands after the spec's own name.
  const std::string own_name = expected.starts_with(":") ? GetParam().string() : "";
  EXPECT_THAT(spec.error().message(), testing::HasSubstr(own_name + expected));
  EXPECT_THAT(spec.error().message(), testing::HasSubstr("; allowed: "));
  const bool has_three = GetParam().stem() == "topmost-of-several";
  EXPECT_EQ(spec.error().others.size(), has_three ? 2u : 0u) << spec.error().messages();
}

std::string test_name(const testing::TestParamInfo<path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, SpecCorpus, testing::ValuesIn(corpus_files()), test_name);

TEST(SpecFile, ThatDoesNotExistIsNamed) {
  const auto spec = read_spec_file("no/such/spec.toml");
  ASSERT_FALSE(spec);
  EXPECT_EQ(spec.error().message(),
            "no/such/spec.toml: found no such file; allowed: a file that can be read");
}

TEST(SpecFile, ThatIsAFolderIsRefused) {
  const auto spec = read_spec_file(corpus);
  ASSERT_FALSE(spec);
  EXPECT_THAT(spec.error().message(), testing::HasSubstr("found a folder"));
}

TEST(SpecFile, WithoutEndIsRefused) {
  const auto spec = read_spec_file("/dev/zero");
  ASSERT_FALSE(spec);
  EXPECT_THAT(spec.error().message(),
              testing::HasSubstr("found a larger file; allowed: 256 megabytes at most"));
}

TEST(SpecText, OfNoBytesIsRefused) {
  const auto spec = read_spec("", "empty.toml", ".");
  ASSERT_FALSE(spec);
  EXPECT_EQ(spec.error().message(), "empty.toml: found an empty file; allowed: a TOML file");
}

TEST(SpecText, OfBlanksAndNotesLacksItsTables) {
  const auto spec =
      read_spec(" \n\t\n# only a note ..................................... here\n", "blank.toml", ".");
  ASSERT_FALSE(spec);
  EXPECT_THAT(spec.error().message(), testing::HasSubstr("copy: found nothing; allowed: a table [copy]"));
}

TEST(SpecText, OfNoiseOrInvalidUtf8IsRefused) {
  for (const std::string& text :
       {std::string("\xff\xfe[copy]"), std::string("\0\0\0", 3), std::string("[copy]\nscale = 1 # \xc3\x28"),
        std::string("\x89PNG\r\n\x1a\n"), std::string("PK\x03\x04\x14\0\0", 7)}) {
    const auto spec = read_spec(text, "noise.toml", ".");
    ASSERT_FALSE(spec);
    EXPECT_EQ(spec.error().file, "noise.toml");
    EXPECT_FALSE(spec.error().found.empty());
  }
}

TEST(SpecText, WithAByteOrderMarkAndWindowsLinesIsRead) {
  EXPECT_TRUE(read_spec(
      "\xef\xbb\xbf[copy]\r\nscale = 2\r\n[region]\r\ncircle_mm = {centre = [50, 0], radius = 9}\r\n",
      "windows.toml", "."));
}

TEST(SpecText, MayHoldRowsOfDotsInStringsAndNotes) {
  const auto spec = read_spec(
      "# . . . . . . . . . . . . . . . . . . . . . . . .\n[copy]\nscale = 2 # "
      "..........................\n[region]\n"
      "file = '''..........................................'''\n",
      "dots.toml", ".");
  ASSERT_FALSE(spec);
  EXPECT_EQ(spec.error().key, "region.file");
}

TEST(SpecText, WithAnUnknownKeyOfAMillionLettersIsRefusedBriefly) {
  const auto spec = read_spec("[copy]\n" + std::string(1'000'000, 'a') + " = 1\n", "long.toml", ".");
  ASSERT_FALSE(spec);
  EXPECT_LT(spec.error().message().size(), 300u);
}

}  // namespace
}  // namespace kempe
