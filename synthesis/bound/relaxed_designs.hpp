#pragma once
// Designs of the relaxation that the bound's tree meets: the best of them is what a box must be able to beat.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "synthesis/bound/load_floor.hpp"
#include "synthesis/bound/pole_places.hpp"
#include "synthesis/bound/proven_bound.hpp"

namespace kempe::bounding {

/// The best design known, and the way to better ones. What the arguments refer to must outlive it.
class RelaxedDesigns {
 public:
  /// `trials`: null if designs of the relaxation are as good as any.
  RelaxedDesigns(const Spec& spec, bool by_size, const BoundOptions& options, const Trials* trials,
                 const PolePlaces& places);

  /// Value of the best design met, or the incumbent, as TreeNode::bound: size, or minus the transmission angle; infinity if
  /// there is none.
  double best() const { return best_; }
  /// Bounds at least this good end the search.
  double enough(double tolerance) const {
    if (!(best_ < infinity)) return infinity;
    const double of_gap = incumbent_ < infinity ? options_.share_of_gap * (incumbent_ - best_) : 0;
    return best_ - std::max(tolerance * std::abs(best_), of_gap);
  }
  /// The transmission angle that designs of interest have at least, rad.
  double transmission() const {
    return by_size_ ? spec_.limits.transmission : std::max(spec_.limits.transmission, -best_);
  }
  const std::optional<RelaxedDesign>& design() const { return design_; }
  /// True once all trials are used up and none led to a design: they fail by what the search asks for beside the relaxation's limits, so
  /// more boxes are of no use.
  bool in_vain() const { return trials_are_used_up() && !(best_ < infinity); }

  /// Tries designs of the box: its smallest by reach, and its middle. `obstacles`, `loads`: null if there are none to be
  /// seen.
  void try_in(const TreeNode& node, const Branch& branch, ObstacleTest* obstacles, const LoadFloor* loads);

  /// Tries a design of the box out in the first layers that the box has left, whatever limits it breaks.
  void leap_to(const TreeNode& node, const Branch& branch, RelaxedDesign design, ObstacleTest* obstacles);
  /// The same where the value of a design next to it is all that is wanted (Trials::without_load_limit).
  void learn_of(const TreeNode& node, const Branch& branch, RelaxedDesign design,
                const ValueNear& value_near);

 private:
  struct Candidate;
  struct Box;
  void try_freest(Box& box, const PoleDistances& exact, LengthBox line);
  void try_design(Box& box, double t, double w);
  void look_at_best(Box& box);
  void look_at(const Box& box, const Candidate& candidate);
  void try_out(ObstacleTest* obstacles, std::size_t branch, std::size_t layers, const RelaxedDesign& design);
  bool was_in_vain(std::size_t branch, const CopyingLinkage& linkage) const;
  bool trials_are_used_up() const { return trials_ != nullptr && tried_out_ >= trials_->most; }

  const Spec& spec_;
  const BoundOptions& options_;
  const Trials* trials_;
  const PolePlaces& places_;
  bool by_size_;
  double incumbent_ = infinity, best_ = infinity;  ///< as TreeNode::bound
  std::optional<RelaxedDesign> design_;
  int tried_out_ = 0;
  std::set<std::size_t> soft_tried_out_;                       // branches
  std::map<std::size_t, std::vector<RelaxedDesign>> in_vain_;  // of each branch: tried out, and to no avail
};

}  // namespace kempe::bounding
