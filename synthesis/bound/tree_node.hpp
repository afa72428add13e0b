#pragma once
// A node of the bound's tree: a box of designs of one branch.

#include <array>
#include <cstdint>

#include "synthesis/bound/branch.hpp"
#include "synthesis/bound/layer_set.hpp"
#include "synthesis/bound/obstacles.hpp"

namespace kempe::bounding {

/// Contacts that a node repeats from the one that it was split from.
inline constexpr std::size_t kept_cuts = 4;

struct TreeNode {
  double bound = 0;          ///< smaller is more promising: size, or minus the transmission angle
  double without_loads = 0;  ///< the bound of designs that need not keep the limit on the load error
  std::size_t number = 0;
  std::size_t branch = 0;
  Range x, y;                  ///< the pole's place, mm
  bool copy_is_apart = false;  ///< wherever the pole stands in the box
  PoleDistances distances;
  LengthBox lengths;
  LayerSet alive{};  ///< layer assignments not yet ruled out, by their place in the branch
  /// Those without a design that keeps the limit on the load error and is better than `worse_than` (as `bound`).
  LayerSet worse{};
  double worse_than = 0;
  Sight sight;  ///< of the obstacles
  /// Of the first layer assignments: number in MetContacts, 0 for none.
  std::array<std::uint32_t, kept_cuts> cut{};

  Point pole() const { return {0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper)}; }
  bool pole_is_known() const { return x.lower == x.upper && y.lower == y.upper; }
};

/// The less promising of two nodes; of two equal ones the later.
struct LessPromising {
  bool operator()(const TreeNode& one, const TreeNode& other) const {
    return one.bound != other.bound ? one.bound > other.bound : one.number > other.number;
  }
};

}  // namespace kempe::bounding
