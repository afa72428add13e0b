// libFuzzer's entry: KEMPE_FUZZ_TARGET names the target that this program feeds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const kempe::fuzz::Target* const target = kempe::fuzz::find(KEMPE_FUZZ_TARGET);
  if (target == nullptr) std::abort();
  target->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
