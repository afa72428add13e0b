#pragma once
// How to work: for how long, on how many threads, how finely. Of these the seed, the time limit and a stop can change which
// design comes back; the others cannot.

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace kempe {

/// How to work, for design() and map().
struct Options {
  std::uint64_t seed = 1;  ///< same spec and seed, same design, bit for bit
  int threads = 1;         ///< 0 and less count as 1; the design does not depend on it
  /// s of wall clock; at its end the best so far comes back, at once if it is 0 or less; absent: no limit
  std::optional<double> time_limit{};
  /// Asked often, perhaps from several threads; once true it must stay true. The best so far then comes back.
  std::function<bool()> stop{};
  /// Called with what is being done ("searching", "proving a bound", "mapping", ...) and the share of that which is done, 0..1; each
  /// begins anew. Called from one thread at a time.
  std::function<void(double share, std::string_view what)> progress{};
  bool diagnose = true;  ///< look for the least relaxations where there is no design
  /// Share of the free workspace that may stay uncertain, not NaN; 1e-5 or 0.5 where it is less or more
  double map_tolerance = 0.005;
  /// Look for the largest rectangles that fit the workspace: the slowest part of a map
  bool largest_sheets = true;
};

}  // namespace kempe
