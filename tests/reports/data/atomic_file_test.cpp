#include "reports/data/atomic_file.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class FolderDrafts : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(base_); }
  void TearDown() override { fs::remove_all(base_); }

  /// Names below the base folder, folders included.
  std::vector<std::string> everything() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(base_))
      names.push_back(fs::relative(entry.path(), base_).string());
    std::sort(names.begin(), names.end());
    return names;
  }

  fs::path base_ = fs::path(KEMPE_BINARY_DIR) / "test-output" / ("drafts-" + std::to_string(::getpid()));
};

TEST_F(FolderDrafts, AppearTogether) {
  FolderDraft draft(base_ / "out");
  ASSERT_TRUE(draft.add({"one.txt", "one"}));
  ASSERT_TRUE(draft.add({"parts/two.txt", "two"}));
  EXPECT_FALSE(fs::exists(base_ / "out" / "one.txt"));
  EXPECT_EQ(*read_text_file(*draft.draft_of("parts/two.txt")), "two");
  EXPECT_FALSE(draft.draft_of("three.txt"));
  ASSERT_TRUE(draft.put_in_place());
  EXPECT_THAT(everything(), ElementsAre("out", "out/one.txt", "out/parts", "out/parts/two.txt"));
  EXPECT_THAT(draft.names(), ElementsAre("one.txt", "parts/two.txt"));
  EXPECT_FALSE(draft.draft_of("one.txt"));
}

TEST_F(FolderDrafts, ComeInPiecesSmallAndLarge) {
  FolderDraft draft(base_ / "out");
  ASSERT_TRUE(draft.begin("one.txt"));
  ASSERT_TRUE(draft.begin("two.txt"));
  std::string one, two;
  for (int i = 0; i < 3000; ++i) {
    const std::string piece(static_cast<std::size_t>(i % 200), static_cast<char>('a' + i % 26));
    one += piece;
    two += piece + piece;
    ASSERT_TRUE(draft.append("one.txt", piece));
    ASSERT_TRUE(draft.append("two.txt", piece + piece));
  }
  EXPECT_FALSE(draft.append("three.txt", "x"));
  EXPECT_FALSE(fs::exists(base_ / "out" / "one.txt"));
  ASSERT_TRUE(draft.put_in_place());
  EXPECT_EQ(*read_text_file(base_ / "out" / "one.txt"), one);
  EXPECT_EQ(*read_text_file(base_ / "out" / "two.txt"), two);
  EXPECT_THAT(everything(), ElementsAre("out", "out/one.txt", "out/two.txt"));
}

TEST_F(FolderDrafts, LeaveNothingBehindUnlessPutInPlace) {
  {
    FolderDraft draft(base_ / "a" / "b");
    ASSERT_TRUE(draft.add({"parts/one.txt", "one"}));
    ASSERT_TRUE(draft.begin("two.txt"));
    ASSERT_TRUE(draft.append("two.txt", "two"));
  }
  EXPECT_THAT(everything(), IsEmpty());
}

TEST_F(FolderDrafts, LeaveAFolderThatWasThere) {
  fs::create_directories(base_ / "out");
  std::ofstream(base_ / "out" / "one.txt") << "before";
  {
    FolderDraft draft(base_ / "out");
    ASSERT_TRUE(draft.add({"one.txt", "after"}));
    ASSERT_TRUE(draft.add({"parts/two.txt", "two"}));
  }
  EXPECT_THAT(everything(), ElementsAre("out", "out/one.txt"));
  EXPECT_EQ(*read_text_file(base_ / "out" / "one.txt"), "before");
}

TEST_F(FolderDrafts, NameTheFolderThatCannotBeMade) {
  std::ofstream(base_ / "file") << "no folder";
  FolderDraft draft(base_ / "file" / "out");
  const auto added = draft.add({"one.txt", "one"});
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().find((base_ / "file" / "out").string()), std::string::npos) << added.error();
  EXPECT_THAT(everything(), ElementsAre("file"));
}

}  // namespace
}  // namespace kempe
