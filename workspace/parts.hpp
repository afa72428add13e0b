#pragma once
// The real parts of a copying linkage: four links in layers, pins at the joints, posts down to the table.

#include <array>
#include <string>
#include <vector>

#include "geometry/arc_polygon.hpp"
#include "kinematics/copying_linkage.hpp"
#include "kinematics/links.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// In which layer each link lies; 1 is next to the table.
struct LayerAssignment {
  std::array<int, 4> of{1, 2, 2, 1};
  int operator[](Link link) const { return of[static_cast<std::size_t>(link)]; }
  int highest() const;
  bool has_links_in(int layer) const;
  /// The link's layer counted among those that have links: 1 for the lowest.
  int rank(Link link) const;
  /// True if no layer below the highest one used is empty.
  bool is_stacked() const;
  bool operator==(const LayerAssignment&) const = default;
};

/// Every assignment to layers 1..layers (>= 2) in which links that share a joint lie in different layers: the stacked
/// ones first, in lexicographic order, then those with empty layers below or between the links, the lowest first.
/// Those that matter for a task: layer_demands.hpp.
std::vector<LayerAssignment> layer_assignments(int layers);

/// A part that can touch another: a link, a pin at A, B, C or V, or a post (pole, tracer, pen) at V, X or Y.
struct Part {
  enum class Kind { link, pin, pole_post, tracer_post, pen_post } kind = Kind::link;
  Link link{};                              ///< of a link
  Joint joint{};                            ///< of a pin or a post
  int lowest_layer = 1, highest_layer = 1;  ///< layers it occupies; a post of the lowest layer's link
                                            ///< occupies none above the table: highest_layer = 0
  bool is_post() const { return kind != Kind::link && kind != Kind::pin; }
  bool operator==(const Part&) const = default;
};
/// "link ACX", "pin C", "pole post V", "tracer X", "pen Y".
std::string name(const Part& part);

/// All parts of a linkage in the given layers: four links, the pins that pass a layer, the three posts. Not the spacers on
/// pins and posts: their width is the maker's choice, and the bill of materials says where it has a limit.
std::vector<Part> parts_of(const CopyingLinkage& linkage, const LayerAssignment& layers);

/// How far a part's outline lies from its axis, mm: half the link's width, half the pin's diameter.
double half_width(const Part& part, const LinkStyle& style);

/// The hull of one, two or three joints: a point, a segment or a triangle.
struct JointHull {
  std::array<Joint, 3> joints;
  int count;
};
/// The pieces of a part's axis; the part's outline is their union grown by half_width. A bent plate has two,
/// all other parts one. Straight plates are one segment between the outermost of their joints.
std::vector<JointHull> axis_of(const Part& part, Complex shape, PlateStyle plate);

/// The outline of a link in a pose, pin holes not cut out: its axis grown by half the width; arcs are true
/// arcs.
ArcPolygon link_outline(Link link, const Pose& pose, const LinkStyle& style);

}  // namespace kempe
