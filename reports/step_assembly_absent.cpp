// The build without OpenCASCADE.

#include "reports/step_assembly.hpp"

namespace kempe {

bool can_write_step() { return false; }

tl::expected<std::string, std::string> step_assembly(const Design&, const CuttingSpec&) {
  return tl::unexpected(std::string("this build writes no STEP: it was configured without OpenCASCADE"));
}

}  // namespace kempe
