#pragma once
// A spec posed as problems: every grounding, assembly mode and layer assignment, with its requirements.

#include <memory>
#include <vector>

#include "synthesis/problem/choices.hpp"
#include "synthesis/problem/design_problem.hpp"

namespace kempe {

/// One discrete choice, with one interval of openings at which transmission and copy error keep their limits. What its
/// finished designs miss is added to the problem (certify.hpp), so that later solutions keep it.
struct Subproblem {
  const ContactChoice* choice;
  OpeningInterval allowed;
  std::unique_ptr<DesignProblem> problem;
};

/// True if two subproblems differ in their layers alone.
bool are_alike(const Subproblem& a, const Subproblem& b);

/// Immutable, and safe to share between threads. Obstacles that no permitted instrument can touch (obstacle_reach.hpp) are
/// left out.
class SearchProblem {
 public:
  /// The spec must outlive the problem, and the problem its subproblems. `widest`: limits for which obstacles are looked for.
  SearchProblem(const Spec& spec, const Requirements& widest);
  explicit SearchProblem(const Spec& spec);
  SearchProblem(const SearchProblem&) = delete;
  SearchProblem& operator=(const SearchProblem&) = delete;

  const Spec& spec() const { return spec_; }
  /// Of the spec with the obstacles in reach alone.
  const SearchSpace& space() const { return space_; }
  std::size_t obstacles_out_of_reach() const;
  /// False for limits under which an instrument may touch more obstacles than were looked for.
  bool covers(const Requirements& limits) const;

  /// Those that the limits leave possible. Mirror images differ in their footprint alone: they are left out where it counts
  /// neither as goal nor as limit.
  std::vector<Subproblem> subproblems(const Requirements& limits, Goal goal) const;
  std::vector<Subproblem> subproblems_with_mirror_images(const Requirements& limits, Goal goal) const;

 private:
  std::vector<Subproblem> subproblems(const Requirements& limits, Goal goal, bool mirror_images) const;

  const Spec& spec_;
  Requirements widest_;
  SearchSpace space_;
  std::vector<ContactChoice> choices_;
};

}  // namespace kempe
