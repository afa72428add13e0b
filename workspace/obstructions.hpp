#pragma once
// What moving parts must keep clear of, each at rest in a frame of its own.
//
// A body that tracer or pen carries keeps its direction, so that in the frame that travels with its point it is at rest, as an
// obstacle is in the table's. A body P meets an obstruction Q as its point meets the Minkowski difference Q - P: two polygons come within
// a distance of each other exactly where that point comes as near to it. The difference is taken convex part by convex part; its
// parts overlap.
//
// A body that turns with a link is at rest in that link's frame, and parts meet it there. What it meets itself in other frames it
// meets as a part of the linkage does: it is cut into triangles, each corner a point of the link's plate, p and q having multiples for it
// as they have for joints (linkage_motion.hpp). It is fixed to its link, which has the body's point: nothing is asked of it and the
// links that have that point, nor of it and the pins on its own link, which do not move against it.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/regions/convex_parts.hpp"
#include "specs/spec.hpp"
#include "specs/spec_keys.hpp"
#include "workspace/linkage_motion.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Something at rest in the table's frame, or in one that travels with tracer or pen, turning with a link or not.
struct Obstruction {
  std::optional<Carrier> frame{};    ///< whose point is the frame's origin; absent: the table's frame
  std::optional<Link> turns_with{};  ///< the link with which the frame turns; absent: it keeps its direction
  Region shape{};                    ///< mm; polygons may overlap, run one way, and have a single corner
  double grown = 0;                  ///< mm: the obstruction is the shape grown by this
  int lowest_layer = 1, highest_layer = most_layers;
  std::string name{};  ///< "vice", "router", "the table's edge"
  /// Of a Minkowski difference the body that was taken away: this point alone meets the obstruction. Absent: parts of the linkage do.
  struct Met {
    Carrier by;
    std::string name;
  };
  std::optional<Met> met{};
  /// Bodies that turn with a link and must keep clear of this, by their place in the list of bodies.
  std::vector<std::size_t> turning{};
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

/// The same without bodies that turn with a link.
std::vector<Body> that_keep_direction(const std::vector<Body>& bodies);

/// What a body covers: a disc's centre, or a polygon cut into triangles, as the body is stated; and what is grown about them, mm.
struct BodyPieces {
  std::vector<ConvexPart> pieces;  ///< of one or three corners each
  double grown = 0;
};
BodyPieces pieces_of(const Body& body);

/// A corner (mm) of a body that turns with `link`, as a point of that link's plate.
LinkagePoint point_on_link(Complex corner, Link link, const CopyingLinkage& linkage);

/// The body where it stands in a pose.
std::variant<Disc, Polygon> placed(const Body& body, const CopyingLinkage& linkage, const Pose& pose);

/// The direction of the body's x axis in a pose, rad; 0 for one that keeps its direction.
double bearing_of(const Body& body, const CopyingLinkage& linkage, const Pose& pose);

/// "router", or "body 2": numbered from 1 in the order of the list.
std::string body_name(const std::vector<Body>& bodies, std::size_t index);

/// The joint that carries.
Joint joint_of(Carrier carrier, const CopyingLinkage& linkage);

/// True if the linkage's part must keep clear of the obstruction: they share a layer, and the part does not hold the joint that carries
/// the obstruction, nor is a pin of the link with which it turns. False for an obstruction that only a body meets.
bool may_meet(const Part& part, const Obstruction& obstruction, const CopyingLinkage& linkage);

}  // namespace kempe
