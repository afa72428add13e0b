#pragma once
// One grounding and assembly mode of a proof: which line refutes a node of its tree, or parts it.

#include <optional>

#include "synthesis/certificate/contact_cut.hpp"
#include "synthesis/certificate/obstacle_leaf.hpp"

namespace kempe::certificate {

/// Which variable of a cell is cut first.
enum class CutOrder {
  by_sum,      ///< the one that adds most to what the sum of requirements lacks
  poles_first  ///< where the gap between original and copy decides, the pole's
};

/// A node is refuted by a sum of requirements, by the pole's place or the gap between original and copy if that is possible; else an
/// obstacle or a contact of the linkage with itself is sought that rules out part of it; else one variable is cut.
class RootProof {
 public:
  RootProof(const Spec& spec, const RegionPlaces& places, Grounding grounding, const AssemblyMode& mode,
            const std::optional<double>& size_bound, double transmission, CutOrder order);
  RootProof(const RootProof&) = delete;  // its members keep references to the task
  RootProof& operator=(const RootProof&) = delete;

  Node whole() const { return whole_; }
  bool bounds_size() const { return task_.sums.size_bound.has_value(); }
  void bound_size(const std::optional<double>& bound) { task_.sums.size_bound = bound; }
  bool refuted_by_sum(const DesignCell& cell) const { return best_sum(task_.sums, cell).refutes; }

  /// Nothing if the cell is too narrow to cut.
  std::optional<Step> step(Node& node) const;
  /// Where the middle design of a node meets an obstacle.
  std::optional<KnownPlace> place_met(const Node& node) const { return obstacles_.place_met(node); }

 private:
  void put_whole(double transmission);
  bool has_all_lengths(const DesignCell& cell) const;
  std::optional<Step> copy_error_step(const Node& node) const;
  bool outside_pole(const DesignCell& cell) const;
  std::optional<CopyGapLeaf> copy_too_near(const DesignCell& cell) const;
  bool half_too_near(DesignCell cell) const;
  std::optional<Variable> variable_to_cut(const DesignCell& cell, const BestSum& sum) const;
  std::optional<Step> split(const Node& node, const BestSum& sum) const;
  std::optional<Step> cut_poles(const Node& node, const ObstacleGuess& guess) const;

  RootTask task_;
  bounding::Range kept_;  ///< |psi| that the limit on the copy error leaves, rad
  ObstacleLeaves obstacles_;
  ContactCuts contact_;
  Node whole_;
  CutOrder order_;
};

}  // namespace kempe::certificate
