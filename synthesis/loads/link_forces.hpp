#pragma once
// Forces in a copying linkage that is held at pole and tracer and pushed at its pen, in closed form.
//
// With V at 0 and the frame turned so that bar VA points along x, p = VA and q = VB e^{i d}:
//   F_X = -conj(s) F_Y,  F_V = (conj(s) - 1) F_Y      from Y' = s X' by virtual work, for every grounding
//   hand -conj(k) F_pen,  pole (conj(k) - 1) F_pen    the same everywhere in the workspace
//   VA and VB are two-force bars; each plate is pushed at its three joints. No length matters, only the opening d.
//
// A force is a complex number, its components along and across an axis are Re(conj(w) F) = dot(w, F) with a complex w for each: so w is
// what this page gives, with its derivatives by the opening. Derivation: docs/loads.md.

#include <array>

#include "kinematics/grounding.hpp"

namespace kempe {

/// A complex function of the opening with its first and second derivative.
struct OpeningJet {
  Complex value = 0, first = 0, second = 0;
};
OpeningJet operator*(Complex factor, const OpeningJet& jet);
OpeningJet operator*(const OpeningJet& one, const OpeningJet& other);
OpeningJet operator+(const OpeningJet& one, const OpeningJet& other);
OpeningJet operator-(const OpeningJet& one, const OpeningJet& other);

/// One joint's force on a plate: its component along the plate's arm to that joint (or along the straight plate) is dot(along, F_Y), its
/// component across dot(across, F_Y).
template <class W>
struct ArmForceOf {
  W along, across;
};

/// Forces for a force F_Y of 1 N at Y, all as vectors w (header). They grow without bound towards the change points.
template <class W>
struct LinkForcesOf {
  W bar_VA, bar_VB;              ///< pull in the bars; at pin A and at pin B all of the force
  ArmForceOf<W> A, C_of_ACX, X;  ///< on plate ACX; A only where the plate is straight
  ArmForceOf<W> B, C_of_BCY, Y;  ///< on plate BCY; B only where the plate is straight
  std::array<W, 2> pin_C{};      ///< x and y component of the force between the plates
};
using ArmForce = ArmForceOf<Complex>;
using LinkForces = LinkForcesOf<Complex>;
using LinkForceJets = LinkForcesOf<OpeningJet>;

/// At an opening (rad) that is no change point; with derivatives or without.
LinkForces link_forces(Complex shape, double opening);
LinkForceJets link_force_jets(Complex shape, double opening);

/// F_Y = conj(factor) F_pen: 1, or with the pen at V 1 / (s - 1). A vector w for F_Y is factor * w for the force at the pen.
Complex pen_factor(Complex k, Grounding grounding);

/// Largest length of (dot(x, F), dot(y, F)) over all F of length 1, and the least.
struct ForceRange {
  double most, least;
};
ForceRange force_range(Complex x, Complex y);

/// N for each newton at the pen, worst over the directions: at the pins and at the pole's.
struct PinForces {
  double A = 0, B = 0, C = 0, V = 0, pole = 0;  ///< V: between VB and what it turns on there
  double largest() const;
};
PinForces pin_forces(Complex k, Grounding grounding, double opening);
PinForces operator+(const PinForces& one, const PinForces& other);
PinForces operator*(double times, const PinForces& forces);

/// N at the tracer for each newton at the pen.
double hand_force(Complex k);

}  // namespace kempe
