// Every file of tests/corpus/linkage-faults has one fault; its first line says what the reader must answer.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "specs/linkages/linkage_file.hpp"

namespace kempe {
namespace {

using std::filesystem::path;

std::vector<path> files_in(const char* folder) {
  std::vector<path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path(KEMPE_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string stem_of(const testing::TestParamInfo<path>& info) {
  std::string name = info.param.stem().string();
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}

class LinkageFaults : public testing::TestWithParam<path> {};

TEST_P(LinkageFaults, AreRefusedWithLineKeyAndWhatIsAllowed) {
  std::ifstream stream(GetParam());
  std::string line;
  std::getline(stream, line);
  const std::string mark = "# expect: ";
  ASSERT_TRUE(line.starts_with(mark));
  const auto file = read_linkage_file(GetParam().string());
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message(), testing::HasSubstr(line.substr(mark.size())));
  EXPECT_THAT(file.error().message(), testing::HasSubstr("allowed: "));
  EXPECT_GT(file.error().line + (file.error().key == "links" ? 1 : 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Corpus, LinkageFaults, testing::ValuesIn(files_in("tests/corpus/linkage-faults")),
                         stem_of);

class LinkageExampleFiles : public testing::TestWithParam<path> {};

TEST_P(LinkageExampleFiles, AreReadAndStayUnderFortyLines) {
  const auto file = read_linkage_file(GetParam().string());
  ASSERT_TRUE(file) << file.error().message();
  std::ifstream stream(GetParam());
  const auto lines =
      std::count(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>(), '\n');
  EXPECT_LT(lines, 40);
}

INSTANTIATE_TEST_SUITE_P(Shipped, LinkageExampleFiles, testing::ValuesIn(files_in("specs/examples/linkages")),
                         stem_of);

}  // namespace
}  // namespace kempe
