#pragma once
// Which layer assignments of a box hold no design that is better than the best known and keeps the limit on the load error: load_trade.hpp with
// what the linkage in the middle of the box touches in them.

#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/obstacles.hpp"
#include "synthesis/bound/tree_node.hpp"

namespace kempe::bounding {

/// A box, and what is asked of its designs.
struct LayerQuestion {
  const Spec& spec;
  const Branch& branch;
  const ObstacleTest* obstacles;  ///< null where there are none to be seen
  DesignBox box;
  DistanceRange distances;  ///< of the region from the pole in the middle
  double transmission;      ///< rad: of better designs
  const BoxTrade& trade;
};

/// Adds to the node's `worse` assignments without a better design, up to the first that may have one: one is enough to keep the box. False if none of
/// those alive is left.
bool leaves_a_layer(const LayerQuestion& asked, TreeNode& node);

}  // namespace kempe::bounding
