#pragma once
// Contact of the linkage with itself over the boxes of the bound's tree: two points that come too near at an opening which every
// design of a box passes rule out the layer assignments in which their parts share a layer.

#include <vector>

#include "kinematics/stop_flag.hpp"
#include "synthesis/bound/tree_node.hpp"

namespace kempe::bounding {

/// The contacts that were met in a tree: a cheap first test for the boxes within those where they were met. The spec must
/// outlive it.
class MetContacts {
 public:
  MetContacts(const Spec& spec, StopFlag stop) : spec_(spec), stop_(std::move(stop)) {}

  /// Tests the contacts that the node was split from; false if no layer assignment is left.
  bool repeat(TreeNode& node, const Branch& branch) const;
  /// Drops layer assignments in which the linkage touches itself at an opening that every design of the box
  /// passes, up to the first in which that is not so: one is enough to keep the box. Remembers where that one touches itself, if it does.
  /// False if none is left. Counts its tests in `boxes`.
  bool rule_out(TreeNode& node, const Branch& branch, std::size_t& boxes);

  /// Two points of a linkage that came too near at an opening in some box.
  struct Cut {
    double psi = 0;
    MaterialPoint first, second;
    double needed = 0;
  };

 private:
  const Spec& spec_;
  StopFlag stop_;
  std::vector<Cut> cuts_{Cut{}};  // number 0 stands for none
};

}  // namespace kempe::bounding
