#pragma once
// The inner nouns of the proven bound: a box of designs, and what interval arithmetic can say about all of
// them at once.
//
//   a = VA, b = VB/|s|, psi = d - arg s:  (c r)^2 = a^2 + b^2 + 2 a b cos psi
//   coordinates of a box: t = b/a, w = 2 a b, and the pole's place. With H(t) = (t + 1/t)/2:
//   (c r)^2 = w (H + cos psi),  a = sqrt(w / 2t),  b = sqrt(w t / 2)
//
// Nothing but the few angles is transcendental: +, -, *, / and sqrt rounded outwards and enclosures of sines, cosines and arcs
// (geometry/interval.hpp) are enough.

#include <array>

#include "kinematics/copying_linkage.hpp"

namespace kempe::bounding {

struct Range {
  double lower = 1, upper = 0;
  bool empty() const { return !(lower <= upper); }
};

/// What a grounding and an assembly mode fix for the bound.
struct ModeFacts {
  Grounding grounding = Grounding::pole;
  AssemblyMode assembly_mode;
  Complex s;
  double chain = 1;  ///< c: distance V-X per distance pole-tracer
  double bend = 1;   ///< sign of psi
  /// |psi| at the dead or change points, rounded outwards: 0 <= far_end < near_end <= pi.
  double far_end = 0, near_end = 0;
  Range allowed{0, 0};                    ///< |psi| that the copy error's limit leaves (all: [0, pi])
  double size_per_a = 0, size_per_b = 0;  ///< mm of size for each mm of a and of b
  Range a, b;                             ///< mm, from the limits of the eight lengths

  /// Every opening with a transmission angle of at least `transmission` lies within these |psi|; empty if there is none.
  Range usable(double transmission) const;
};

/// Bounds of a region's distances over all places of the pole in a box, mm.
struct PoleDistances {
  double nearest_at_most = 0;    ///< upper bound of the distance of the nearest place
  double farthest_at_least = 0;  ///< lower bound of that of the farthest
  double ratio_at_least = 1;     ///< lower bound of farthest / nearest
  double squares_at_least = 0;   ///< lower bound of farthest^2 - nearest^2, mm^2
};

/// Two places of the region, which every design has to reach, known to within `rounding` (mm).
struct ReachedPlaces {
  Point near, far;  ///< nearest to a pole and farthest from it: of a box of poles, the one in its middle
  double rounding = 0;
};

/// Lengths: t = b/a and w = 2ab (mm^2).
struct LengthBox {
  Range t, w;
};

/// Shrinks the lengths to those that may reach all distances with a transmission angle of at least
/// `transmission`; false if none can.
bool contract(const ModeFacts& mode, const PoleDistances& distances, double transmission, LengthBox& lengths);

/// No design of the box that reaches the distances is smaller, mm.
double size_at_least(const ModeFacts& mode, const PoleDistances& distances, double transmission,
                     const LengthBox& lengths);

/// Shrinks the lengths to those of designs that are not surely larger than `size` (mm); false if there are none.
bool contract_by_size(const ModeFacts& mode, double size, LengthBox& lengths);

/// No design of the box has a larger transmission angle over the distances, rad; negative if none has any.
double transmission_at_most(const ModeFacts& mode, const PoleDistances& distances, const LengthBox& lengths);

/// The |psi| (rad) that every design of the box passes on its way over the distances; empty if there are none in
/// common.
Range passed_by_all(const ModeFacts& mode, const PoleDistances& distances, const LengthBox& lengths);

/// A point of a part: z = of_a a + of_b b exp(i psi), in the frame with V at the origin and p along x.
struct MaterialPoint {
  Complex of_a, of_b;
};

/// True if at `psi` (|psi|) the two points are nearer than `needed` (mm) in every design of the box.
bool always_nearer(const ModeFacts& mode, const LengthBox& lengths, double psi, const MaterialPoint& first,
                   const MaterialPoint& second, double needed);

/// A circle about the middle of a box of poles that holds the box, mm.
struct PoleDisc {
  Point centre;
  double radius;
};
PoleDisc disc_around(const Range& x, const Range& y);

/// Lower bounds over the poles of a box of |pole - far| / |pole - near| (1 if it may be less) and of |pole -
/// far|^2 - |pole - near|^2, both places known to within `rounding` (mm). Taken at the corners of the box: |pole -
/// far|^2 - q^2 |pole - near|^2 is concave in the pole for q >= 1.
struct Spread {
  double ratio, squares;
};
Spread spread_over(const Point& far, const Point& near, double rounding, const Range& x, const Range& y);

/// Lower bound of the distance of `corner`, known to within `rounding`, from every place of a box, and upper bound; mm.
Range distance_from_box(const Point& corner, double rounding, const Range& x, const Range& y);

}  // namespace kempe::bounding
