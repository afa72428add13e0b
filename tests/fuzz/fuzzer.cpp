// libFuzzer's entry: the environment's KEMPE_FUZZ_TARGET names the target that this run feeds.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.hpp"

namespace {

const kempe::fuzz::Target* chosen() {
  const char* name = std::getenv("KEMPE_FUZZ_TARGET");
  const kempe::fuzz::Target* target = kempe::fuzz::find(name == nullptr ? "" : name);
  if (target != nullptr) return target;
  std::fprintf(stderr, "KEMPE_FUZZ_TARGET must be one of:");
  for (const kempe::fuzz::Target& one : kempe::fuzz::targets())
    std::fprintf(stderr, " %.*s", static_cast<int>(one.name.size()), one.name.data());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const kempe::fuzz::Target* const target = chosen();
  target->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
