#pragma once
// The masses of a copying linkage as its motion and its weight see them, the balance of a tilted table, and the mass that a hand feels.
//
// Every point of a link stands at of_p p + of_q q seen from the pole. So the potential energy on a tilted table is
// g Re(conj(up) (M_p p + M_q q)) with two complex sums M of masses, and the kinetic energy a quadratic form of p' and q'.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "kinematics/copying_linkage.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// A mass that stands at of_p p + of_q q, seen from V.
struct MassPoint {
  LinkagePoint at;
  double mass = 0;  ///< kg
};

/// What moves with a linkage: its links, of this density (kg/m^3), and masses at pen and tracer (kg).
struct MovingMasses {
  LinkStyle style{};
  double density = 0;
  double pen = 0, tracer = 0;
};

/// Points with the mass, the centre of mass and the moment of inertia of every link and of what tracer and pen carry. A link is its arms,
/// thin rods as heavy as its bars and half a disc at each end; a triangle its three sides and its area; pins weigh nothing. Holes are not
/// taken off.
std::vector<MassPoint> mass_points(const CopyingLinkage& linkage, const MovingMasses& masses);

/// The two sums of masses, kg, seen from the pole: the centre of all mass stands at (of_p p + of_q q) / mass.
struct MassMoments {
  Complex of_p = 0, of_q = 0;
  double mass = 0;
};
MassMoments mass_moments(const CopyingLinkage& linkage, const std::vector<MassPoint>& points);

/// A mass beyond a joint of a link: at `joint` + direction * (p or q) / |p or q| * arm.
struct Counterweight {
  Link link;
  Joint joint;
  Complex
      direction;  ///< of size 1, against the link's side of the parallelogram: p of VA and BCY, q of VB and ACX
  double arm;     ///< mm
  double mass;    ///< kg
};

/// The two counterweights that balance the linkage in every pose, however the table is tilted: one on VA, which turns with p, one on the
/// link at the pole that turns with q. Their arms are as long as VA and VB: mass times arm is what counts of the second, and of the first
/// if the pole is at V. Masses below a millionth of the linkage's are left out as 0.
std::array<Counterweight, 2> counterweights(const CopyingLinkage& linkage, const MassMoments& moments);

/// A spring of zero free length (its force grows from nothing with its length) from `height` above the pole to a point of a bar.
struct BalanceSpring {
  Link link;          ///< VA or VB
  Complex direction;  ///< of the point, against the bar
  double arm;         ///< mm, of the point from the pole
  double height;      ///< mm, uphill of the pole
  double rate;        ///< N/mm
};
/// Two such springs, with arm and height half the bar's length, that balance a table tilted by `tilt` (rad); rate * arm * height is what
/// counts; on a level table the rate is 0. Nothing unless the pole is at V: else no bar that turns with p turns about a fixed point.
std::optional<std::array<BalanceSpring, 2>> balance_springs(const CopyingLinkage& linkage,
                                                            const MassMoments& moments, double tilt);

/// What the hand must push with at the tracer to hold the weight on a table tilted by `tilt` about its x axis, y uphill: N, table frame.
/// Nothing at a dead point.
std::optional<Point> hand_force_of_weight(const CopyingLinkage& linkage, const MassMoments& moments,
                                          const Pose& pose, double tilt);

/// Turning speeds of p and q (rad/s) for each mm/s of the tracer along x and along y, table frame. Nothing at a dead point.
std::optional<Eigen::Matrix2d> turning_by_tracer(const CopyingLinkage& linkage, const Pose& pose);

/// The mass that the hand feels, kg: the symmetric matrix m with kinetic energy v^T m v / 2 at the tracer's velocity v, table frame. Nothing
/// at a dead point.
std::optional<Eigen::Matrix2d> mass_felt(const CopyingLinkage& linkage, const std::vector<MassPoint>& points,
                                         const Pose& pose);

}  // namespace kempe
