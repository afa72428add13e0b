#pragma once
// What an assignment of the links to layers demands, and which assignments are worth a look.
//
// An assignment decides which parts meet in a layer, and which parts meet which obstacles; all else is the same in
// every layer. So one whose demands another's imply cannot be worse, wherever the linkage stands. Two demands of parts
// follow from those of links: a link's outline holds the discs of pins and posts at its joints (a pin is no wider than
// a link), so that what stays clear of the link stays clear of them.

#include <array>
#include <cstdint>
#include <vector>

#include "workspace/parts.hpp"

namespace kempe {

/// The layers of obstacles, each range once, without layers above `layers`: obstacles of one range demand alike.
struct ObstacleLayers {
  ObstacleLayers(const std::vector<Obstacle>& obstacles, int layers);
  struct LayerRange {
    int lowest, highest;
    bool operator==(const LayerRange&) const = default;
  };
  std::vector<LayerRange> ranges;  ///< at most 36, for there are at most most_layers layers
};

/// What must keep its clearance, as sets. A body is a link, or the pin or post at a joint (both have one diameter).
class LayerDemands {
 public:
  LayerDemands(const CopyingLinkage& linkage, const LayerAssignment& layers, const ObstacleLayers& obstacles);

  /// With all that follows from them.
  LayerDemands implied() const;
  /// True if each of these is one of the other's.
  bool within(const LayerDemands& other) const;
  bool operator==(const LayerDemands&) const = default;

 private:
  static constexpr std::size_t bodies = 10;  // four links, six joints
  LayerDemands() = default;
  std::array<std::uint16_t, bodies> pairs_{};      // of each body: bit j stands for body j
  std::array<std::uint64_t, bodies> obstacles_{};  // of each body: bit i stands for range i
};

/// Assignments of layer_assignments(layers) of which none implies the demands of another, in that order: if no design
/// keeps the demands of one of these, none does in any assignment.
std::vector<LayerAssignment> least_demanding_assignments(const CopyingLinkage& linkage, int layers,
                                                         const std::vector<Obstacle>& obstacles);

/// The same where of two linkages as good as each other the lower one is wanted: no assignment is left out for one that
/// is higher.
std::vector<LayerAssignment> assignments_worth_trying(const CopyingLinkage& linkage, int layers,
                                                      const std::vector<Obstacle>& obstacles);

}  // namespace kempe
