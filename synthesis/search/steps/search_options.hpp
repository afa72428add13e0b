#pragma once
// What a caller may choose about a search.

#include <cstdint>
#include <functional>
#include <string_view>

#include "kinematics/deadline.hpp"
#include "specs/spec_keys.hpp"
#include "synthesis/search/steps/budgets.hpp"

namespace kempe {

struct SearchOptions {
  std::uint64_t seed = 1;
  int threads = 1;  ///< >= 1; the result does not depend on it
  /// s of wall clock, >= 0; at its end the best so far comes back
  double time_limit = Deadline::unlimited;
  StopFlag stop{};  ///< set: the same at once
  /// Share of the work done, 0..1, and what is being done; called from one thread at a time.
  std::function<void(double share, std::string_view what)> progress{};
  /// Of the spec's file: in it, and by its keys, sentences on what is in the way state lengths. Figures and Relaxation::key do not
  /// depend on it.
  SpecUnit unit = SpecUnit::mm;
  bool diagnose = true;  ///< look for the least relaxations where there is no design
  /// False: the gap to obstacles of a design that keeps its clearance limit is told as that limit, unless it is the objective.
  bool measure_gaps = true;
  SearchBudgets budgets{};
};

}  // namespace kempe
