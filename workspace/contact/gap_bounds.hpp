#pragma once
// Bounds of the distance between a moving hull of joints and an edge at rest, over a rectangle of openings
// and bearings.
//
// Let n point from the edge's nearest point to the hull's in the middle of the rectangle. A line at right
// angles to n separates the two as far as n.z - n.y says for all corners z of the hull and ends y of the
// edge, so
//     distance >= min over corners ( n.z - |n.dz/dd| D - |n.dz/dt| T - rest ) - max over ends ( n.y ),
// D and T being half the rectangle. The hull's nearest point itself moves by at most u along n and by at most
// v across it,
//     distance <= sqrt((distance in the middle + u)^2 + v^2).
//
// A link that swings past something with its side comes no nearer where it is nearest, to first order, though its
// ends move along n. Then the line through that side, from corner a to b, separates better. With u its direction, l its length and n
// its normal in the middle, and p the foot of an end y of the edge on it, which moves by d while b moves by w more than a,
//     distance from y to the line >= ( l n.(p - y) + l n.d - |n.(p - y)| |u.w| - |w| |d| ) / sqrt((l + |u.w|)^2 + |w|^2):
// the cross product of line and p - y over the line's length. Of a rigid link u.w is of second order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/edge_tree.hpp"
#include "workspace/linkage_motion.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Half the sides of a rectangle of openings and bearings, rad.
struct HalfSides {
  double opening = 0, bearing = 0;
};

/// The hull of one, two or three joints or other points of the linkage, by their numbers in MovingJoints::of().
struct PointHull {
  std::array<std::uint32_t, 3> points{};
  int count = 0;
  PointHull() = default;
  PointHull(const JointHull& hull) : count(hull.count) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = static_cast<std::uint32_t>(hull.joints[i]);
  }
};

/// A hull of moving joints over a rectangle of openings and bearings.
class MovingHull {
 public:
  /// `joints` are those of the rectangle and must outlive the object.
  MovingHull(const MovingJoints& joints, const PointHull& hull, const HalfSides& half);

  std::size_t size() const { return size_; }  ///< number of corners: 1, 2 or 3
  const MovingJoint& operator[](std::size_t corner) const { return *corners_[corner]; }
  const HalfSides& half() const { return half_; }
  double reach() const { return reach_; }  ///< how far any of its points gets from its middle place, mm

 private:
  std::array<const MovingJoint*, 3> corners_;
  std::size_t size_;
  HalfSides half_;
  double reach_;
};

struct GapBounds {
  double lower, upper;            ///< mm, of the distance of hull and edge all over the rectangle
  double middle;                  ///< mm, distance in the middle of the rectangle
  double by_opening, by_bearing;  ///< mm, what either half side contributes to the uncertainty
};

/// Bounds of the distance between a hull and an edge.
GapBounds bounds_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge);

/// What is asked of bounds, mm: is the upper one below a distance, does the lower one reach another that is no
/// smaller?
struct GapQuestion {
  double upper_below, lower_from;
};

/// The same bounds, but only as close as the answers need. Where the distance in the middle and the reach
/// alone say yes, by_opening and by_bearing are 0.
GapBounds bounds_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge, const GapQuestion& question);

/// The distance between the hull in the middle of the rectangle and an edge, mm.
double distance_to_edge(const MovingHull& hull, const EdgeTree::Edge& edge);

/// Lower bounds of the distance between the hull in the middle of the rectangle and boxes, mm.
class BoxDistance {
 public:
  explicit BoxDistance(const MovingHull& hull);
  /// The larger of what the axes and a segment's own normal tell.
  double of(const Box& box) const { return std::max(distance(own_, box), beside(box)); }
  bool is_below(double enough, const Box& box) const {
    return distance(own_, box) < enough && beside(box) < enough;
  }

 private:
  /// A slanting segment: its own normal may separate better than the axes do. Of other hulls 0.
  double beside(const Box& box) const {
    if (!is_segment_) return 0;
    const Point middle = 0.5 * (box.lower + box.upper), extent = 0.5 * (box.upper - box.lower);
    return std::abs(normal_.dot(middle - start_)) - normal_.cwiseAbs().dot(extent);
  }

  Box own_;
  bool is_segment_ = false;
  Point start_ = Point::Zero(), normal_ = Point::Zero();
};
inline double distance_from_box(const MovingHull& hull, const Box& box) { return BoxDistance(hull).of(box); }

}  // namespace kempe
