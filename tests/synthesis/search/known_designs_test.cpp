// Every file of tests/corpus/known-designs is a spec with a mechanism that keeps all its limits, found by other means than the
// search. The search may not be worse, the bound not above it.

#include <gtest/gtest.h>

#include <filesystem>

#include "specs/spec_reader.hpp"
#include "synthesis/bound/proven_bound.hpp"
#include "tests/synthesis/kept_limits.hpp"

namespace kempe {
namespace {

using std::filesystem::path;

std::vector<path> corpus_files() {
  std::vector<path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(path(KEMPE_SOURCE_DIR) / "tests/corpus/known-designs"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class KnownDesigns : public testing::TestWithParam<path> {
 protected:
  void SetUp() override {
    const auto read = read_spec_file(GetParam());
    ASSERT_TRUE(read) << read.error().message();
    spec_ = *read;
    ASSERT_TRUE(spec_.mechanism && spec_.objective.objective == Objective::size);
    const MechanismSpec& given = *spec_.mechanism;
    const auto linkage = CopyingLinkage::make(spec_.copy.k(), given.grounding, given.VA, given.VB,
                                              given.assembly_mode, std::get<Point>(spec_.pole.place));
    ASSERT_TRUE(linkage);
    const Design design = assemble_given(spec_, *linkage, {.largest_sheets = false});
    ASSERT_EQ(test::first_limit_missed(spec_, design, 1e-8), "");  // its lengths are written in few digits
    size_ = design.quality.size;
  }

  Spec spec_;
  double size_ = 0;
};

TEST_P(KnownDesigns, AreNoBetterThanTheSearchAndNotBelowTheBound) {
  const auto bound = proven_bound(spec_);
  ASSERT_TRUE(bound);
  EXPECT_FALSE(bound->no_design);
  EXPECT_LE(bound->value, size_ * (1 + 1e-8));
  const SearchOutcome outcome = synthesize(spec_, {.diagnose = false});
  const auto* found = std::get_if<FoundDesign>(&outcome);
  ASSERT_TRUE(found);
  EXPECT_LE(found->value, size_ * 1.001);
  EXPECT_LE(found->proven_bound.value_or(0), size_ * (1 + 1e-8));
}

std::string test_name(const testing::TestParamInfo<path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, KnownDesigns, testing::ValuesIn(corpus_files()), test_name);

}  // namespace
}  // namespace kempe
