#pragma once
// Bounds of the distance between a moving hull of joints and an edge at rest, over a rectangle of openings
// and bearings.
//
// Let n point from the edge's nearest point to the hull's in the middle of the rectangle. A line at right
// angles to n separates the two as far as n.z - n.y says for all corners z of the hull and ends y of the
// edge, so
//     distance >= min over corners ( n.z - |n.dz/dd| D - |n.dz/dt| T - rest ) - max over ends ( n.y ),
// D and T being half the rectangle. The hull's nearest point itself moves by at most u along n and by at most
// v in all,
//     distance <= sqrt((distance in the middle + u)^2 + v^2).

#include <limits>

#include "workspace/edge_tree.hpp"
#include "workspace/linkage_motion.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Half the sides of a rectangle of openings and bearings, rad.
struct HalfSides {
  double opening, bearing;
};

struct GapBounds {
  double lower, upper;            ///< mm, of the distance of hull and edge all over the rectangle
  double middle;                  ///< mm, distance in the middle of the rectangle
  double by_opening, by_bearing;  ///< mm, what either half side contributes to the uncertainty
};

/// Bounds of the distance between the hull of moving joints and an edge. Whoever only asks whether the upper bound lies below
/// some distance (mm) names it: a looser one is returned where it cannot.
GapBounds bounds_to_edge(const MovingJoints& joints, const JointHull& hull, const EdgeTree::Edge& edge,
                         const HalfSides& half, double upper_below = std::numeric_limits<double>::infinity());

/// A lower bound of the distance between the hull in the middle of the rectangle and a box, mm.
double distance_from_box(const MovingJoints& joints, const JointHull& hull, const Box& box);

/// How far any point of the hull gets from its middle place, mm.
double reach_of(const MovingJoints& joints, const JointHull& hull);

}  // namespace kempe
