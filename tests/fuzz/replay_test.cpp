// Every stored input through its reader: what once was found stays found.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tests/fuzz/degenerate_linkages.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/samples.hpp"

namespace kempe::fuzz {
namespace {

TEST(Corpus, EveryStoredInputIsReadOrRefused) {
  std::size_t replayed = 0;
  const auto neighbours = static_cast<std::size_t>(test::samples(7));
  for (const Target& target : targets()) {
    const auto folder = std::filesystem::path(KEMPE_SOURCE_DIR) / "tests" / "corpus" / target.name;
    ASSERT_TRUE(std::filesystem::is_directory(folder)) << "every reader has a corpus: " << folder;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string input{std::istreambuf_iterator<char>(stream), {}};
      SCOPED_TRACE(entry.path().string());
      target.run(input);
      // The same input cut short and with a byte changed: the nearest neighbours of what people really write.
      for (std::size_t i = 1; i <= neighbours; ++i) {
        target.run(std::string_view(input).substr(0, input.size() * i / 8));
        std::string changed = input;
        if (!changed.empty())
          changed[changed.size() * i / 8 % changed.size()] ^= static_cast<char>(1U << i % 7);
        target.run(changed);
      }
      ++replayed;
    }
  }
  EXPECT_GT(replayed, 10U);
}

TEST(DegenerateLinkages, MoveOrSayWhyTheyDoNot) {
  std::array<int, 3> counts{};
  for (int i = 0; i < test::samples(600); ++i) {
    std::mt19937_64 random(static_cast<std::uint64_t>(i));
    std::string bytes(64, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() >> 56);
    ++counts[static_cast<std::size_t>(
        move_linkage_from_choices(bytes, "degenerate linkage " + std::to_string(i)))];
  }
  for (const int count : counts) EXPECT_GT(count, test::expected(60));
}

}  // namespace
}  // namespace kempe::fuzz
