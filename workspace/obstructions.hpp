#pragma once
// What moving parts must keep clear of, each at rest in a frame of its own.
//
// A body that tracer or pen carries keeps its direction, so that in the frame that travels with its point it is at rest, as an
// obstacle is in the table's. A body P meets an obstruction Q as its point meets the Minkowski difference Q - P: two polygons come within
// a distance of each other exactly where that point comes as near to it. The difference is taken convex part by convex part; its
// parts overlap.

#include <optional>
#include <string>
#include <vector>

#include "specs/spec.hpp"
#include "specs/spec_keys.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Something at rest in the table's frame, or in one that travels with tracer or pen without turning.
struct Obstruction {
  std::optional<Carrier> frame{};  ///< whose point is the frame's origin; absent: the table's frame
  Region shape{};                  ///< mm; polygons may overlap, run one way, and have a single corner
  double grown = 0;                ///< mm: the obstruction is the shape grown by this
  int lowest_layer = 1, highest_layer = most_layers;
  std::string name{};  ///< "vice", "router", "the table's edge"
  /// Of a Minkowski difference the body that was taken away: this point alone meets the obstruction. Absent: parts of the linkage do.
  struct Met {
    Carrier by;
    std::string name;
  };
  std::optional<Met> met{};
};

/// All obstructions of a task: first the obstacles, in their order, then the table's edge, the bodies, and the differences.
std::vector<Obstruction> obstructions_of(const std::vector<Obstacle>& obstacles,
                                         const std::vector<Body>& bodies,
                                         const std::optional<Polygon>& table);

/// What is not the table, near it: a frame around it, wider than the table and than the bodies reach. Whatever is linked to
/// something on the table and leaves it lies in part in this frame.
Polygon off_the_table(const Polygon& table, const std::vector<Body>& bodies);

/// How far a body reaches from the point that carries it, mm.
double farthest(const Body& body);

/// "router", or "body 2": numbered from 1 in the order of the list.
std::string body_name(const std::vector<Body>& bodies, std::size_t index);

/// The joint that carries.
Joint joint_of(Carrier carrier, const CopyingLinkage& linkage);

/// True if the linkage's part must keep clear of the obstruction: they share a layer, and the part does not hold the joint that carries
/// the obstruction. False for an obstruction that only a body meets.
bool may_meet(const Part& part, const Obstruction& obstruction, const CopyingLinkage& linkage);

}  // namespace kempe
