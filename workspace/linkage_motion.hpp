#pragma once
// Where the joints are, how fast they move and how far they can get while opening and bearing vary a little.
//
// The opening d and the bearing t of the tracer, seen from the pole, are the map's two angles: within one
// assembly mode they and the tracer's place determine each other. With the pole at the origin a joint stands at
//     z = a p + b q,   p = VA exp(i(f + t)),   q = VB exp(i(g + t)),   f = -arg(chain at bearing 0),   g = f
//     + d,
// with fixed complex a, b. Turning the bearing turns all: dz/dt = i z. By the law of cosines in the chain's
// triangle (sides VA, m = VB/|s| and c, the chain's length)
//     g' = 1/2 + (VA^2 - m^2) / (2 c^2),   f' = g' - 1,   |f''| = |g''| <= |VA^2 - m^2| min(VA, m) / c^3,
//     dz/dd = i (f' a p + g' b q),
//     |d2z/dd2| <= |a| VA (|f''| + f'^2) + |b| VB (|g''| + g'^2).
// Seen from a link along p, with the link's axis at e p/VA, the bearing falls out, and so do f and g: a joint stands at
//     z = conj(e) (a VA + b VB exp(i d)),   |dz/dd| = |d2z/dd2| = |b| VB,
// and from a link along q at conj(e) (a VA exp(-i d) + b VB).
// c is monotone over an assembly mode, so over an interval of d the bounds of f', g' and f'' are those of its
// ends.

#include <array>
#include <vector>

#include "kinematics/copying_linkage.hpp"
#include "kinematics/links.hpp"

namespace kempe {

/// A joint, seen from the pole or another joint, in the middle of a rectangle of openings and bearings.
struct MovingJoint {
  Point at;          ///< mm
  Point by_opening;  ///< d at / d opening, mm/rad; d at / d bearing is `at` turned left by a right angle
  double far;        ///< |at|
  double speed;      ///< |by_opening|
  double rest;   ///< mm: how far the joint may stray from at + by_opening dd + (i at) dt within the rectangle
  double reach;  ///< mm: how far it may stray from `at` within the rectangle
};

/// All six joints; the one that they are seen from is at rest at the origin. Then the other points that the motion was asked to follow.
struct MovingJoints : std::array<MovingJoint, 6> {
  std::vector<MovingJoint> points;
  /// A joint by its number, or number 6 and on one of the points.
  const MovingJoint& of(std::size_t number) const {
    return number < size() ? (*this)[number] : points[number - size()];
  }
};

/// A joint over an interval of openings with the tracer at bearing 0: what does not depend on the bearing.
struct OpeningJoint {
  Complex at, by_opening;
  double far, speed;  ///< as in MovingJoint
  double bowed;       ///< mm: how far the joint may stray from at + by_opening dd
  double reach;       ///< mm: how far it may stray from `at` by the openings alone, whatever the way
};
struct OpeningJoints {
  double half_opening;  ///< rad
  std::array<OpeningJoint, 6> joints;
  std::vector<OpeningJoint> points{};
};

class LinkageMotion {
 public:
  /// Seen from the pole.
  explicit LinkageMotion(const CopyingLinkage& linkage);
  /// Seen from a joint, in a frame that travels with it and keeps its direction: a joint stands there at the difference of the
  /// two places, whose a and b are the differences of theirs. `points` are followed as well.
  LinkageMotion(const CopyingLinkage& linkage, Joint seen_from, const std::vector<LinkagePoint>& points = {});
  /// Seen from a link: in a frame that turns with it, the link's end at the origin and its x axis as axis_at_end() has it.
  LinkageMotion(const CopyingLinkage& linkage, Link seen_from, const std::vector<LinkagePoint>& points = {});
  /// True if seen from a link: nothing depends on the bearing then.
  bool is_seen_from_link() const { return seen_from_link_; }

  /// The joints in the middle of the rectangle opening +- half_opening, bearing +- half_bearing (rad), with
  /// bounds that hold all over it. The rectangle's openings must lie in the assembly mode's interval.
  MovingJoints over(double opening, double half_opening, double bearing, double half_bearing) const {
    return turned_in_frame(over_openings(opening, half_opening), std::polar(1.0, bearing), half_bearing);
  }

  /// The same in two steps, for rectangles that share their openings. `turn` is exp(i bearing).
  OpeningJoints over_openings(double opening, double half_opening) const;
  static MovingJoints turned(const OpeningJoints& joints, Complex turn, double half_bearing);
  MovingJoints turned_in_frame(const OpeningJoints& joints, Complex turn, double half_bearing) const {
    return seen_from_link_ ? turned(joints, 1, 0) : turned(joints, turn, half_bearing);
  }

  /// An upper bound of the distance of a joint from where it is seen over all openings of the assembly mode, mm.
  double farthest(Joint joint) const { return farthest(static_cast<std::size_t>(joint)); }
  /// The same of joint or point by its number, as MovingJoints::of() counts.
  double farthest(std::size_t number) const {
    const Place& place = number < places_.size() ? places_[number] : points_[number - places_.size()];
    return place.p_size + place.q_size;
  }

 private:
  /// A joint's or a point's place is a p + b q.
  struct Place {
    Complex a, b;
    double p_size, q_size;  ///< |a p| and |b q|, mm
  };
  Place place_of(Complex a, Complex b) const { return {a, b, std::abs(a) * VA_, std::abs(b) * VB_}; }
  OpeningJoints over_openings_from_link(double opening, double half_opening) const;

  double VA_, VB_, chain_end_;  // chain_end_ is m = VB / |s|
  Complex per_shape_, tracer_per_chain_;
  std::array<Place, 6> places_;
  std::vector<Place> points_;
  bool seen_from_link_ = false, link_along_p_ = false;
  Complex link_axis_{1, 0};  // as a multiple of the direction of p or q
};

}  // namespace kempe
