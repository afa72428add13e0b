#pragma once
// The search over all discrete choices, for any limits and any goal: what synthesize(), the diagnosis of
// specs without a design and the trade-offs share.
//
//   1. every grounding and assembly without contact: the relaxed problem, a bound for all its layer
//   assignments
//   2. the choices in the order of their relaxed cost, in groups of fixed size; a group is searched in
//   parallel
//   3. a choice whose relaxed cost is no better than the best found before its group is left out
//   4. the best by (feasible, cost, index) is finished and checked anew; if the check fails the next one is
//   taken
//
// Groups have the same size whatever the number of threads, so what is left out does not depend on it.

#include <chrono>
#include <optional>

#include "synthesis/choice_search.hpp"
#include "synthesis/choices.hpp"
#include "synthesis/search.hpp"

namespace kempe {

struct SearchResult {
  std::optional<FoundDesign> design;
  bool stopped = false;  ///< by time or by request
  std::uint64_t evaluations = 0;
};

class SearchRun {
 public:
  /// The options, and what they refer to, must outlive the run.
  SearchRun(const Spec& spec, const SearchOptions& options);

  const Spec& spec() const { return space_.spec(); }
  const SearchOptions& options() const { return options_; }
  bool stopped() const { return stop_(); }

  /// The design with the best goal that keeps the limits.
  SearchResult best(const Requirements& limits, Goal goal) const;

 private:
  struct Task;
  std::vector<Task> tasks_for(const Requirements& limits, Goal goal) const;
  void relax(std::vector<Task>& tasks, const Requirements& limits, Goal goal) const;
  std::optional<FoundDesign> finished(const Task& task, const Requirements& limits, Goal goal) const;
  ChoiceOptions options_for(bool relaxed) const;

  SearchSpace space_;
  const SearchOptions& options_;
  std::chrono::steady_clock::time_point start_;
  StopFlag stop_;
  std::vector<ContactChoice> choices_;
};

}  // namespace kempe
