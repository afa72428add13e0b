// The build without OpenCASCADE says so and leaves the file out.
#include <gtest/gtest.h>

#include "reports/part_files.hpp"
#include "reports/step_assembly.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

TEST(StepAssembly, IsLeftOutWhereTheBuildCannotWriteIt) {
  EXPECT_FALSE(can_write_step());
  EXPECT_FALSE(step_assembly(testing::plagiograph(), {}));
  for (const OutputFile& file : part_files(testing::plagiograph(), {}).files)
    EXPECT_NE(file.name.extension(), ".step");
}

}  // namespace
}  // namespace kempe
