#pragma once
// The questions of a diagnosis: what of a spec, changed alone, makes a design possible. Each kind has a file of its own.

#include <functional>
#include <string>
#include <vector>

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// What the questions share, and what they have come to.
class Questions {
 public:
  /// `thorough`: searches that find nothing are repeated from other random numbers. Of the progress of the searches asked for, only
  /// what they have spent of the budget is told.
  Questions(const SearchTask& task, const Point& origin, bool thorough);

  const SearchTask& task() const { return task_; }
  const Spec& spec() const { return task_.spec(); }
  const Requirements& limits() const { return task_.limits; }
  const DiagnosisBudget& budget() const { return task_.budgets().diagnosis; }
  /// Of the lengths that sentences state.
  SpecUnit unit() const { return task_.control.options().unit; }
  /// Of the task's coordinates on the table, mm.
  const Point& origin() const { return origin_; }
  /// True once no other search is to begin: the task is stopped, the budget of this round is spent, or there is nothing to
  /// diagnose.
  bool stopped() const { return task_.stopped() || spent_ >= budget().evaluations || permitted_; }
  /// Of the budget, so far.
  std::uint64_t spent() const { return spent_; }
  /// True once the search for the least change of one limit, begun when so much was spent, has had its share.
  bool has_had_its_share(std::uint64_t began) const;

  /// The best design for other limits or another goal.
  SearchResult best(const SearchTask& asked);
  /// The best design for another spec.
  std::optional<FoundDesign> best_of(const Spec& other);
  /// Counts the work of a search, by what an evaluation of its task costs.
  void count(const SearchTask& asked, std::uint64_t evaluations);
  /// Adds the evaluations of the round before, which this one's budget does not pay for.
  void add_earlier(std::uint64_t evaluations) { evaluations_ += evaluations; }

  /// A key that is about to be changed alone.
  void note(const std::string& key);
  /// The sentence of a change that need not be the least says so from here on.
  void keep(std::optional<Relaxation> found);
  /// True if the design keeps every limit of the task, which is looked at anew. It is kept then: the task's own search had
  /// missed it.
  bool permits(const FoundDesign& design);
  const std::optional<FoundDesign>& permitted() const { return permitted_; }
  /// What was changed by that key already, with a design.
  bool has(const std::string& key) const;

  const std::vector<std::string>& noted() const { return noted_; }
  const std::vector<Relaxation>& found() const { return found_; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  SearchTask task_;
  std::function<void(double share)> progress_;
  Point origin_;
  bool thorough_;
  std::vector<std::string> noted_;
  std::vector<Relaxation> found_;
  std::optional<FoundDesign> permitted_;
  std::uint64_t evaluations_ = 0, spent_ = 0;
};

/// Limits with a value: the least change of it; those that can be left out: without it, where no value does.
void relax_limits(Questions& questions);
void relax_copy_gap(Questions& questions);
void relax_sag(Questions& questions);
/// Where a limit on load error or sag was found to be in the way: wider or thicker links, a stiffer material.
void relax_stiffness(Questions& questions);
/// Where a limit on the sag was: tracer or pen resting on the table, pins held over a longer grip, less play.
void relax_support(Questions& questions);
/// The joints of a link nearer to each other: by shortest_mm, or by wall or pin.
void relax_joints(Questions& questions);
/// Obstacles away, one by one or all.
void relax_obstacles(Questions& questions);
/// Bodies, all together, and the table's edge.
void relax_bodies(Questions& questions);
/// The pole wherever a link can reach the region from.
void relax_pole(Questions& questions);
/// What the stock lengths and the objective ask left out: grid, stock, locked lengths, groundings; more layers.
void relax_stock_lengths(Questions& questions);
/// Thinner pins, narrower links.
void relax_parts(Questions& questions);

/// The thickest hardware of the spec's kind with which there is a design.
std::optional<Relaxation> smaller_hardware(Questions& questions);

/// The thickest pin (or width) with which there is a design, and that design; nothing if none was found. By halving: thinner
/// parts never forbid what thicker ones allow, unless a limit on load error or sag asks for stiff ones. Under such a limit
/// some values are tried where the thinnest part is of no avail, and the value need not be the thickest.
struct Thinned {
  double value;  ///< mm
  FoundDesign design;
  bool is_least;  ///< as in Relaxation
};
std::optional<Thinned> thinned(Questions& questions, double LinkStyle::*part, double least);

}  // namespace kempe
