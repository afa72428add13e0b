#pragma once
// The nodes of a proof's tree, and what all of one root's nodes share.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "synthesis/bound/branch.hpp"
#include "synthesis/certificate/design_cell.hpp"
#include "synthesis/certificate/part_points.hpp"
#include "synthesis/certificate/proof_log.hpp"
#include "synthesis/certificate/region_places.hpp"
#include "synthesis/certificate/requirement_sum.hpp"
#include "synthesis/certificate/slack.hpp"

namespace kempe::certificate {

/// A set of layer assignments by their numbers, rising.
using Assignments = std::vector<std::uint32_t>;

/// A point of the linkage in an obstacle: tried first in the cells within one where it was found.
struct ObstacleGuess {
  ObstacleLeaf leaf;
  Point place = Point::Zero();  ///< of the tracer, mm
};

/// A part beside an obstacle with the tracer at a place, by their numbers.
struct PartBeside {
  std::uint32_t place = 0, obstacle = 0;
  PartName part{};
};

/// What came near an obstacle in a cell: nothing else does in the cells within it, as far as doubles tell.
struct NearParts {
  std::vector<PartBeside> all;  ///< place by place
  std::size_t places = 0;       ///< how many places were looked at
};

/// Designs that are still to be refuted.
struct Node {
  DesignCell cell;
  Assignments assignments;
  std::optional<ObstacleGuess> guess{};
  std::shared_ptr<const NearParts> near{};  ///< absent: all parts, at all places
};

/// A line and what is left to refute after it.
struct Step {
  Line line;
  std::vector<Node> children;
};

/// What all nodes of one grounding and assembly mode share.
struct RootTask {
  const Spec& spec;
  const RegionPlaces& places;
  bounding::Branch branch;
  Root root{};
  SumTask sums{};
  std::vector<LayerAssignment> layers{};  ///< all, by their numbers
  std::vector<FilledLayers> filled{};     ///< the same
};

/// The step that parts the assignments of `node`: first those in which two parts, or a part and an obstacle, share a layer.
/// `guess`: for these.
inline Step share_step(const Node& node, const Share& line, const Assignments& sharing,
                       const std::optional<ObstacleGuess>& guess) {
  Node first{node.cell, sharing, guess, node.near}, second{node.cell, {}, std::nullopt, node.near};
  std::set_difference(node.assignments.begin(), node.assignments.end(), sharing.begin(), sharing.end(),
                      std::back_inserter(second.assignments));
  return {line, {std::move(first), std::move(second)}};
}

/// True if the lengths vary so little that points of obstacles or of contact are worth looking for.
inline bool small_enough(const DesignCell& cell) {
  constexpr double share = 0.3;
  return cell.half(Variable::a) < share * cell.middle(Variable::a) &&
         cell.half(Variable::b) < share * cell.middle(Variable::b);
}

}  // namespace kempe::certificate
