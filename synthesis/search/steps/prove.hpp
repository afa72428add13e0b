#pragma once
// What is proven before the search begins, and under a time limit a first design.

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// The bound's tree for the task's limits: a proof that no design keeps them, or designs without contact to start from.
/// Nothing where the pole may leave its area, which the tree does not know.
std::optional<ProvenBound> prove(const SearchTask& task, const StopFlag& stop);

/// The task's spec as the tree is asked: with the task's limits, and the obstacles in reach alone.
Spec spec_for_tree(const SearchTask& task);

/// Whether a tree of so many boxes proves that no design keeps the limit on the load error beside the task's others.
bool none_keeps_loads(const SearchTask& task, std::size_t boxes);

/// The same of the task's spec with both lengths locked, without contact: these lengths are too soft wherever the pole stands.
bool is_too_soft_anywhere(const SearchTask& task, const Spec& locked);

/// What is found before the search itself, where it may run out of time.
struct FirstLook {
  std::optional<ProvenBound> proof{};
  bool proof_is_whole = false;  ///< else it is a bound as far as the time allowed
  std::optional<FoundDesign> design{};
};
/// Within its shares of the time limit, the proof as far as it comes and the first design that local searches lead to. Both
/// are kept for the case that the time runs out; if it does not, the outcome is that without a limit. Empty without one.
FirstLook first_look(const SearchTask& task);

/// Where a search may start; empty without a proof.
std::vector<RelaxedDesign> starts_of(const std::optional<ProvenBound>& proof);

}  // namespace kempe
