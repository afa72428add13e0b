#pragma once
// One way to look for the best design over all choices. The driver (best_design.cpp) calls the steps in the order in which they
// stand here.

#include <memory>

#include "synthesis/search/steps/relax.hpp"
#include "synthesis/search/steps/search_result.hpp"

namespace kempe {

/// The best found so far.
struct Incumbent {
  ChoiceResult result = no_result();  ///< certified; what later groups are pruned by
  Subproblem* subproblem = nullptr;   ///< of the result
  std::optional<FoundDesign> design{};
  std::uint64_t evaluations = 0;
};

class Strategy {
 public:
  Strategy() = default;
  Strategy(const Strategy&) = delete;
  Strategy& operator=(const Strategy&) = delete;
  virtual ~Strategy() = default;

  /// The choices worth searching, the most promising first; their evaluations are added to `best`.
  virtual std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                                      Incumbent& best) const = 0;
  /// The best of one choice; not run where it cannot beat `best`. Called in parallel: writes nothing.
  virtual ChoiceResult search(const SearchTask& task, const Prospect& prospect,
                              const ChoiceResult& best) const = 0;
  /// Certifies what was found, and keeps it if it is the best.
  virtual void certify(const SearchTask& task, Prospect& prospect, const ChoiceResult& found,
                       Incumbent& best) const = 0;
  /// The last digits, and the finished design.
  virtual void finish(const SearchTask& task, Incumbent& best) const = 0;
};

/// The strategy for a goal: of lengths for every goal that a formula gives, of footprints for theirs.
std::unique_ptr<Strategy> strategy_for(Goal goal);

}  // namespace kempe
