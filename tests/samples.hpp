#pragma once
// How many random cases a test tries. KEMPE_SAMPLES, a share of 1, lets slow builds (sanitisers) try fewer; ordinary
// builds try all.

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kempe::test {

/// The share of `all` cases that this run tries, at least one.
inline int samples(int all) {
  const char* share = std::getenv("KEMPE_SAMPLES");
  return share == nullptr ? all
                          : std::max(1, static_cast<int>(std::lround(all * std::strtod(share, nullptr))));
}

/// True in a run that tries fewer: what holds of all cases together is then not asked for.
inline bool shortened() { return std::getenv("KEMPE_SAMPLES") != nullptr; }

/// How often all cases together must show something; never (-1) in a shortened run.
inline int expected(int of_all) { return shortened() ? -1 : of_all; }

}  // namespace kempe::test
