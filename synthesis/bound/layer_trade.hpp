#pragma once
// Which layer assignments of a box hold no design that is better than the best known and keeps the limit on the load error: load_trade.hpp with
// what the linkage in the middle of the box touches in them.

#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/obstacles.hpp"
#include "synthesis/bound/tree_node.hpp"

namespace kempe::bounding {

/// Of one box. What the references and pointers are to must outlive it.
struct LayerTrade {
  const Spec& spec;
  const Branch& branch;
  const ObstacleTest* obstacles;  ///< null where there are none to be seen
  DesignBox box;
  DistanceRange distances;  ///< of the region from the pole in the middle
  double transmission;      ///< rad: of better designs
  const BoxTrade& trade;

  /// Adds to `worse` assignments without a better design, up to the first that may have one: one is enough to keep the box. What is hit all over
  /// the box on the way is no longer alive. False if none is left.
  bool leaves_one(TreeNode& node) const;

 private:
  bool is_worse_by_obstacle(TreeNode& node, std::size_t layers) const;
  bool is_worse_by_contact(TreeNode& node, std::size_t layers) const;
  std::optional<ContactTouch> contact_of(const TreeNode& node, const ContactPair& pair, double psi,
                                         const Range& passed) const;
};

}  // namespace kempe::bounding
