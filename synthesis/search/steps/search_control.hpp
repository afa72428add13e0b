#pragma once
// How a search runs: its random numbers, threads and budgets, and when it must end.

#include "kinematics/deadline.hpp"
#include "synthesis/search/steps/search_options.hpp"

namespace kempe {

/// A value: copies share the clock of the one they were copied from.
class SearchControl {
 public:
  /// The time limit begins now.
  explicit SearchControl(SearchOptions options);

  const SearchOptions& options() const { return options_; }
  const SearchBudgets& budgets() const { return options_.budgets; }
  /// Set by request or at the end of the time limit.
  const StopFlag& stop() const { return stop_; }
  bool has_time_limit() const { return deadline_.is_limited(); }
  /// Set by request or when that share of the time limit is over.
  StopFlag after_share(double share) const;

  /// Of a search that is part of this one: it stops with this one and has no limit of its own.
  SearchControl part() const;
  SearchControl part_with_seed(std::uint64_t seed) const;
  SearchControl silent_part() const;
  /// Of the same search, whose progress nobody is told.
  SearchControl silent() const;
  /// Of a part that has a share of the time left.
  SearchControl part_of_time(double share) const;

  void report(double share, std::string_view what) const;
  /// The same for a step that tells its share alone; none if nobody listens. `what` is a literal.
  std::function<void(double share)> progress_of(std::string_view what) const;

 private:
  Deadline deadline_;
  SearchOptions options_;
  StopFlag stop_;
};

}  // namespace kempe
