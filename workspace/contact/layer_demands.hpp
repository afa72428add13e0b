#pragma once
// What an assignment of the links to layers demands, and which assignments are worth a look.
//
// An assignment decides which parts meet in a layer, and which parts meet which obstacles; all else but the sag is the
// same in every layer. So one whose demands another's imply cannot be worse, wherever the linkage stands. Some demands of
// parts follow from those of links: a link's outline holds the discs of pins and posts at its joints (a pin is no wider than
// a link), so that what stays clear of the link stays clear of them.

#include <array>
#include <bitset>
#include <vector>

#include "workspace/obstructions.hpp"

namespace kempe {

/// The layers of obstacles and of bodies, each range once, without layers above `layers`: obstacles of one range demand alike, and
/// so do bodies of one range and one carrier that turn with the same link, or with none. The table's edge demands the same in all layers.
struct ObstacleLayers {
  ObstacleLayers(const std::vector<Obstacle>& obstacles, const std::vector<Body>& bodies, int layers);
  struct LayerRange {
    int lowest, highest;
    std::optional<Carrier> carrier;
    std::optional<Link> turns_with;
    bool operator==(const LayerRange&) const = default;
  };
  /// Ranges of each of seven kinds: obstacles, bodies of the tracer and of the pen that keep their direction, and bodies that turn with one of
  /// the four links, which carries one of the two at most.
  static constexpr std::size_t most = 7 * (most_layers * (most_layers + 1)) / 2;
  std::vector<LayerRange> ranges;
};

/// A member is a link, or the pin or post at a joint (both have one diameter): four links, then six joints.
constexpr std::size_t layer_members = 10;
using LayerMembers = std::bitset<layer_members>;

/// What must keep its clearance, as sets.
class LayerDemands {
 public:
  LayerDemands(const CopyingLinkage& linkage, const LayerAssignment& layers, const ObstacleLayers& obstacles);

  /// With all that follows from them.
  LayerDemands implied() const;
  /// True if each of these is one of the other's.
  bool within(const LayerDemands& other) const;
  bool operator==(const LayerDemands&) const = default;

 private:
  LayerDemands() = default;
  std::array<LayerMembers, layer_members> pairs_{};  ///< of each
  std::array<std::bitset<ObstacleLayers::most>, layer_members>
      obstacles_{};  ///< of each: by the range's number
};

/// Assignments of layer_assignments(layers) of which none implies the demands of another, in that order: if no design
/// keeps the demands of one of these, none does in any assignment.
std::vector<LayerAssignment> least_demanding_assignments(const CopyingLinkage& linkage, int layers,
                                                         const std::vector<Obstacle>& obstacles,
                                                         const std::vector<Body>& bodies = {});

/// Whether the sag is limited. It depends on how long pins and posts are.
enum class SagCounts { no, yes };
inline SagCounts sag_counts(const Limits& limits) { return limits.sag ? SagCounts::yes : SagCounts::no; }

/// The same where of two linkages as good as each other the lower one is wanted: no assignment is left out for one that
/// is higher, and where the sag counts for none with a longer pin at A, B, C or V or a longer post at the pole. (Shorter ones bend less,
/// but the point that sinks most may sink a little more.)
std::vector<LayerAssignment> assignments_worth_trying(const CopyingLinkage& linkage, int layers,
                                                      const std::vector<Obstacle>& obstacles,
                                                      const std::vector<Body>& bodies = {},
                                                      SagCounts sag = SagCounts::no);

}  // namespace kempe
