#pragma once
// Every choice without contact first: what it can be at best, an order for the search, and places to start from.

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// A subproblem with what is known of it before it is searched.
struct Prospect {
  Subproblem subproblem;
  ChoiceResult relaxed = no_result();  ///< without contact: no design of this choice is better
  std::vector<Point> poles{};          ///< promising without contact
  /// Designs of the bound's tree, and places where it could not rule one out.
  std::vector<DesignPoint> known{};
};

/// In the order of the subproblems; those that differ in their layers alone share their figures.
std::vector<Prospect> prospects_of(const SearchTask& task, std::vector<Subproblem> subproblems,
                                   const std::vector<RelaxedDesign>& known);

/// The best first.
void sort_by_promise(std::vector<Prospect>& prospects);

/// All choices of the task, in the order of what they can be at best.
std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known);

}  // namespace kempe
