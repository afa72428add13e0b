#pragma once
// The search: from a spec to the best design that keeps every limit, or to the reason why there is none.

#include <functional>
#include <limits>
#include <string_view>

#include "kinematics/stop_flag.hpp"
#include "synthesis/search/budgets.hpp"
#include "synthesis/search/outcome.hpp"

namespace kempe {

struct SearchOptions {
  std::uint64_t seed = 1;
  int threads = 1;  ///< >= 1; the result does not depend on it
  /// s of wall clock, > 0; at its end the best so far comes back
  double time_limit = std::numeric_limits<double>::infinity();
  StopFlag stop{};  ///< set: the same at once
  /// Share of the work done, 0..1, and what is being done; called from one thread at a time.
  std::function<void(double share, std::string_view what)> progress{};
  bool diagnose = true;  ///< look for the least relaxations where there is no design
  SearchBudgets budgets{};
};

/// The best design for a spec. Guarantees:
///  1. a design returned keeps every limit of the spec, evaluated anew and its contact certified;
///  2. the same spec, seed and budgets give the same outcome, bit for bit, for any number of threads (unless stopped
///  early);
///  3. what comes back after a stop is marked as incomplete, and NoDesign comes back only where the whole search found
///  nothing, or a proof did. Under a time limit a first design is sought before the best one.
SearchOutcome synthesize(const Spec& spec, const SearchOptions& options);

}  // namespace kempe
