#pragma once
// The copying linkage in closed form: one five-link mechanism, three groundings.
//
//   p = A - V,  q = B - V,  C = V + p + q         the parallelogram V-A-C-B
//   X = A + q/s,  Y = B + s p                     the plates A-C-X and B-C-Y, both given by the shape s
//   Y - V = s (X - V)                             so V, X, Y are corners of a triangle similar to (0, 1, s)
//
// One of V, X, Y is the pole, one carries the tracer, one the pen:  pen - pole = k (tracer - pole).
// Everything inside the mechanism depends only on the opening d = arg q - arg p.

#include <algorithm>
#include <array>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/point.hpp"
#include "kempe/mechanism.hpp"
#include "kinematics/assembly_mode.hpp"
#include "kinematics/grounding.hpp"
#include "kinematics/opening_interval.hpp"

namespace kempe {

/// A point of the linkage, which seen from V stands at of_p p + of_q q.
struct LinkagePoint {
  Complex of_p, of_q;
};

/// A joint as such a point, of a linkage with plates of this shape.
LinkagePoint linkage_point(Joint joint, Complex shape);

/// The lengths of a linkage with plates of this shape, mm.
LinkLengths lengths_of_links(Complex shape, double VA, double VB);

/// By LinkLengths::names: true of the lengths that are multiples of VA, false of those that are multiples of VB.
inline constexpr std::array<bool, 8> is_multiple_of_VA{true, false, false, true, false, false, true, true};

/// Why a ratio or a pair of lengths is no copying linkage.
enum class LinkageFault {
  ratio_not_finite,      ///< k is NaN or infinite
  ratio_zero,            ///< k = 0 copies everything onto the pole
  ratio_one,             ///< k = 1 without rotation: the linkage degenerates (the pole lies at infinity)
  length_not_positive,   ///< VA or VB is not a positive finite number
  no_such_assembly_mode  ///< assembly_modes(s) has none of this number
};
std::string_view name(LinkageFault fault);

/// Nearer than this to a dead point or a change point nothing counts as usable, rad, whatever limit is asked for: a
/// thousandth of a degree. Searched, mapped and verified designs keep it alike.
inline constexpr double least_usable_angle = pi / 180000;

/// A copying linkage of given ratio, grounding, lengths, assembly mode and pole.
///
/// Invariant: k is finite and neither 0 nor 1, VA and VB are positive and finite, the assembly mode exists.
/// A value: copyable and comparable. All lengths mm, angles rad, points in the table's frame.
///
/// Guarantees, for every pose it returns:
///  1. pen - pole = k (tracer - pole);
///  2. every link has its length;
///  3. the opening lies in assembly_mode().openings: poses of one linkage never differ in assembly.
class CopyingLinkage {
 public:
  static tl::expected<CopyingLinkage, LinkageFault> make(Complex k, Grounding grounding, double VA, double VB,
                                                         int assembly_mode,
                                                         const Point& pole = Point::Zero());

  Complex k() const { return k_; }
  Grounding grounding() const { return grounding_; }
  Complex shape() const { return s_; }
  double VA() const { return VA_; }
  double VB() const { return VB_; }

  /// The one it never leaves: its openings, and how the loops lie.
  const AssemblyMode& assembly_mode() const { return assembly_mode_; }
  const Point& pole() const { return pole_; }

  Joint pole_joint() const { return roles_of(grounding_).pole; }
  Joint tracer_joint() const { return roles_of(grounding_).tracer; }
  Joint pen_joint() const { return roles_of(grounding_).pen; }

  LinkLengths lengths() const { return lengths_of_links(s_, VA_, VB_); }

  /// Sum over the four moving links of half the perimeter of the hull of their joints, mm. Linear in VA and VB.
  double size() const;

  /// The openings at which the transmission angle is at least `transmission` (rad, >= 0) and least_usable_angle;
  /// perhaps empty.
  OpeningInterval openings_with_transmission(double transmission) const {
    return shrink(assembly_mode_.openings, std::max(transmission, least_usable_angle));
  }

  /// mu = min(asin|sin(d - arg s)|, asin|sin d|): how far the linkage stands from its nearest dead or change point.
  double transmission_angle(double opening) const;

  /// Distance pole to tracer at an opening, mm: c |p + q/s|, monotone over the assembly mode interval.
  double radius_at(double opening) const;

  /// d radius / d opening, mm/rad; 0 at a serial dead point.
  double radius_slope_at(double opening) const;

  /// True if the radius grows with the opening over the assembly mode interval.
  bool radius_grows_with_opening() const;

  /// The opening at which the tracer is `radius` (mm) from the pole, within the closure of the assembly mode interval.
  tl::expected<double, Unreachable> opening_at(double radius) const;

  /// Smallest and largest distance pole to tracer over an interval of openings, mm.
  struct RadiusRange {
    double lower, upper;
  };
  RadiusRange radii_over(const OpeningInterval& openings) const;

  /// The pose whose tracer stands at `tracer`.
  tl::expected<Pose, Unreachable> pose_with_tracer_at(const Point& tracer) const;

  /// The pose at an opening with the tracer in direction `bearing` (rad) from the pole. Defined for any opening.
  Pose pose_at(double opening, double bearing) const;

  /// The tracer's place at an opening and bearing.
  Point tracer_at(double opening, double bearing) const;

  /// Velocities of the six points while the tracer moves with `tracer_velocity`, at a pose of this linkage.
  /// Nothing comes back at a serial dead point, where the tracer cannot be driven radially.
  tl::expected<Pose, Unreachable> velocities(const Pose& pose, const Point& tracer_velocity) const;

  /// Accelerations of the six points for the tracer's velocity and acceleration; nothing at a serial dead point.
  tl::expected<Pose, Unreachable> accelerations(const Pose& pose, const Point& tracer_velocity,
                                                const Point& tracer_acceleration) const;

  bool operator==(const CopyingLinkage&) const = default;

 private:
  CopyingLinkage(Complex k, Grounding grounding, double VA, double VB, const AssemblyMode& assembly_mode,
                 const Point& pole);

  Pose pose_from_vectors(Complex p, Complex q) const;

  Complex k_;
  Grounding grounding_;
  double VA_, VB_;
  AssemblyMode assembly_mode_;
  Point pole_;
  Complex s_;
};

}  // namespace kempe
