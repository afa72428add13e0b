#pragma once
// The gap between two parts of the linkage as a function of log VA, log VB and the opening, with exact
// derivatives.
//
// In the frame with V at the origin and p along x every joint is  z = m p + n q,  p = VA, q = VB e^{id}, with
// complex m, n that only the shape s decides. So  z_u = m p,  z_v = n q,  z_d = i n q  and so on. An axis is
// a point, a segment or a triangle of joints. The nearest features of two axes are two corners, gap = |z1 -
// z2| - needed, or a corner and an edge, gap = +-e x (z1 - z2) / |e| - needed; the same where they overlap,
// as the depth with a minus. Source of the depth: separating axes of convex polygons, whose Minkowski
// difference has the edges of both.

#include <cmath>
#include <vector>

#include "synthesis/problem/smooth_reach.hpp"
#include "workspace/contact/self_contact.hpp"

namespace kempe {

/// A convex piece of a part's axis: 1 joint (pin, post), 2 (a bar or one arm of a bent plate) or 3 (triangle
/// plate).
struct AxisPiece {
  JointHull hull{};
  double half_width = 0;  ///< mm
};

/// Two pieces that must keep their distance.
struct GapTerm {
  AxisPiece first{}, second{};
  double needed() const { return first.half_width + second.half_width; }  ///< mm, between the axes
};

/// Every pair of pieces of every pair of parts that may meet.
std::vector<GapTerm> gap_terms(const CopyingLinkage& linkage, const LayerAssignment& layers,
                               const LinkStyle& style);

/// The joints at an opening, V at the origin and p along x.
class JointFrame {
 public:
  JointFrame(Complex shape, double VA, double VB, double opening)
      : JointFrame(shape, VA, std::polar(VB, opening)) {}
  /// `q`: from V to B, mm.
  JointFrame(Complex shape, double VA, Complex q);
  JointFrame(Complex shape, const LogLengths& lengths, double opening)
      : JointFrame(shape, std::exp(lengths.u), std::exp(lengths.v), opening) {}
  Complex operator[](Joint joint) const { return at_[static_cast<std::size_t>(joint)]; }
  /// The part of a joint's place that grows with VA (m p) and with VB (n q).
  Complex of_p(Joint joint) const { return of_p_[static_cast<std::size_t>(joint)]; }
  Complex of_q(Joint joint) const { return of_q_[static_cast<std::size_t>(joint)]; }

 private:
  std::array<Complex, 6> of_p_, of_q_, at_;
};

/// Signed gap, mm: distance less the half widths; negative depth where the axes cross. Where it is larger than `enough`, anything larger.
double gap_value(const GapTerm& term, const JointFrame& frame, double enough = infinity);
/// The same with derivatives.
LinkageJet gap_jet(const GapTerm& term, const JointFrame& frame);

}  // namespace kempe
