#pragma once
// The search over all discrete choices, for any limits and any goal: what synthesize(), the diagnosis of specs without a
// design and the trade-offs share.
//
//   1. the proven bound's tree (bound/proven_bound.hpp): it proves that there is no design, or gives one to start from
//   2. every grounding and assembly mode without contact: the relaxed problem, a bound for all its layer assignments
//   3. the choices in the order of their relaxed cost, in groups of fixed size; a group is searched in parallel
//   4. a choice whose relaxed cost is no better than the best found before its group is left out
//   5. what would become the best is certified first: the second solver, all requirements anew, obstacles over the whole
//      region (a place where it fails is added to the problem, which is solved again)
//   6. the best by (feasible, cost, index)
//
// Obstacles that no permitted instrument can touch (obstacle_reach.hpp) are left out throughout. Under a time limit all this
// comes after a first look: a share of the limit goes to a proof as far as it comes and to a first design, which are kept
// for the case that the time runs out. Where it does not, the outcome is that without a limit.
//
// Groups have the same size whatever the number of threads, so what is left out does not depend on it.

#include <chrono>
#include <memory>
#include <optional>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/problem/choices.hpp"
#include "synthesis/search/choice_search.hpp"
#include "synthesis/search/design_check.hpp"
#include "synthesis/search/search.hpp"

namespace kempe {

struct SearchResult {
  std::optional<FoundDesign> design{};
  bool stopped = false;      ///< by time or by request
  bool proven_none = false;  ///< interval arithmetic proves that no design keeps the limits
  std::optional<double>
      bound{};  ///< that no design with the exact ratio beats, of the goal; where one was proven
  std::uint64_t evaluations = 0;
};

/// True if a has the better value of the goal; both have been found for it.
bool is_better(Goal goal, const FoundDesign& a, const FoundDesign& b);
/// The one of two bounds that says more; `one` may be absent.
double tighter_bound(Goal goal, const std::optional<double>& one, double other);

/// A choice on its way through the search.
struct SearchTask {
  std::unique_ptr<DesignProblem> problem;
  const ContactChoice* choice = nullptr;
  OpeningInterval allowed{};   ///< openings at which transmission and copy error keep their limits
  std::vector<Point> poles{};  ///< promising without contact
  std::vector<DesignPoint>
      known{};  ///< designs of the bound's tree, and places where it could not rule one out
  ChoiceResult relaxed = no_result();
  ChoiceResult result = no_result();
};

class SearchRun {
 public:
  /// The spec, and what the options refer to, must outlive the run.
  SearchRun(const Spec& spec, SearchOptions options);
  SearchRun(const SearchRun&) = delete;
  SearchRun& operator=(const SearchRun&) = delete;

  const Spec& spec() const { return spec_; }
  /// Of the spec with the obstacles in reach alone.
  const SearchSpace& space() const { return space_; }
  const SearchOptions& options() const { return options_; }
  const StopFlag& stop() const { return stop_; }
  bool has_time_limit() const;
  /// For a search that is part of this one and stops with it; this must outlive it.
  SearchOptions options_of_part() const;

  /// The design with the best goal that keeps the limits, the workshop's numbers included. Limits that let instruments reach
  /// farther than the spec's may be given too.
  SearchResult best(const Requirements& limits, Goal goal) const;

  /// The better of a design and what a local search from `start` makes of it.
  SearchResult best_from(const RelaxedDesign& start, const Requirements& limits, Goal goal,
                         SearchResult found) const;

  /// The better of a design and what local searches from random places around it find, ever nearer ones.
  SearchResult basin_hopping(const Requirements& limits, Goal goal, SearchResult found) const;

  /// The steps of it, for searches of other kinds.
  std::vector<SearchTask> tasks_for(const Requirements& limits, Goal goal) const;
  void relax(std::vector<SearchTask>& tasks, const Requirements& limits, Goal goal) const;
  /// Certifies a task's result: true if it holds. May improve it, or make it worse or infeasible.
  bool certify(SearchTask& task, const Requirements& limits) const;
  std::optional<FoundDesign> design_of(const SearchTask& task, const Requirements& limits, Goal goal) const;

 private:
  std::vector<SearchTask> tasks_for(const Requirements& limits, Goal goal, bool mirror_images) const;
  SearchRun(const Spec& spec, SearchOptions options, const Requirements& widest);

  /// True for limits under which an instrument may touch more obstacles than were looked for.
  bool reaches_farther(const Requirements& limits) const;
  StopFlag after_share(double share) const;
  SearchOptions part_of_time(double share) const;
  std::optional<ProvenBound> proven_bound(const Requirements& limits, Goal goal, const StopFlag& stop) const;
  std::vector<SearchTask> relaxed_tasks(const Requirements& limits, Goal goal,
                                        const std::vector<RelaxedDesign>& known) const;
  /// What is found before the search itself, where it may run out of time.
  struct FirstLook {
    std::optional<ProvenBound> proof{};
    bool proof_is_whole = false;
    std::optional<FoundDesign> design{};
  };
  FirstLook first_look(const Requirements& limits, Goal goal) const;
  std::optional<FoundDesign> first_design(const Requirements& limits, Goal goal,
                                          const std::vector<RelaxedDesign>& known) const;
  bool demand_more(SearchTask& task, const DesignCheck& check, const Requirements& limits) const;
  SearchResult best_footprint(const Requirements& limits, const std::vector<RelaxedDesign>& known) const;
  SearchResult best_of_any_lengths(const Requirements& limits, Goal goal,
                                   const std::vector<RelaxedDesign>& known) const;
  void search_group(std::vector<SearchTask>& tasks, std::size_t first, std::size_t count,
                    const ChoiceResult& best) const;
  ChoiceOptions options_for(bool relaxed) const;
  void report(double share, std::string_view what) const;

  std::chrono::steady_clock::time_point start_;
  SearchOptions options_;
  StopFlag stop_;
  const Spec& spec_;
  Requirements widest_;  ///< limits for which the obstacles were looked for
  SearchSpace space_;
  std::vector<ContactChoice> choices_;
};

}  // namespace kempe
