#pragma once
// The four-bar linkage as a function generator: the output crank's angle for an input crank's angle.
//
//   a e^{i phi} + b e^{i theta} = d + c e^{i psi}       d ground, a input crank, b coupler, c output crank
//   K1 cos psi - K2 cos phi + K3 = cos(phi - psi)       Freudenstein: K1 = d/a, K2 = d/c,
//                                                       K3 = (a^2 - b^2 + c^2 + d^2) / (2 a c)

#include <optional>
#include <string_view>

#include "geometry/point.hpp"

namespace kempe {

/// Which of the two closings of the loop: the sign of the output crank's side.
enum class FourBarBranch { first, second };

/// How the cranks can turn (Grashof's rule on the lengths).
enum class CrankMotion { crank_rocker, double_crank, rocker_crank, double_rocker, change_point };
std::string_view name(CrankMotion motion);

/// Freudenstein's three coefficients.
struct FreudensteinCoefficients {
  double K1, K2, K3;
};

/// A four-bar with its ground link along the x axis, input pivot at the origin. All lengths > 0, mm.
struct FourBar {
  double ground, input, coupler, output;
  FourBarBranch branch = FourBarBranch::first;

  FreudensteinCoefficients coefficients() const;

  /// The output crank's angle (rad, in (-pi, pi]) for the input crank's; nothing where the loop does not
  /// close.
  std::optional<double> output_angle(double input_angle) const;

  /// Angle between coupler and output crank, folded into [0, pi/2], rad; nothing where the loop does not
  /// close.
  std::optional<double> transmission_angle(double input_angle) const;

  /// The smallest transmission angle between two input angles (rad), exact: it falls or rises with cos of the
  /// input angle. Nothing if the loop does not close all the way.
  std::optional<double> least_transmission_angle(double first, double last) const;

  /// How far the loop is from coming apart at an input angle: (b+c-e)(e-|b-c|)/(b+c)^2 with e the distance
  /// between the moving pivot of the input crank and the fixed pivot of the output crank. Negative where it
  /// does not close.
  double closure_margin(double input_angle) const;

  CrankMotion motion() const;
};

/// The four-bar whose coefficients these are, for a ground length (mm, > 0). A negative K1 or K2 means a
/// crank that points the other way: its length is taken positive and `input_turned` or `output_turned` says
/// that half a turn is to be added to its angle. Nothing if a coefficient is 0, not finite, or the coupler
/// would be imaginary.
struct DirectedFourBar {
  FourBar linkage;
  bool input_turned = false, output_turned = false;
};
std::optional<DirectedFourBar> four_bar_from(const FreudensteinCoefficients& coefficients, double ground);

}  // namespace kempe
