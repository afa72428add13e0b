#include "geometry/invariant.hpp"

#include <cstdio>
#include <cstdlib>

namespace kempe {

void invariant(bool holds, std::string_view condition, const char* file, int line) {
  if (holds) return;
  std::fprintf(stderr, "%s:%d: this does not hold, which is a fault of the program: %.*s\n", file, line,
               static_cast<int>(condition.size()), condition.data());
  std::abort();
}

}  // namespace kempe
