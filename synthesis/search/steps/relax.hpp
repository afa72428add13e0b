#pragma once
// Every choice without contact first: what it can be at best, an order for the search, and places to start from.
//
// A limit on the load error makes each local solution longer, and most of all where a choice cannot keep it. So at first it is left
// out too, and counts only for choices that might still be the best.

#include <span>

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
  bool lacks_load_limit = false;  ///< `relaxed` and `poles` leave the limit on the load error out
};

/// In the order of the subproblems; those that differ in their layers alone share their figures.
std::vector<Prospect> prospects_of(const SearchTask& task, std::vector<Subproblem> subproblems,
                                   const std::vector<RelaxedDesign>& known);

/// The best first.
void sort_by_promise(std::span<Prospect> prospects);
/// In the order of the subproblems of one problem.
void sort_by_choice(std::span<Prospect> prospects);

/// All choices of the task, in the order of what they can be at best.
std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known);

/// The same without the limit on the load error, if there is one.
std::vector<Prospect> relax_without_load(const SearchTask& task, const std::vector<RelaxedDesign>& known);

/// What is no cheaper without contact cannot be cheaper with it.
bool may_beat(const Prospect& prospect, const ChoiceResult& best);

/// Relaxes anew, with the limit on the load error, what comes first in the order without it, until what comes first has it or cannot
/// beat `best`. Returns the evaluations.
std::uint64_t relax_under_load(const SearchTask& task, std::span<Prospect> order, const ChoiceResult& best);

/// The same of all that still lack it.
void relax_rest_under_load(const SearchTask& task, std::vector<Prospect>& prospects);

}  // namespace kempe
