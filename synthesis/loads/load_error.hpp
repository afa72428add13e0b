#pragma once
// Load error: how far the pen gives way under a force, in the plane, while pole and tracer are held.
//
// The links are slender elastic beams, the pins rigid unless a compliance is given. The strain energy is a quadratic form in the force:
//   U = sum over the arms of both plates of (across^2 L^3 / 6EI + along^2 L / 2EA)  +  the pull in VA and VB  +  c |f|^2 / 2 of each pin
// and its second derivative C (2x2, symmetric) takes the force to the pen's displacement. With sums T of c |w|^2 and D of c w^2 over its
// terms c dot(w, F)^2 the eigenvalues of C are (T + |D|) / 2 and (T - |D|) / 2: worst and least deflection for each newton.
//
// A bent plate is two arms from its corner; a triangle is taken as the same two arms, which is softer than the plate; a straight plate is one
// beam through its joints in their order, so two arms from the joint in its middle. The figures depend on lengths and opening alone: contours
// over the table are circles about the pole. Derivation, limits of the model: docs/loads.md.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "kinematics/copying_linkage.hpp"
#include "specs/spec.hpp"
#include "synthesis/loads/link_forces.hpp"

namespace kempe {

/// Two bars' lengths, mm.
struct BarLengths {
  double VA, VB;
};

/// How far the pen gives way at one opening, mm, under the force of the profile.
struct LoadErrorAt {
  double worst = 0, least = 0;  ///< over the directions of the force
};

/// A load error with its derivatives by log VA, log VB and the opening.
struct LoadErrorJet {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// mm for each newton; 0: rigid. A, B, C between the two links of the joint, V between VB and what it turns on there, pole of the post in
/// the table (pin_compliance.hpp).
struct PinCompliance {
  double A = 0, B = 0, C = 0, V = 0, pole = 0;
};

/// An arm of a plate: from the joint in the plate's middle to another.
struct PlateArm {
  enum class End { corner, C, tip } end;  ///< corner: A or B; tip: X or Y
  double length;                          ///< as a share of the plate's length from its corner to C
  double cube() const { return length * length * length; }
};
/// Of the forces on a plate at its joints the one at an arm's end.
template <class Force>
const Force& force_at(PlateArm::End end, const Force& corner, const Force& C, const Force& tip) {
  switch (end) {
    case PlateArm::End::corner: return corner;
    case PlateArm::End::C: return C;
    case PlateArm::End::tip: break;
  }
  return tip;
}
/// The arms of ACX or BCY, whose third joint stands at `third` where the corner stands at 0 and C at 1.
std::array<PlateArm, 2> plate_arms(Complex third, bool straight);

/// The load error of all linkages of one ratio, grounding, section and material.
class LoadErrorProfile {
 public:
  LoadErrorProfile(Complex k, Grounding grounding, const LinkStyle& style, const Material& material,
                   double pen_force, const PinCompliance& pins = {});

  /// At an opening, rad.
  LoadErrorAt at(const BarLengths& lengths, double opening) const;
  /// The worst, with exact derivatives (of |D| where it is 0: none); second ones, which cost most, only where `wants_hessian`.
  LoadErrorJet worst(const BarLengths& lengths, double opening, bool wants_hessian = true) const;

  /// How far the pen gives way under this force (N), mm; both in the frame whose x axis is bar VA's direction.
  Complex displacement(const BarLengths& lengths, double opening, Complex force) const;

  /// The largest of LoadErrorAt::worst and the smallest of LoadErrorAt::least over an interval of openings, mm, and the openings at
  /// which, rad.
  struct Range {
    double worst, least, worst_opening, least_opening;
  };
  /// The interval (rad) must not be empty.
  Range over(const BarLengths& lengths, const OpeningInterval& openings) const;
  /// Of these the worst alone, mm, in half the time.
  double worst_over(const BarLengths& lengths, const OpeningInterval& openings) const;

 private:
  /// The sums T and D of the header, mm/N for a force at Y.
  struct Compliance {
    double trace;
    Complex difference;
  };
  Compliance compliance(const BarLengths& lengths, double opening) const;
  double worst_opening(const BarLengths& lengths, const OpeningInterval& openings) const;
  template <class Buckets, class Forces>
  Buckets sums_of(const Forces& forces) const;

  Complex shape_, factor_;
  bool straight_;
  double force_, across_, along_;  ///< N; 1 / 3EI, 1 / EA
  PinCompliance pins_;
  bool has_rigid_pins_;
  bool pole_is_at_V_;
  std::array<PlateArm, 2> arms_ACX_, arms_BCY_;
};

/// Of a spec with load and material.
LoadErrorProfile load_error_profile(const Spec& spec, Complex k, Grounding grounding);

}  // namespace kempe
