#pragma once
// A four-bar with a point on its coupler, anywhere on the table.
//
//   A = A0 + a e^{i phi},   |B - A| = b,   |B - B0| = c,   P = A + (p + i q) (B - A) / b

#include <array>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "kinematics/four_bar.hpp"

namespace kempe {

/// Lengths mm, > 0; the assembly mode is FourBar's, seen from A0 towards B0.
struct CouplerFourBar {
  Point crank_pivot = Point::Zero(), rocker_pivot = Point::Zero();  ///< A0 and B0, mm
  double crank = 1, coupler = 1, rocker = 1;                        ///< A0-A, A-B, B0-B
  Point coupler_point = Point::Zero();  ///< P: along A-B from A, and to the left of it, mm
  FourBarBranch branch = FourBarBranch::first;

  double ground() const { return (rocker_pivot - crank_pivot).norm(); }
  /// Its four links without their place; crank angles count from A0-B0.
  FourBar links() const { return {ground(), crank, coupler, rocker, branch}; }

  struct Place {
    Point A, B, P;  ///< mm
  };
  /// Where joints and coupler point are at a crank angle (rad, from the x axis); nothing where the loop does not close.
  std::optional<Place> at(double crank_angle) const;

  /// The smallest transmission angle (rad) between two crank angles; nothing if the loop does not close all the way.
  std::optional<double> least_transmission_angle(double first, double last) const;

  /// The longest of the four links and of the coupler point's distances from A and B, mm.
  double longest() const;
};

/// The link whose angle moves the coupler point as the crank of the first linkage does.
enum class CognateDriver { crank, coupler };

/// One of the two other four-bars of Roberts and Chebyshev that draw the same coupler curve.
struct Cognate {
  CouplerFourBar linkage;
  CognateDriver driver = CognateDriver::crank;
  double offset = 0;  ///< rad: the driver's angle is the first linkage's crank angle and this
};

/// Both cognates, the one on A0 and the third pivot C0 = A0 + k (B0 - A0) first, k = (P - A) / (B - A); then the one on C0 and B0.
/// `crank_angle` is any at which the loop closes: it decides the assembly modes. Nothing where it does not close, or where the
/// coupler point lies on A or B: a cognate then has a link without length.
std::optional<std::array<Cognate, 2>> cognates_of(const CouplerFourBar& linkage, double crank_angle);

/// The motion of a four-bar, by the general planar solver alone.
struct CertifiedPath {
  std::vector<Point> reached;         ///< the coupler point at each angle, mm
  std::vector<double> coupler_angle;  ///< of A-B at each, rad, continuous
};

/// Drives the crank, or the coupler, through the angles given (rad, from the x axis; at least one) and tells where the coupler
/// point is. `start` is the crank angle at the first, for the loop's closing. Every step is certified: nothing where
/// the loop does not close, or the motion is stopped by a dead point or a change point: so what comes back was met in order
/// and on one assembly.
std::optional<CertifiedPath> certified_path(const CouplerFourBar& linkage, CognateDriver driver,
                                            const std::vector<double>& angles, double start);

}  // namespace kempe
