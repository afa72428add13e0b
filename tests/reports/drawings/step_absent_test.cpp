// Without the module the file is left out, and a sentence says what would bring it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/drawings/part_files.hpp"
#include "reports/drawings/step_assembly.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

TEST(StepAssembly, IsLeftOutWithoutItsModule) {
  const auto lack = why_no_step();
  ASSERT_TRUE(lack);
  EXPECT_THAT(*lack, ::testing::HasSubstr("no parts/assembly.step: "));
  EXPECT_THAT(*lack, ::testing::HasSubstr("scripts/bootstrap step"));
  EXPECT_EQ(step_assembly(testing::plagiograph(), {}).error(), *lack);
  for (const OutputFile& file : part_files(testing::plagiograph(), {}).files)
    EXPECT_NE(file.name.extension(), ".step");
}

}  // namespace
}  // namespace kempe
