#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <random>

#include "app/batch/index.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

class BatchIndices : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::path(KEMPE_BINARY_DIR) / "test-output" / ("index-" + std::to_string(::getpid()));
};

/// Keys that meet in few slots, 0 among them, as well as keys from all over.
std::uint64_t draw_key(std::mt19937_64& chance) {
  return chance() % 2 == 0 ? chance() : (chance() % 50) << (chance() % 2 == 0 ? 0 : 40);
}

TEST_F(BatchIndices, KnowWhatAMapKnows) {
  std::mt19937_64 chance(1);
  for (int round = 0; round < 100; ++round) {
    const auto count = static_cast<std::int64_t>(chance() % 300);
    auto index = BatchIndex::make(folder_, count);
    ASSERT_TRUE(index) << index.error();
    std::map<std::uint64_t, std::optional<JournalPlace>> known;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::uint64_t key = draw_key(chance);
      index->add(key);
      known.try_emplace(key == 0 ? 1 : key);
    }
    for (int i = 0; i < 600; ++i) {
      const std::uint64_t key = draw_key(chance);
      const JournalPlace place{static_cast<int>(chance() % 1'000'000),
                               static_cast<std::int64_t>(chance() >> 21)};
      index->set(key, place);
      if (const auto found = known.find(key == 0 ? 1 : key); found != known.end()) found->second = place;
    }
    for (const auto& [key, place] : known) {
      const auto found = index->place(key);
      ASSERT_EQ(found.has_value(), place.has_value());
      if (!found) continue;
      EXPECT_EQ(found->journal, place->journal);
      EXPECT_EQ(found->offset, place->offset);
    }
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t key = chance();
      EXPECT_TRUE(known.contains(key) || !index->place(key));
    }
    EXPECT_FALSE(index->failure());
  }
}

TEST_F(BatchIndices, LeaveNoFileAndNameTheFolderThatIsNotThere) {
  const auto index = BatchIndex::make(folder_, 1000);
  ASSERT_TRUE(index);
  EXPECT_TRUE(fs::is_empty(folder_));
  const auto none = BatchIndex::make(folder_ / "absent", 1000);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().find((folder_ / "absent").string()), std::string::npos) << none.error();
}

}  // namespace
}  // namespace kempe::app
